# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'fileutils'
require 'open3'
require_relative 'cbmc'

module Proof
  # A function of a harness that looks at every value by itself: it is compiled and run in place of a prover.
  class Exhaustive
    # A harness includes a whole source: what it does not reach is left out.
    COMPILER = %w[gcc -std=c99 -O3 -Wall -Wextra -Werror -ffunction-sections -Wl,--gc-sections].freeze
    LINE = /\A(?<holds>[01]) (?<line>\d+) (?<text>.*)\z/.freeze

    # folder: where the program lies.
    def initialize(file, function, includes:, folder:)
      @file = file
      @function = function
      @program = File.join(folder, function)
      @command = [*COMPILER, *includes.flat_map { |one| ['-I', one] }, file, '-x', 'c', '-', '-o', @program]
    end

    # @satisfies SWR-TOOL-802
    def run
      began = Process.clock_gettime(Process::CLOCK_MONOTONIC)
      FileUtils.mkdir_p(File.dirname(@program))
      text, status = compile
      text, status = Open3.capture2e(*Cbmc::BOUND, *Cbmc::LIMIT, @program) if status.success?
      seconds = Process.clock_gettime(Process::CLOCK_MONOTONIC) - began
      return Cbmc::Answer.new(trouble: trouble(text, status), seconds: seconds) unless status.success?

      Cbmc::Answer.new(properties: text.lines(chomp: true).filter_map { |line| property(line) }, seconds: seconds)
    end

    private

    def compile
      Open3.capture2e(*@command, stdin_data: "void #{@function}(void);\nint main(void)\n{\n    #{@function}();\n    return 0;\n}\n")
    end

    def trouble(text, status)
      status.signaled? ? "ended by signal #{status.termsig}" : text.lines.first(3).join.split.join(' ')
    end

    def property(line)
      found = LINE.match(line)
      found && Cbmc::Property.new(text: found[:text], place: "#{@file}:#{found[:line]}", function: @function, holds: found[:holds] == '1')
    end
  end
end
