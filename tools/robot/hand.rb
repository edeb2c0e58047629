# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'document'
require_relative 'limit'
require_relative 'vibration'

module Robot
  # How a hand that pushes moves the needle (core/motion/admittance.h).
  #
  # @satisfies SWR-COOP-010
  class Hand
    NONE = { 'dead_zone_mn' => 0, 'gain_q8' => 0, 'speed_ticks_per_s' => 0, 'stop_ticks_per_s2' => 0 }.freeze
    MN_PER_N = 1000
    UM_PER_MM = 1000
    # The gain beyond which the hand and the needle would swing.
    GAIN_MM_PER_S_N = (0.1..(Limit.of('hand_gain_most_um_per_s_n') / UM_PER_MM.to_f))
    DEAD_ZONE_N = ((Limit.of('hand_dead_zone_least_mn') / MN_PER_N.to_f)..2)
    STOP_MM_PER_S2 = (Limit.of('hand_stop_least_mm_per_s2')..1000)
    SLOWEST_MM_PER_S = 0.1
    FASTEST_MM_PER_S = Limit.of('hand_speed_most_mm_per_s')

    # Of hand_law_t, as C writes them.
    attr_reader :values

    # Its answer to a puncture.
    attr_reader :vibration

    # `node`: nil without. `needle`: its Axis; `force`: the Force of its sensor, nil without.
    def initialize(node, needle, force)
      @values = NONE
      @vibration = Vibration.new(nil, needle)
      read(node, needle, force) if node
    end

    private

    def read(node, needle, force)
      node.refuse('is of a robot without a force sensor; expected one') unless force
      force.follow_hand
      nodes = node.mapping(%w[dead_zone_n gain_mm_per_s_n speed_mm_per_s stop_mm_per_s2], %w[vibration])
      @vibration = Vibration.new(nodes['vibration'], needle)
      ticks = needle['ticks_per_unit']
      fastest = [(needle['speed_ticks_per_s'] / ticks).floor(3).to_f, FASTEST_MM_PER_S].min
      gain = nodes['gain_mm_per_s_n'].decimal(GAIN_MM_PER_S_N)
      @values = { 'dead_zone_mn' => (nodes['dead_zone_n'].decimal(DEAD_ZONE_N) * MN_PER_N).round,
                  'gain_q8' => (gain * ticks * 256 / MN_PER_N).round,
                  'speed_ticks_per_s' => (nodes['speed_mm_per_s'].decimal(SLOWEST_MM_PER_S..fastest) * ticks).floor,
                  'stop_ticks_per_s2' => (nodes['stop_mm_per_s2'].decimal(STOP_MM_PER_S2) * ticks).floor }
    end
  end
end
