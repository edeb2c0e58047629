# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'fileutils'
require_relative 'fault'

module Faults
  # The list of the faults with the checks that reject each.
  class Report
    FILE = File.expand_path('../../../build/conformance/faults.md', __dir__)

    def initialize(results)
      @results = results
    end

    def write
      FileUtils.mkdir_p(File.dirname(FILE))
      File.write(FILE, "#{[about, table].join("\n\n")}\n")
      summary
    end

    private

    def summary
      "faults: #{@results.length} seeded in the emitter, #{@results.count(&:rejected?)} rejected, " \
        "#{@results.count(&:behaves_wrongly?)} of them compile and behave wrongly; see build/conformance/faults.md"
    end

    def about
      "# Faults seeded in the emitter\n\n#{summary}\n\n" \
        'A fault is one edit of the emitter. What the edited emitter writes for the charts named is compared with ' \
        'what the untouched compiler expects of them. "2 of 3" says that a check rejects two of the three versions ' \
        'of C that it looked at (a chart in a shape). MISRA is asked about what all other checks accept.'
    end

    def table
      rows = @results.map do |result|
        fault = result.fault
        [fault.says, "`#{fault.file}`", fault.charts.join(', '), *Trial::CHECKS.map { |check| cell(result, check) },
         result.rejected_by.first || '**nothing**']
      end
      [head, head.map { '---' }, *rows].map { |row| "| #{row.join(' | ')} |" }.join("\n")
    end

    def head
      ['fault', 'in', 'shows on', *Trial::CHECKS, 'first rejected by']
    end

    def cell(result, check)
      asked = result.trials.values.select { |verdicts| verdicts.key?(check) }
      asked.empty? ? '' : "#{asked.count { |verdicts| verdicts[check] }} of #{asked.length}"
    end
  end
end
