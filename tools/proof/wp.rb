# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'fileutils'
require 'open3'
require_relative 'cbmc'

module Proof
  # The same as Cbmc by Frama-C's WP and Z3, for products and quotients of unknown numbers: each function is proved against
  # its contract in the harness, calls of others by theirs alone. Of a broken contract some goal is not proved any more; no
  # input is found.
  class Wp
    # Of a goal, counted by the solver and equal on every computer; the dearest goal takes 1.5 million, a second on a free core.
    MOST_STEPS = 2_000_000
    GOAL_SECONDS = 120
    FOLDER = 'build/proof/wp'
    # Ends with the server of Why3, which ends with Frama-C.
    SOLVER = "#!/bin/sh\nexec #{Cbmc::BOUND.join(' ')} z3 \"$@\"\n"
    OPTIONS = %W[-machdep x86_64 -wp -wp-prover z3 -wp-par 1 -wp-steps #{MOST_STEPS}].freeze
    SMOKE = %w[-wp-smoke-tests -wp-smoke-timeout 2].freeze
    GOAL = /^\[wp\] \[(?<verdict>[^\]]+)\] (?<kind>Goal|Smoke-test) (?<name>\w+)(?: : (?<answer>\w+))?/.freeze
    SUMMARY = %r{^\[wp\] (?:Proved goals: +\d+ / \d+|Warning: No goal generated)$}.freeze
    LOCK = Mutex.new

    # Where Frama-C finds its solver: a file of Why3, made once in a run.
    def self.provers
      LOCK.synchronize { (@provers ||= Hash.new { |made, folder| made[folder] = write_provers(folder) })[File.expand_path(FOLDER)] }
    end

    def self.write_provers(folder)
      FileUtils.mkdir_p(folder)
      solver, config = %w[z3 why3.conf].map { |name| File.join(folder, name) }
      FileUtils.rm_f(config)
      File.write(solver, SOLVER)
      File.chmod(0o755, solver)
      Open3.capture2e('why3', 'config', 'add-prover', '-C', config, 'Z3', solver)
      config
    end
    private_class_method :write_provers

    # proof: a function of the harness, which calls the first of what is proved; functions: those whose contracts are proved.
    # broken: the only function that is looked at; seconds: of the solver, most of a goal.
    def initialize(file, proof, functions, includes:, seconds:, broken: nil)
      @command = ['frama-c', *OPTIONS, '-wp-timeout', seconds.to_s, "-cpp-extra-args=#{includes.map { |folder| "-I#{folder}" }.join(' ')}"]
      @file = file
      @proof = proof
      @functions = [proof, *functions]
      @broken = broken
    end

    # The functions, what the harness says of numbers alone, and that the assumptions of the proof contradict nothing: every
    # contract below is asked for what follows from them.
    #
    # @satisfies SWR-TOOL-510
    # @satisfies SWR-TOOL-621
    def run
      began = Process.clock_gettime(Process::CLOCK_MONOTONIC)
      texts = @broken ? [answer('-wp-fct', @broken)] : whole
      seconds = Process.clock_gettime(Process::CLOCK_MONOTONIC) - began
      silent = texts.find { |text| !text.match?(SUMMARY) }
      return Cbmc::Answer.new(trouble: trouble(silent), seconds: seconds) if silent

      Cbmc::Answer.new(properties: texts.flat_map { |text| properties(text) }, seconds: seconds)
    end

    private

    def whole
      [answer('-wp-rte', '-wp-fct', @functions.join(',')), answer('-wp-prop', '@lemma'), answer(*SMOKE, '-wp-fct', @proof)]
    end

    def answer(*options)
      # Frama-C finds its files by what the shell says of where it is.
      environment = { 'WHY3CONFIG' => Wp.provers, 'PWD' => Dir.pwd }
      text, = Open3.capture2e(environment, *Cbmc::BOUND, *Cbmc::LIMIT, *@command, *options, @file)
      text
    end

    def trouble(text)
      said = text.lines.drop_while { |line| !line.match?(/error/i) }.first(3)
      said.empty? ? "no answer within #{Cbmc::MOST_SECONDS} s" : said.join.split.join(' ')
    end

    def properties(text)
      text.lines.filter_map { |line| GOAL.match(line) }.map { |found| property(found) }
    end

    # A smoke test passes when no contradiction is found before its place: something happens there.
    def property(found)
      name = found[:name].delete_prefix('typed_')
      is_smoke = found[:kind] == 'Smoke-test'
      holds = is_smoke ? found[:verdict] != 'Passed' : found[:answer] == 'Valid'
      Cbmc::Property.new(text: is_smoke ? "possible: #{name}" : sentence(name), place: @file, function: function(name), holds: holds)
    end

    def sentence(name)
      id = name[/SWR_[A-Z]+_\d+/]
      return "#{id.tr('_', '-')}: #{name}" if id

      called = name[/_call_(\w+?)(?:_\d+)?_requires/, 1]
      called ? "contract of #{called}: #{name}" : name
    end

    def function(name)
      @functions.select { |one| name.start_with?("#{one}_") }.max_by(&:length)
    end
  end
end
