# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'json'
require_relative 'interpreted'
require_relative 'judge'
require_relative 'scenario'

module Conformance
  # SCION's test framework: charts with the configurations that they must go through. The charts of w3c-ecma are the
  # W3C's own tests; they run by themselves until they rest in "pass".
  class Framework
    FOLDER = File.expand_path('../../../.tools/scion/node_modules/@scion-scxml/test-framework/test', __dir__)
    TICK_US = 1000
    LONGEST_TICKS = 40_000
    SETTLING = 'w3c-ecma'

    # Two charts in which a child of a parallel has a transition to itself. SCION leaves only the child; by the W3C's
    # algorithm the domain of such a transition lies above the parallel, which the framework keeps as the second golden.
    SECOND_GOLDEN = %w[more-parallel/test10 more-parallel/test10b].freeze

    attr_reader :scenarios, :refused

    def initialize
      @scenarios = []
      @refused = []
      files = Dir[File.join(FOLDER, '*/*.scxml')].sort
      raise "no charts in #{FOLDER}; run tools/bootstrap test" if files.empty?

      files.each { |file| read(file) if File.exist?(golden_file(file)) }
    end

    def self.name(file)
      file.delete_prefix("#{FOLDER}/").delete_suffix('.scxml').delete_suffix('.txml')
    end

    def self.folder(file)
      File.basename(File.dirname(file))
    end

    private

    def golden_file(file)
      file.sub(/scxml\z/, 'json')
    end

    def read(file)
      golden = JSON.parse(File.read(golden_file(file)))
      golden = golden.fetch('legacySemantics') if SECOND_GOLDEN.include?(Framework.name(file))
      chart = Chart.from(file, golden['events'].map { |event| event['event']['name'] }.uniq)
      steps = Framework.folder(file) == SETTLING ? settling(chart, golden) : steps(golden)
      name = Framework.name(file).gsub(/\W/, '_')
      @scenarios << Scenario.new(name: name, file: file, says: '', chart: chart, steps: steps)
    rescue ::Chart::Refusal => e
      @refused << Refused.new(Framework.name(file), Framework.folder(file), e)
    end

    def steps(golden)
      start = Step.new(kind: :start, inputs: {}, expected: { in: golden['initialConfiguration'] })
      [start] + golden['events'].flat_map do |event|
        wait = Array.new(event.fetch('after', 0)) { tick }
        wait << Step.new(kind: :event, value: event['event']['name'], inputs: {},
                         expected: { in: event['nextConfiguration'] })
      end
    end

    def tick
      Step.new(kind: :advance, value: TICK_US, inputs: {}, expected: {})
    end

    # As many ticks as the interpreter needs to reach the golden configuration, or to rest without timers.
    def settling(chart, golden)
      wanted = { in: golden['initialConfiguration'] }
      machine = Interpreted.new(chart.document)
      steps = [Step.new(kind: :start, inputs: {}, expected: {})]
      seen = machine.take(steps.first)
      until Judge.shown(seen, wanted).empty? || seen.armed.empty? || steps.length > LONGEST_TICKS
        steps << tick
        seen = machine.take(steps.last)
      end
      steps.last.expected = wanted
      steps
    end
  end
end
