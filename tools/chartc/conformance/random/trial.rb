# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../../lib/check/static_checks'
require_relative '../../lib/read/parser'
require_relative '../../lib/walk/walk'
require_relative 'appendix_d'
require_relative 'product_generator'
require_relative 'program'

module RandomCharts
  # kind: :start, :event, :advance, or :stray, a number that is no event.
  Step = Struct.new(:kind, :value, :inputs)

  # One chart with a list of steps, in the shape that the compiler gives it, against appendix D.
  class Trial
    # So many configurations are walked; a larger chart is refused, and the next seed taken.
    MOST_SNAPSHOTS = 300
    TRACE_LENGTH = 8

    attr_reader :text, :document, :steps, :machine

    # For each of the trials, all in one program, sentences on what is different.
    def self.differences(folder, trials)
      found = Program.new(folder, trials.map(&:machine)).run
      trials.zip(found).map { |trial, seen| trial.differences(seen) }
    end

    # A Refusal when the compiler does not take the chart. steps: what is to be done, of which events that the chart knows
    # no more are left out, or a block that makes the list for a machine that is given the chart.
    def initialize(name, text, steps = nil)
      @text = text
      @document = read(name)
      Chart::StaticChecks.run(@document)
      @walk = Chart::Walk.new(@document, MOST_SNAPSHOTS).run
      known = steps&.select { |step| step.kind != :event || @document.events.include?(step.value) }
      @steps = known || yield(AppendixD.new(text), @document.inputs.map(&:name))
      @machine = Machine.new(@document, @walk, @steps)
    end

    def expected
      @expected ||= begin
        machine = AppendixD.new(@text)
        @steps.map { |step| take(machine, step) }
      end
    end

    # A sentence on the first difference, if there is one; seen: what the machine showed.
    def differences(seen)
      [difference(seen)].compact
    end

    # The same of an interpreter: a sentence, or nil.
    def difference_of(seen)
      index = seen.each_index.find { |one| sorted(seen[one]) != sorted(expected[one]) }
      "the interpreter: step #{index} shows #{seen[index].inspect}, not #{expected[index].inspect}" if index
    end

    private

    # A chart of a product has its name; the program takes it by that of the trial.
    def read(name)
      product = @text.include?(' bs:safe="')
      found = Chart::Parser.parse("#{product ? 'chart' : name}.scxml", @text, product ? ProductGenerator::LIMITS : {},
                                  mode: product ? :product : :engine)
      found.tap { |one| one.name = name if product }
    end

    def sorted(seen)
      [seen.leaves, seen.history.sort, seen.data, seen.armed, seen.actions.sort, seen.taken]
    end

    def take(machine, step)
      case step.kind
      when :start then machine.start
      when :event then machine.dispatch(step.value, step.inputs)
      when :advance then machine.advance(step.value, step.inputs)
      when :stray then machine.ignore(step.inputs)
      end
    end

    def difference(seen)
      index = @steps.each_index.find { |one| shown(seen[one], one) != shown(expected[one], one) }
      return unless index

      what = [@steps[index].kind, *@steps[index].value].join(' ')
      "#{@machine.shape}: step #{index} (#{what}) shows #{seen[index].inspect}, not #{expected[index].inspect}"
    end

    # The compiled chart does not report the actions of its start, and keeps the last transitions only.
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
    # To the end of long delays, and of what a clock of 32 bits can count.
    LONG_TIMES = [59_990_000, 60_000_000, 4_294_966_000, 4_294_967_295].freeze
    TRIES = 4

    # strays: with numbers that are no event, which compiled charts alone take.
    def initialize(random, strays: true)
      @random = random
      @strays = strays
    end

    def steps(machine, inputs)
      found = [Step.new(:start, nil, {})]
      machine.start
      LONG.times do
        found << step(machine, inputs)
        take(machine, *found.last.to_a)
      end
      found
    end

    private

    def take(machine, kind, value, with)
      case kind
      when :event then machine.dispatch(value, with)
      when :advance then machine.advance(value, with)
      end
    end

    def time
      (@random.rand(100) < 75 ? TIMES : LONG_TIMES).sample(random: @random)
    end

    def step(machine, inputs)
      found = nil
      TRIES.times do
        with = inputs.to_h { |name| [name, @random.rand(2) == 1] }
        events = machine.outside
        return Step.new(:advance, time, with) if events.empty? || @random.rand(100) < 12
        return Step.new(:stray, nil, with) if @strays && @random.rand(100) < 3

        found = Step.new(:event, events.sample(random: @random), with)
        break if machine.awaits?(found.value, with)
      end
      found
    end
  end
end
