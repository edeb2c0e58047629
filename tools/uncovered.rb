#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Lists what the tests never reached, from the coverage that the gate unit left.
#
#   ruby tools/uncovered.rb [GCOVR.json]

require 'json'

# One line per line or branch that was not executed.
class Uncovered
  def initialize(report)
    @files = report.fetch('files')
  end

  def lines
    @files.flat_map do |file|
      code = file.fetch('lines').reject { |line| line['gcovr/noncode'] || line['gcovr/excluded'] }
      code.filter_map { |line| what(line)&.then { |text| "#{file['file']}:#{line['line_number']}: #{text}" } }
    end
  end

  private

  def what(line)
    return 'not executed' if line['count'].zero?

    branches = line.fetch('branches')
    missed = branches.count { |branch| branch['count'].zero? }
    "#{missed} of #{branches.size} branches not taken" if missed.positive?
  end
end

if $PROGRAM_NAME == __FILE__
  file = ARGV.fetch(0, 'build/gcov/coverage/coverage.json')
  abort "#{file} is not there; run make gate NAME=unit" unless File.exist?(file)
  lines = Uncovered.new(JSON.parse(File.read(file))).lines
  puts lines
  puts "uncovered: #{lines.size} lines"
end
