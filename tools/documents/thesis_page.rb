#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Looks up what docs/thesis.md names: that each listing, figure, table, mode and test of the thesis has its row, and that
# there is whatever stands in backticks there.
#
#   ruby tools/documents/thesis_page.rb      one line for each that is not so, exit 1 if there is any

require_relative 'project_names'

# The page with its tables of three columns: the part of the thesis, that of Boresight, and the command that shows it, or `-`.
class ThesisPage
  PAGE = 'docs/thesis.md'
  ROBOT_TESTS = %w[CheckForStalls ValidateForwardKinematics RunInverseKinematics IsFootPedalPressed ListMotors GetMotor].freeze
  OWED = [*(1..17).map { |number| "Listing #{number}" }, *(1..38).map { |number| "Figure #{number}" }, 'Table 1', 'Table 2',
          *['Manual', 'Home', 'Trajectory', 'Frequency Sweep', 'Cooperative Biopsy'].map { |mode| "Mode #{mode}" },
          *%w[NeuroRobot ProstateRobot].product(ROBOT_TESTS).map { |names| "Test #{names.join('_')}" },
          *%w[Motor_GetMinTicksGetMaxTicks Encoder_SetPosition Logger_SetLogLevel Packets_Connection].map { |name| "Test #{name}" }].freeze

  def initialize(root, text = File.read(File.join(root, PAGE), encoding: 'UTF-8'), sources: Trace::Sources.new(root))
    @names = ProjectNames.new(root, sources: sources)
    @rows = text.lines.each.with_index(1).filter_map { |line, number| row(line, number) }
    @text = text
  end

  # @satisfies SWR-THESIS-001
  def complaints
    missing + @rows.flat_map { |row| of_row(row) } + unknown
  end

  private

  Row = Struct.new(:line, :cells) do
    def names
      cells.last.scan(/`([^`]+)`/).flatten
    end
  end

  def row(line, number)
    return unless line.start_with?('| ') && !line.match?(/\A\| (---|Thesis )/)

    Row.new(number, line.strip.delete_prefix('|').delete_suffix('|').split('|').map(&:strip))
  end

  # `Figures 18 to 23` and `Figures 1, 2` are as many.
  def reported
    @rows.flat_map do |row|
      kind, numbers = row.cells.first.match(/\A(Figure|Listing|Table)s? ([\d, to]+)/)&.captures
      next row.cells.first[/\A(Mode|Test) [^:]+/] unless kind

      numbers.split(',').flat_map { |part| Range.new(*part.scan(/\d+/).map(&:to_i).minmax).to_a }.map { |number| "#{kind} #{number}" }
    end
  end

  def missing
    reported = self.reported
    OWED.reject { |name| reported.include?(name) }.map { |name| "#{PAGE}: #{name} has no row" } +
      reported.compact.tally.filter_map { |name, count| "#{PAGE}: #{name} has #{count} rows" if count > 1 }
  end

  def of_row(row)
    return [complaint(row.line, 'a row has three cells, and none is empty')] if row.cells.size != 3 || row.cells.any?(&:empty?)
    return [complaint(row.line, 'a command, or - and nothing else')] if row.names.empty? && row.cells.last != '-'

    file = row.names.filter_map { |name| @names.test_file(name[/\Amake one NAME=(\w+)\z/, 1].to_s) }
    tests = file.empty? ? [] : row.names.grep(/\Atest_SWR/).reject { |test| @names.tests_of(file).include?(test) }
    tests.map { |test| complaint(row.line, "#{test} is not in #{file.join(', ')}") }
  end

  def unknown
    @text.lines.each.with_index(1).flat_map do |line, number|
      line.scan(/`([^`]+)`/).flatten.filter_map { |name| complaint(number, "there is no #{name}") unless @names.there?(name) }
    end
  end

  def complaint(line, reason)
    "#{PAGE}:#{line}: #{reason}"
  end
end

if $PROGRAM_NAME == __FILE__
  complaints = ThesisPage.new(File.expand_path('../..', __dir__)).complaints
  puts complaints
  exit complaints.empty?
end
