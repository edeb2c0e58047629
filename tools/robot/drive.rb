# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'limit'

module Robot
  # Drive of an axis: its card and its motor.
  #
  # @satisfies SWR-DRIVE-006
  class Drive
    DUTY = (1..0x7FFFFF)
    # Each type of card that drives: the keys of its words with their ranges, and whether it may go without.
    Card = Struct.new(:words, :is_optional)
    MAGNITUDE = ->(range) { { 'minimum_duty' => range, 'maximum_duty' => range, 'gain_per_s' => (1..200) } }
    CARDS = {
      'pwm' => Card.new(MAGNITUDE.call(DUTY), false),
      'non_pwm' => Card.new(MAGNITUDE.call(DUTY), true),
      'high_frequency' => Card.new({ 'amplitude' => (1..255), 'gain_per_s' => (1..200), 'resonance_hz_per_k' => (0..255) }, false),
      'analog' => Card.new(MAGNITUDE.call(1..0xFFFF), false)
    }.freeze
    # Each type of motor: the cards that drive it. Its abilities stand in its limits (SWR-DRIVE-006).
    MOTORS = {
      'shinsei' => %w[pwm non_pwm high_frequency analog],
      'piezo' => %w[pwm non_pwm high_frequency analog],
      'dti' => %w[pwm non_pwm analog]
    }.freeze
    CHOICES = { 'card' => CARDS.keys, 'motor' => MOTORS.keys }.freeze
    WAVES = %w[slowest_khz fastest_khz speed_curve].freeze
    KEYS = [*CARDS.values.flat_map { |card| card.words.keys }.uniq, *WAVES].freeze
    WORDS_PER_KHZ = 22_009_000 # 2^32 words are 195.15 kHz.
    CURVE_STEPS = 8 # ROBOT_CURVE_STEPS of core/robot/robot.h
    CURVE_FULL = 255 # ROBOT_CURVE_FULL
    SLOWEST_PERCENT = 10 # Percent of full speed, below which motors stick (core/motion/motor_model.c).

    # Values by key; `axis`: the node of the whole axis.
    attr_reader :values

    def initialize(axis, nodes)
      @axis, @nodes = axis, nodes
      @values = CHOICES.to_h { |key, choices| [key, nodes[key].choice(choices)] }
      @words = CARDS.fetch(@values['card'])
      refuse_motor unless MOTORS.fetch(@values['motor']).include?(@values['card'])
      refuse_strays
      read_words
      has_waves? ? read_waves : check_duty
      limits
    end

    private

    def has_waves?
      @values['card'] == 'high_frequency'
    end

    # Limit of a motor of this type.
    def limit(name)
      Limit.of("#{@values['motor']}_#{name}")
    end

    def limits
      @values['reversal_dwell_ms'] = limit('reversal_dwell_ms')
      @values['hottest_dc'] = limit('hottest_dc')
    end

    def refuse_motor
      @nodes['card'].refuse("is #{@values['card']}, which does not drive a #{@values['motor']} motor; expected " \
                            "#{MOTORS[@values['motor']].join(' or ')}")
    end

    def refuse_strays
      allowed = @words.words.keys + (has_waves? ? WAVES : [])
      stray = (KEYS - allowed).find { |key| @nodes.key?(key) }
      @nodes[stray].refuse("does not belong to a #{@values['card']} card; expected none") if stray
    end

    # 0 for all if the card has none.
    def read_words
      is_wanted = !@words.is_optional || @words.words.keys.any? { |key| @nodes.key?(key) }
      KEYS.each { |key| @values[key] = 0 }
      @words.words.each do |key, range|
        @axis.refuse("has no #{key}; expected #{range.begin} to #{range.end}") if !@nodes.key?(key) && is_wanted
        @values[key] = @nodes[key].integer(range) if is_wanted
      end
      @values['speed_curve'] = [0] * CURVE_STEPS
    end

    def check_duty
      minimum, maximum = @values.values_at('minimum_duty', 'maximum_duty')
      return if maximum.zero?

      @nodes['minimum_duty'].refuse("is #{minimum}; expected less than maximum_duty (#{maximum})") if minimum >= maximum
      most = limit('most_duty')
      @nodes['maximum_duty'].refuse("is #{maximum}; expected at most #{most}, the most of a #{@values['motor']} motor") \
        if maximum > most
      least = (maximum * limit('dead_zone_permille') / 1000.0).ceil
      @nodes['minimum_duty'].refuse("is #{minimum}; expected at least #{least}, the dead zone of a " \
                                    "#{@values['motor']} motor") if minimum < least
    end

    # The smaller word is the faster.
    def read_waves
      missing = WAVES.find { |key| !@nodes.key?(key) }
      @axis.refuse("has no #{missing}; expected one, its card is high_frequency") if missing
      @values['minimum_duty'], @values['maximum_duty'] = %w[slowest_khz fastest_khz].map { |key| read_word(key) }
      @nodes['fastest_khz'].refuse('is not below slowest_khz; expected less, a motor is faster nearer to its resonance') \
        if @values['maximum_duty'] >= @values['minimum_duty']
      @values['speed_curve'] = read_curve(@nodes['speed_curve'])
    end

    def read_word(key)
      least = key == 'fastest_khz' ? Limit.of('resonance_word') : Limit.of('wave_fastest_word')
      word = (@nodes[key].decimal(1..1000) * WORDS_PER_KHZ).round
      most = Limit.of('wave_slowest_word')
      return word if word.between?(least, most)

      @nodes[key].refuse("is the word #{word}; expected #{least} to #{most}, #{khz(least)} to #{khz(most)} kHz")
    end

    def khz(word)
      format('%.3f', word.fdiv(WORDS_PER_KHZ)).sub(/\.?0+\z/, '')
    end

    # Percent of full speed at equal steps of the word, from the slowest to the fastest.
    def read_curve(node)
      percents = node.sequence.map { |one| one.decimal(SLOWEST_PERCENT..100) }
      node.refuse("has #{percents.size} speeds; expected #{CURVE_STEPS + 1}") unless percents.size == CURVE_STEPS + 1
      node.refuse("ends with #{percents.last.to_f}; expected 100 percent of full speed") unless percents.last == 100
      shares = percents.map { |percent| (percent * CURVE_FULL / 100).round }
      node.refuse('does not rise from each speed to the next; expected half a percent at least') \
        unless shares.each_cons(2).all? { |one, next_one| next_one > one }
      shares.first(CURVE_STEPS)
    end
  end
end
