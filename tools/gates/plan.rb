# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'gate'

module Gates
  # Which gate runs when. It waits for those that it needs; the longest goes first, as long as there are cores for it. One that
  # mostly waits keeps no core busy: one of these runs beside all that compute. Those that must be alone run one by one after all others.
  #
  # @satisfies SWR-GATE-002
  class Plan
    # seconds: expected duration of each gate, by its name.
    def initialize(cores, seconds)
      @cores = cores
      @seconds = seconds
    end

    # Those that may start beside the running ones; passed: those that have.
    def startable(passed, running, waiting)
      alone, others = waiting.partition(&:alone)
      return running.empty? ? able(alone, passed).first(1) : [] if others.empty?

      fitting(able(others, passed).sort_by { |gate| -@seconds[gate.name] }, running)
    end

    # How long it takes until all are through, if all goes as expected; running: gate => seconds.
    def seconds_left(passed, running, waiting)
      startable(passed, running.keys, waiting).each { |gate| running = running.merge(gate => @seconds[gate.name]) }
      return 0 if running.empty?

      step = running.values.min
      left = running.transform_values { |seconds| seconds - step }
      ended = left.select { |_gate, seconds| seconds.zero? }.keys
      step + seconds_left(passed + ended, left.except(*ended), waiting - running.keys)
    end

    private

    def able(waiting, passed)
      waiting.select { |gate| (gate.needs - passed.map(&:name)).empty? }
    end

    def fitting(gates, running)
      waiters, computing = gates.partition(&:waits)
      waiters = [] if running.any?(&:waits)
      waiters.first(1) + on_free_cores(computing, running.reject(&:waits).sum(&:cores))
    end

    def on_free_cores(gates, busy)
      gates.select do |gate|
        starts = busy < @cores
        busy += gate.cores if starts
        starts
      end
    end
  end
end
