# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'json'
require 'open3'
require_relative '../../tools/chartc/chart'

# How much of the generated C of one chart its generated tests reach, by clang's source-based coverage. A decision with
# one condition has no modified condition/decision coverage of its own: its branches are that.
class ChartCoverage
  COMPILER = 'clang-19'
  FLAGS = %w[-fprofile-instr-generate -fcoverage-mapping -fcoverage-mcdc].freeze
  WHAT = { 'lines' => 'lines', 'branches' => 'branches', 'mcdc' => 'MC/DC' }.freeze

  # figures: { 'lines' => [covered, count], ... }; gaps: a sentence for each branch and each condition not shown.
  attr_reader :figures, :gaps

  # code and tests are files; the chart's header stands in the folder charts. A failed test is an error.
  def initialize(code, charts, tests, folder)
    @code = code
    @folder = folder
    @programs = tests.map { |test| GeneratedTest.new(test, charts, folder, compiler: COMPILER).program(code, FLAGS) }
    measured = read
    @figures = WHAT.keys.to_h { |what| [what, measured.fetch('summary').fetch(what).values_at('covered', 'count')] }
    @gaps = branch_gaps(measured.fetch('branches')) + condition_gaps(measured.fetch('mcdc_records'))
  end

  def complete?
    @figures.each_value.all? { |covered, count| covered == count }
  end

  def words
    @figures.map { |what, (covered, count)| "#{WHAT.fetch(what)} #{covered}/#{count}" }.join(', ')
  end

  private

  def read
    profiles = @programs.map { |program| run(program) }
    call('llvm-profdata-19', 'merge', *profiles, '-o', "#{@folder}/all.profdata")
    objects = @programs.flat_map { |program| ['-object', program] }.drop(1)
    json = call('llvm-cov-19', 'export', '-format=text', "-instr-profile=#{@folder}/all.profdata", *objects, @code)
    JSON.parse(json).fetch('data').first.fetch('files').first
  end

  def run(program)
    profile = "#{program}.profraw"
    call({ 'LLVM_PROFILE_FILE' => profile }, program)
    profile
  end

  def call(*command)
    output, errors, status = Open3.capture3(*command)
    raise "#{command.grep(String).first}: #{output.lines.last(20).join}#{errors}" unless status.success?

    output
  end

  # The first six numbers of a branch: where it begins and ends, how often it was true and false.
  def branch_gaps(branches)
    branches.flat_map do |line, column, _end_line, _end_column, yes, no|
      { 'true' => yes, 'false' => no }.select { |_value, times| times.zero? }.keys.map do |value|
        "line #{line}, column #{column} is never #{value}"
      end
    end
  end

  # The last part of a record says of each condition whether it was shown to decide alone.
  def condition_gaps(records)
    records.flat_map do |record|
      record.last.each_with_index.reject(&:first).map do |_shown, index|
        place = "line #{record.first}, column #{record[1]}"
        "#{place}: condition #{index + 1} of #{record.last.length} is not shown to matter"
      end
    end
  end
end
