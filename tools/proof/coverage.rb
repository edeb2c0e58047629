# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'open3'
require 'psych'
require_relative 'harness'

module Proof
  # Each function of the core and of the charts, by [file, name], with its proofs: those of `cbmc`, `wp` and `eva` by which
  # nothing of it is open; otherwise `open`, where Eva has an open alarm, or `unreached`.
  class Coverage
    FILES = '{core,build/gen/charts}/**/*.{c,h,inc}'
    HERE = %r{\A(?:core|build/gen/charts)/}.freeze
    LEFT_OUT = %r{\Acore/robot/\w+/test/}.freeze
    # An alarm of what a function ensures stands there.
    CONTRACTS = 'verification/eva/contracts.h'
    MEASURED = /\t(?<file>[^\t(]+)\(\d+\): (?<name>\w+)\s*\z/.freeze

    # reached: by Eva; with_open: those with an open alarm; both are lists of [file, name].
    def initialize(reached:, with_open:, harnesses: Harness.all, root: '.')
      @reached = reached
      @with_open = with_open
      @harnesses = harnesses
      @root = root
    end

    def states
      unknown = @reached.select { |file, _| file.match?(HERE) } - functions
      raise Refused, "Eva has reached functions that pmccabe does not see: #{unknown.map { |one| one.join(': ') }.join(', ')}" if unknown.any?

      functions.to_h { |function| [function, state(function)] }
    end

    # Functions of which a harness proves something, with their harnesses.
    def by_harness
      @by_harness ||= @harnesses.each_with_object(Hash.new { |hash, key| hash[key] = [] }) do |harness, found|
        harness.functions_proved.each { |name| found[place(name, harness)] << harness }
      end
    end

    private

    def state(function)
      is_reached = @reached.include?(function)
      proofs = by_harness.fetch(function, []).map(&:tool).uniq.sort + [('eva' if is_reached && !open?(function))].compact
      return proofs.join(' ') if proofs.any?

      is_reached ? 'open' : 'unreached'
    end

    def open?(function)
      @with_open.include?(function) || @with_open.include?([CONTRACTS, function[1]])
    end

    # A source of the harness defines it, or the only header that does.
    def place(name, harness)
      all = functions.select { |_, function| function == name }
      own = all.select { |file, _| harness.sources.include?(file) }
      own = all.select { |file, _| file.end_with?('.h') } if own.empty?
      raise Refused, "#{name}, which #{harness.file} proves, is a function of #{own.size} files" unless own.size == 1

      own.first
    end

    def functions
      @functions ||= begin
        files = Dir.glob(FILES, base: @root).grep_v(LEFT_OUT).sort
        said, status = Open3.capture2('pmccabe', *files, chdir: @root)
        raise Refused, 'pmccabe fails' unless status.success?

        said.lines.filter_map { |line| MEASURED.match(line) }.map { |found| [found[:file], found[:name]] }.uniq.sort
      end
    end
  end
end
