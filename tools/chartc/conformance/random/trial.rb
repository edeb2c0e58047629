# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../../lib/check/static_checks'
require_relative '../../lib/read/parser'
require_relative '../../lib/walk/walk'
require_relative 'appendix_d'
require_relative 'program'

module RandomCharts
  Step = Struct.new(:kind, :value, :inputs)

  # One chart with a list of steps, in all shapes that the compiler gives it, against appendix D.
  class Trial
    # So many configurations are walked; a larger chart is refused, and the next seed taken.
    MOST_SNAPSHOTS = 300
    TRACE_LENGTH = 8

    attr_reader :text, :document, :steps, :machines

    # For each of the trials, all in one program, sentences on what is different.
    def self.differences(folder, trials)
      found = Program.new(folder, trials.flat_map(&:machines)).run
      trials.map { |trial| trial.differences(found.shift(trial.machines.length)) }
    end

    # A Refusal when the compiler does not take the chart. steps: what is to be done, or a block that makes the list
    # for a machine that is told the chart.
    def initialize(name, text, steps = nil)
      @text = text
      @document = Chart::Parser.parse("#{name}.scxml", text, {}, mode: :engine, extra_events: [])
      Chart::StaticChecks.run(@document)
      @walk = Chart::Walk.new(@document, MOST_SNAPSHOTS).run
      @steps = steps || yield(AppendixD.new(text), @document.inputs.map(&:name))
      @steps = @steps.select { |step| step.kind != :event || @document.events.include?(step.value) }
      @machines = Chart::C::Source.shapes(@document).map { |shape| Machine.new(@document, @walk, shape, @steps) }
    end

    def expected
      @expected ||= begin
        machine = AppendixD.new(@text)
        @steps.map { |step| take(machine, step) }
      end
    end

    # A sentence on the first difference of each machine; found: what each of them showed.
    def differences(found)
      @machines.zip(found).filter_map { |machine, seen| difference(machine, seen) }
    end

    # The same of an interpreter: a sentence, or nil.
    def difference_of(seen)
      index = seen.each_index.find { |one| sorted(seen[one]) != sorted(expected[one]) }
      "the interpreter: step #{index} shows #{seen[index].inspect}, not #{expected[index].inspect}" if index
    end

    private

    def sorted(seen)
      [seen.leaves, seen.history.sort, seen.data, seen.armed, seen.actions.sort, seen.taken]
    end

    def take(machine, step)
      case step.kind
      when :start then machine.start
      when :event then machine.dispatch(step.value, step.inputs)
      when :advance then machine.advance(step.value, step.inputs)
      end
    end

    def difference(machine, seen)
      index = @steps.each_index.find { |one| shown(seen[one], one) != shown(expected[one], one) }
      return unless index

      what = [@steps[index].kind, *@steps[index].value].join(' ')
      "#{machine.shape}: step #{index} (#{what}) shows #{seen[index].inspect}, not #{expected[index].inspect}"
    end

    # The compiled chart does not tell the actions of its start, and keeps the last transitions only.
    def shown(seen, index)
      return seen unless seen.is_a?(AppendixD::Seen)

      rows = seen.to_h.merge(taken: seen.taken.last(TRACE_LENGTH), history: seen.history.sort)
      index.zero? ? rows.reject { |key, _value| key == :actions } : rows
    end
  end

  # Random steps for a chart, of which most do something.
  class Scenario
    LONG = 40
    TIMES = [500, 1000, 1000, 2000, 3000, 7000].freeze
    TRIES = 4

    def initialize(random)
      @random = random
    end

    def steps(machine, inputs)
      found = [Step.new(:start, nil, {})]
      machine.start
      LONG.times do
        found << step(machine, inputs)
        found.last.kind == :event ? machine.dispatch(*found.last.to_a.drop(1)) : machine.advance(*found.last.to_a.drop(1))
      end
      found
    end

    private

    def step(machine, inputs)
      found = nil
      TRIES.times do
        with = inputs.to_h { |name| [name, @random.rand(2) == 1] }
        events = machine.outside
        return Step.new(:advance, TIMES.sample(random: @random), with) if events.empty? || @random.rand(100) < 12

        found = Step.new(:event, events.sample(random: @random), with)
        break if machine.awaits?(found.value, with)
      end
      found
    end
  end
end
