# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'document'
require_relative 'limit'

module Robot
  # A channel of the force sensor: its calibration and filter, in the units of the core.
  class ForceChannel
    CONVERTERS = (1..4)
    COUNTS = (0..4095) # Of a converter of 12 bits; a broken wire reads the first or the last.
    SLOPE = (Rational('0.001')..100)
    OFFSET = (-100_000..100_000)
    CUTOFF_HZ = (1..100)
    FORCE_N = (-100..100)
    CYCLE_HZ = 1000
    Q16 = 2**16
    Q30 = 2**30

    attr_reader :converter, :cutoff_hz

    def initialize(node, unit_mn)
      @nodes = node.mapping(%w[converter slope offset zero_reference cutoff_hz minimum_n maximum_n])
      @converter = @nodes['converter'].integer(CONVERTERS)
      @slope = read_slope * unit_mn
      @offset = @nodes['offset'].decimal(OFFSET) * unit_mn
      @zero = @nodes['zero_reference'].integer(COUNTS)
      @cutoff_hz = @nodes['cutoff_hz'].integer(CUTOFF_HZ)
      @range = %w[minimum_n maximum_n].map { |side| count(side, @nodes[side].decimal(FORCE_N)) }.minmax
      check
    end

    def refuse(key, reason)
      @nodes[key].refuse(reason)
    end

    # The fields of force_channel_config_t.
    def values
      b, a1, a2 = filter
      { 'mn_per_count_q16' => (@slope * Q16).round, 'filter_b_q30' => b, 'filter_a1_q30' => a1, 'filter_a2_q30' => a2,
        'zero_count' => "#{@zero}U", 'minimum_count' => "#{@range.first}U", 'maximum_count' => "#{@range.last}U",
        'step_counts' => "#{counts_of('force_step_mn')}U", 'converter' => "#{@converter - 1}U" }
    end

    private

    def read_slope
      slope = @nodes['slope'].decimal(-SLOPE.end..SLOPE.end)
      return slope if SLOPE.cover?(slope.abs)

      refuse('slope', "is #{@nodes['slope'].word}; expected at least 0.001 from zero")
    end

    # The reading at a force.
    def count(key, newton)
      reading = ((newton * 1000) - @offset) / @slope
      return reading.round if reading > COUNTS.begin && reading < COUNTS.end

      refuse(key, "is a reading of #{reading.round}; expected 1 to #{COUNTS.end - 1}, which the converter shows of a whole wire")
    end

    def check
      least, most = %w[minimum_n maximum_n].map { |side| @nodes[side].decimal(FORCE_N) }
      refuse('minimum_n', "is #{@nodes['minimum_n'].word}; expected less than 0 and than maximum_n") unless least.negative? && least < most
      refuse('maximum_n', "is #{@nodes['maximum_n'].word}; expected more than 0") unless most.positive?
      refuse('zero_reference', "is #{@zero}; expected #{@range.first} to #{@range.last}, the readings from minimum_n to maximum_n") \
        unless @zero.between?(*@range)
    end

    # So many counts a force is; at least one.
    def counts_of(limit)
      [(Limit.of(limit) / @slope.abs).floor, 1].max
    end

    # Butterworth low-pass of second order by the bilinear transform: y = b (x + 2 x1 + x2) - a1 y1 - a2 y2. a2 is rounded so
    # that 4 b = 1 + a1 + a2: a force that stays is shown as it is.
    def filter
      k = Math.tan(Math::PI * @cutoff_hz / CYCLE_HZ)
      norm = 1 + (Math.sqrt(2) * k) + (k * k)
      b = (k * k / norm * Q30).round
      a1 = (2 * ((k * k) - 1) / norm * Q30).round
      [b, a1, (4 * b) - Q30 - a1]
    end
  end

  # The force sensor of a robot: the slot of its card, and its two channels.
  #
  # @satisfies SWR-FORCE-560
  class Force
    CHANNELS = %w[hand needle].freeze # In the order of force_channel_id_t.
    UNIT_MN = (Rational('0.1')..1000)

    def initialize(node, sensor_slots)
      nodes = node.mapping(['slot', 'unit_mn', *CHANNELS])
      @slot = nodes['slot'].integer(0..9)
      nodes['slot'].refuse("is #{@slot}, where no card without an axis is; expected a slot of cards") \
        unless sensor_slots.include?(@slot)
      unit_mn = nodes['unit_mn'].decimal(UNIT_MN)
      @channels = CHANNELS.map { |name| ForceChannel.new(nodes[name], unit_mn) }
      return unless @channels.map(&:converter).uniq.one?

      @channels.last.refuse('converter', "is #{@channels.last.converter}, which #{CHANNELS.first} has; expected another")
    end

    # A filter that delays the force too much makes a hand and the needle swing.
    def follow_hand
      hand = @channels.first
      least = Limit.of('hand_cutoff_least_hz')
      return if hand.cutoff_hz >= least

      hand.refuse('cutoff_hz', "is #{hand.cutoff_hz}; expected at least #{least} where a hand moves the needle")
    end

    # The fields of force_config_t before its seal.
    def values
      { 'is_there' => '1U', 'slot' => "#{@slot}U", 'channels' => @channels.map(&:values) }
    end
  end
end
