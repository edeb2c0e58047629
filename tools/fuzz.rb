#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Looks for inputs that break OpenIGTLink or the HTTP server, each target for its share of the time, with a seed of its own each time.
#
#   ruby tools/fuzz.rb FOLDER MINUTES [SEED]
#
# FOLDER/bin holds the targets, FOLDER/seeds their first inputs. Inputs that a target has learned are kept in FOLDER/corpus and
# used again; inputs that break it are kept in FOLDER/found.

require 'fileutils'
require_relative 'fuzz/scenes'

module Fuzz
  # A target and what it looks for.
  class Search
    # Shares of the time.
    SHARES = { 'codec' => 2, 'ports' => 1, 'request' => 1, 'dialect' => 6 }.freeze
    LONGEST = { 'codec' => 8192, 'ports' => 2048, 'request' => 4096, 'dialect' => 512 }.freeze
    WORDS = 'verification/fuzz/words.yml'

    def initialize(folder, seconds, seed)
      @folder = folder
      @seconds = seconds
      @seed = seed
    end

    # True if nothing was found.
    def run
      targets = SHARES.keys.select { |name| File.exist?(program(name)) }
      raise Refused, "there is no target in #{@folder}/bin" if targets.empty?

      all = targets.sum { |name| SHARES[name] }
      targets.map { |name| search(name, (@seconds * SHARES[name] / all).ceil) }.all?
    end

    private

    def program(name)
      File.join(@folder, 'bin', name)
    end

    def search(name, seconds)
      corpus = File.join(@folder, 'corpus', name)
      found = File.join(@folder, 'found')
      FileUtils.mkdir_p([corpus, found])
      before = Dir.children(found)
      puts "fuzz: #{name} for #{seconds} s, seed #{@seed}"
      ended_well = look(name, seconds, corpus, found)
      news = (Dir.children(found) - before).map { |file| File.join(found, file) }
      news.each { |file| report(name, file) }
      puts "fuzz: #{name} ended badly; its log is #{log(name)}" if news.empty? && !ended_well
      news.empty? && ended_well
    end

    def look(name, seconds, corpus, found)
      system(program(name), "-seed=#{@seed}", "-max_total_time=#{seconds}", "-max_len=#{LONGEST[name]}",
             "-artifact_prefix=#{found}/#{name}-", '-print_final_stats=1', corpus, File.join(@folder, 'seeds', name),
             out: log(name), err: %i[child out])
    end

    def log(name)
      File.join(@folder, "#{name}.log")
    end

    # @satisfies SWR-TOOL-017
    def report(name, file)
      puts "fuzz: #{name} found an input, kept as #{file}", *reason(name),
           "      Play it again: #{program(name)} #{file}"
      return unless name == 'dialect' && File.exist?(WORDS)

      puts '      In words:', *Fuzz.show(Words.new(WORDS), File.binread(file).bytes).map { |line| "        #{line}" }
    end

    def reason(name)
      File.read(log(name)).scrub.lines(chomp: true).grep(/does not hold|ERROR:|runtime error|is broken/).first(2)
          .map { |line| "      #{line}" }
    end
  end
end

if $PROGRAM_NAME == __FILE__
  folder, minutes, seed = ARGV
  begin
    abort 'MINUTES must be a number above 0' unless Float(minutes, exception: false)&.positive?
    exit(Fuzz::Search.new(folder, Float(minutes) * 60, Integer(seed || Random.rand(1..(2**31) - 1))).run ? 0 : 1)
  rescue Fuzz::Refused => e
    abort e.message
  end
end
