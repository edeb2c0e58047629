#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Measures the written functions of the product in C with pmccabe: their lines, without the numbers of a table inside, and
# their cyclomatic complexity, each case of a switch counted. app/console/eslint.config.js has the same limits for the console.
#
#   ruby tools/functions.rb [--root FOLDER]     one line for each function beyond a limit, exit 1 if there is any

require 'open3'
require 'optparse'

# Those beyond a limit.
#
# @satisfies SWR-TOOL-074
class Functions
  FILES = '{core,bsp,app,site}/**/*.{c,h,inc}'
  LEFT_OUT = %r{node_modules/|\Acore/robot/\w+/test/}.freeze
  LINES = 60
  COMPLEXITY = 15
  # Rows of a table.
  NUMBERS = /\A[\s{}]*(?:-?(?:0x\h+|\d+)U?[\s{},;]*)+\z/i.freeze
  # A line of pmccabe: complexity with and without the cases of a switch, statements, place, name.
  MEASURED = /\A\d+\t(?<complexity>\d+)\t\d+\t(?<line>\d+)\t(?<lines>\d+)\t(?<file>[^(]+)\(\d+\): (?<name>.+)/.freeze

  # One function.
  Function = Struct.new(:file, :line, :name, :lines, :complexity, keyword_init: true) do
    def problem
      reasons = [("#{lines} lines, at most #{LINES}" if lines > LINES),
                 ("a complexity of #{complexity}, at most #{COMPLEXITY}" if complexity > COMPLEXITY)].compact
      "#{file}:#{line}: #{name} has #{reasons.join(' and ')}" if reasons.any?
    end
  end

  def initialize(root)
    @root = root
  end

  # One line for each function that is too large.
  def problems
    measured.filter_map(&:problem)
  end

  private

  def measured
    files = Dir.glob(FILES, base: @root).grep_v(LEFT_OUT).sort
    said, status = Open3.capture2e('pmccabe', *files, chdir: @root)
    abort "functions: pmccabe fails: #{said}" unless status.success?

    said.scrub.lines.filter_map { |line| MEASURED.match(line) }.map { |found| function(found) }
  end

  def function(found)
    file, line, lines = found[:file], found[:line].to_i, found[:lines].to_i
    Function.new(file: file, line: line, name: found[:name], complexity: found[:complexity].to_i,
                 lines: source(file)[line - 1, lines].grep_v(NUMBERS).size)
  end

  def source(file)
    (@sources ||= {})[file] ||= File.readlines(File.join(@root, file), encoding: 'UTF-8')
  end
end

if $PROGRAM_NAME == __FILE__
  root = File.expand_path('..', __dir__)
  OptionParser.new { |options| options.on('--root FOLDER') { |folder| root = folder } }.parse!
  problems = Functions.new(root).problems
  puts problems
  puts 'The functions are as short and as simple as they must be.' if problems.empty?
  exit(problems.empty? ? 0 : 1)
end
