# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'yaml'
require_relative 'scenario'

module Conformance
  # The cases of cases/: NAME.scxml is the chart, NAME.yml what is done to it and what must come of it.
  #
  # A step is one of
  #   event: NAME or number     advance: 5ms (us, ms, s), with times: n for n of them
  #   corrupt: {region: n, value: v}     check: true
  # with: [input ...] names the inputs that are true. What must be seen: in (the active leaves), data, armed (timers),
  # actions (none if not said), sound, and repaired after a check. events: what is sent and the chart does not name.
  # limits: those of a chart of a product. scion: what SCION does otherwise.
  class OwnCases
    FOLDER = File.join(__dir__, 'cases')
    UNITS = { 'us' => 1, 'ms' => 1000, 's' => 1_000_000 }.freeze
    EXPECTED = %w[in data armed actions sound repaired].freeze

    def self.scenarios
      Dir[File.join(FOLDER, '*.scxml')].sort.map { |file| new(file).scenario }
    end

    # file: the chart, beside which its case stands.
    def initialize(file)
      @file = file
      @case = YAML.safe_load_file(file.sub(/scxml\z/, 'yml'))
      @chart = Chart.from(file, @case.fetch('events', []), @case['limits'])
    end

    def scenario
      start = Step.new(kind: :start, inputs: {}, expected: expected(@case['start']))
      Scenario.new(name: "own_#{File.basename(@file, '.scxml')}", file: @file, says: @case['says'], chart: @chart,
                   steps: [start, *@case['steps'].flat_map { |row| steps(row) }], scion: @case['scion'])
    end

    private

    # What is expected holds after the last of equal steps.
    def steps(row)
      kind, value = action(row)
      all = Array.new(row.fetch('times', 1)) do
        Step.new(kind: kind, value: value, inputs: inputs(row), expected: {})
      end
      all.last.expected = kind == :corrupt ? {} : { actions: [] }.merge(expected(row))
      all
    end

    def action(row)
      return [:event, row['event']] if row['event']
      return [:advance, microseconds(row['advance'])] if row['advance']
      return [:corrupt, row['corrupt'].fetch_values('region', 'value')] if row['corrupt']

      [:check, nil]
    end

    def microseconds(text)
      number, unit = text.match(/\A(\d+)(us|ms|s)\z/).captures
      number.to_i * UNITS.fetch(unit)
    end

    def inputs(row)
      @chart.document.inputs.to_h { |input| [input.name, row.fetch('with', []).include?(input.name)] }
    end

    def expected(row)
      row.slice(*EXPECTED).transform_keys(&:to_sym)
    end
  end
end
