# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'suite'

module Conformance
  # The result in words: what fits, what passed, what does not fit and by which rule.
  class Report
    FILE = File.expand_path('../../../build/conformance/report.md', __dir__)

    # passed: names of the scenarios that did.
    def initialize(suite, passed)
      @suite = suite
      @framework = suite.framework
      @passed = passed
    end

    def write
      FileUtils.mkdir_p(File.dirname(FILE))
      File.write(FILE, "#{[title, folders, own, refused, notes].join("\n\n")}\n")
      summary
    end

    def summary
      fitting = @framework.scenarios.length
      "conformance: #{fitting} of #{fitting + @framework.refused.length} charts of SCION's test framework fit, " \
        "#{passed(@framework.scenarios)} passed, #{fitting - passed(@framework.scenarios)} failed; " \
        "#{@suite.own.length} own cases, #{passed(@suite.own)} passed; see build/conformance/report.md"
    end

    private

    def title
      "# Conformance of compiled charts\n\n" \
        'Each chart is compiled to C and driven through its scenario. The ' \
        'configuration must be the golden one after each step, and everything else that can be seen must be what the ' \
        'interpreter has.'
    end

    def passed(scenarios)
      scenarios.count { |scenario| @passed.include?(scenario.name) }
    end

    def folders
      rows = all_folders.map do |folder|
        mine = scenarios_of(folder)
        refused = @framework.refused.count { |one| one.folder == folder }
        [folder, mine.length + refused, mine.length, passed(mine), refused]
      end
      "## SCION's test framework\n\n#{summary}\n\n" +
        table(%w[folder charts fit passed refused], rows + [['all', *rows.transpose.drop(1).map(&:sum)]])
    end

    def all_folders
      (@framework.scenarios.map { |one| Framework.folder(one.file) } | @framework.refused.map(&:folder)).sort
    end

    def scenarios_of(folder)
      @framework.scenarios.select { |one| Framework.folder(one.file) == folder }
    end

    def own
      rows = @suite.own.map do |scenario|
        [scenario.name.delete_prefix('own_'), scenario.says, @passed.include?(scenario.name) ? 'passed' : 'FAILED']
      end
      "## Own cases\n\n#{table(%w[case says verdict], rows)}"
    end

    def refused
      parts = @framework.refused.group_by { |one| one.refusal.rule }.sort.map do |rule, all|
        rows = all.map { |one| [one.name, "`#{reason(one.refusal)}`"] }
        "### R#{format('%02d', rule)}: #{::Chart::RULES.fetch(rule)} (#{all.length})\n\n" +
          table(%w[chart reason], rows)
      end
      "## Charts that do not fit, by the rule that refuses them\n\n#{parts.join("\n\n")}"
    end

    # Without place and rule, and without the advice.
    def reason(refusal)
      refusal.message[/CHART-R\d+ (.*?)(?:; (?:write|add|remove|cancel|guard)\b.*)?\z/m, 1][0, 120].gsub('|', '\|')
    end

    def notes
      otherwise = @suite.own.select(&:scion).map { |one| "- `#{one.name.delete_prefix('own_')}`: SCION #{one.scion}." }
      second = Framework::SECOND_GOLDEN.map { |name| "`#{name}`" }.join(', ')
      "## Where SCION does other than the W3C's algorithm\n\n#{otherwise.join("\n")}\n" \
        "- #{second}: a transition from a child of a parallel to itself leaves the parallel; the framework has that " \
        'as its second golden configuration.'
    end

    def table(head, rows)
      [head, head.map { '---' }, *rows].map { |row| "| #{row.join(' | ')} |" }.join("\n")
    end
  end
end
