# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'appendix_d'

module RandomCharts
  # All that a chart can come to by appendix D, with every event, every value of the inputs and all timers that may expire
  # together: whether the rule by which the compiler refuses it is one that it breaks.
  class Survey
    # Of those that running shows: an endless macrostep, a timer started twice, a value out of its range.
    RULES = [11, 33, 34].freeze

    def initialize(text)
      @machine = AppendixD.new(text)
      names = @machine.inputs
      @inputs = [false, true].repeated_permutation(names.length).map { |values| names.zip(values).to_h }
    end

    # true or false; nil where there is too much to see.
    def breaks?(rule, most)
      @rule = rule
      @known = {}
      @ahead = []
      return true if broken? { @machine.start }

      while (memory = @ahead.shift)
        return nil if @known.length > most
        return true if steps(memory).any? { |step| broken?(memory, &step) }
      end
      false
    end

    private

    # What a broken step leads to is not looked at.
    def broken?(memory = nil)
      @machine.memory = memory if memory
      yield
      note if @machine.faults.empty?
      @machine.faults.include?(@rule)
    rescue AppendixD::Endless
      @rule == 11
    end

    def note
      memory = @machine.memory
      @ahead << memory unless @known.key?(memory)
      @known[memory] = true
    end

    def steps(memory)
      running = memory.last
      together = (1..running.length).flat_map { |count| running.combination(count).to_a }
      @inputs.flat_map do |with|
        @machine.outside.map { |event| -> { @machine.dispatch(event, with) } } +
          together.map { |ids| -> { @machine.expire(ids, with) } }
      end
    end
  end
end
