# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'document'
require_relative 'limit'

module Robot
  # How the needle vibrates as a feedback to the hand (core/motion/vibration.h): strokes of the least acceleration that the
  # frequency leaves time for, beside the rest before each.
  #
  # @satisfies SWR-VIB-706
  # @satisfies SWR-VIB-751
  class Vibration
    NONE = { 'amplitude_ticks' => 0, 'stroke_cycles' => 0, 'dwell_cycles' => 0, 'periods' => 0 }.freeze
    UM_PER_MM = 1000
    MS_PER_S = 1000
    CYCLE_MS = Limit.of('cycle_us') / 1000
    AMPLITUDE_MM = (0.01..(Limit.of('vibration_most_um') / UM_PER_MM.to_f))
    # The lowest frequency has no longer stroke than there may be.
    FREQUENCY_HZ = ((MS_PER_S / (2.0 * Limit.of('vibration_stroke_cycles') * CYCLE_MS)).ceil..20)
    PERIODS = (1..10)
    LEAST_DEADBANDS = Limit.of('vibration_least_deadbands')
    LONGEST_MS = Limit.of('vibration_longest_ms')

    # The values of the fields of vibration_law_t, as C writes them.
    attr_reader :values

    # `node`: nil without. `needle`: its Axis.
    def initialize(node, needle)
      @values = NONE
      read(node, needle) if node
    end

    private

    def read(node, needle)
      nodes = node.mapping(%w[amplitude_mm frequency_hz periods])
      amplitude = amplitude_ticks(nodes['amplitude_mm'], needle)
      leg = (MS_PER_S / (2 * nodes['frequency_hz'].decimal(FREQUENCY_HZ)) / CYCLE_MS).floor
      stroke = leg - rest_cycles(needle)
      refuse_fast(nodes['frequency_hz'], needle, amplitude, stroke)
      @values = { 'amplitude_ticks' => amplitude, 'stroke_cycles' => stroke, 'dwell_cycles' => leg - stroke,
                  'periods' => periods(nodes['periods'], leg, leg - stroke) }
    end

    # The needle follows its set-point to within the deadband: it would not move for less.
    def amplitude_ticks(node, needle)
      ticks = (node.decimal(AMPLITUDE_MM) * needle['ticks_per_unit']).floor
      least = LEAST_DEADBANDS * needle['deadband_ticks']
      return ticks if ticks >= least

      node.refuse("is #{ticks} ticks beside a deadband of #{needle['deadband_ticks']}; expected #{least} at least")
    end

    # With a rest behind the last stroke.
    def periods(node, leg, rest)
      count = node.integer(PERIODS)
      whole_ms = ((2 * count * leg) + rest) * CYCLE_MS
      return count if whole_ms <= LONGEST_MS

      node.refuse("takes #{whole_ms} ms with its rests; expected #{LONGEST_MS} at most")
    end

    def rest_cycles(needle)
      (needle['reversal_dwell_ms'] + Limit.of('vibration_settle_ms')) / CYCLE_MS
    end

    # In ticks and cycles: a = 4 A / N^2, and at the middle v = 2 A / N.
    def refuse_fast(node, needle, amplitude, stroke)
      per_s = MS_PER_S / CYCLE_MS
      least = Math.sqrt(4.0 * amplitude / needle['acceleration_ticks_per_s2']) * per_s
      least = [least, 2.0 * amplitude / needle['speed_ticks_per_s'] * per_s].max
      return if stroke >= least

      most = per_s / (2.0 * (least.ceil + rest_cycles(needle)))
      node.refuse("leaves a stroke #{stroke} ms of #{least.ceil}; expected #{format('%.2f', most.floor(2))} at most")
    end
  end
end
