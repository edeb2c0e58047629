# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../model'

module Chart
  # One timer for each <send> with a delay: its constant, its limit, and how it becomes whole ticks.
  class Timers
    UNITS = { 'us' => 1, 'ms' => 1000, 's' => 1_000_000 }.freeze
    TIME = /(?<number>\d*\.?\d+)(?<unit>us|ms|s)/.freeze
    PLAIN = /\A#{TIME}\z/.freeze
    QUOTED = /\A(?<quote>['"])#{TIME}\k<quote>\z/.freeze
    ROUNDING = { 'watchdog' => :down, 'hold_off' => :up }.freeze
    # The code counts microseconds in 32 bits, and stops at the last one.
    LONGEST_US = (1 << 32) - 1
    # The limit that holds the period of the control loop.
    TICK_LIMIT = 'cycle_us'

    attr_reader :all, :tick_us

    def initialize(context, chart)
      @context = context
      @of = {}.compare_by_identity
      sends = chart.all.select { |element| Timers.delayed?(element) }
      @tick_us = read_tick(chart, sends.any?)
      sends.each { |element| @of[element] = read(element, @of.length) }
      @all = @of.values
    end

    # A send to the chart itself, without a detour, is a <raise>.
    def self.delayed?(element)
      element.name == 'send' && element.attributes['target'].nil?
    end

    def of(element)
      @of.fetch(element)
    end

    def find(id)
      @all.find { |timer| timer.id == id }
    end

    private

    def read_tick(chart, needed)
      text = chart.attributes['bs:tick']
      return default_tick(chart, needed) unless text

      tick = microseconds(text, chart.line, 'bs:tick')
      nominal = @context.lenient? ? [tick, 1].max : loop_period(chart)
      return tick if tick == nominal

      @context.refuse(chart.line, 15, "the tick is #{tick} us but #{TICK_LIMIT} is #{nominal} us; " \
                                      "write bs:tick=\"#{words(nominal)}\"")
    end

    def loop_period(chart)
      period = @context.limits.fetch(TICK_LIMIT) do
        @context.refuse(chart.line, 15, "no requirement states #{TICK_LIMIT}, which bs:tick must equal; " \
                                        'add the limit')
      end
      lasting(TICK_LIMIT, period, chart.line)
    end

    # No advice leads to what is no time.
    def lasting(limit, microseconds, line)
      return microseconds if microseconds.positive?

      @context.refuse(line, 15, "#{limit} is #{microseconds} us, which is no time; correct the limit")
    end

    def default_tick(chart, needed)
      return UNITS['ms'] if @context.engine?
      return unless needed && !@context.lenient?

      @context.refuse(chart.line, 4, 'a chart with timers needs a tick; add bs:tick="1ms"')
    end

    def read(element, index)
      attributes = element.attributes
      delay = delay(element)
      check_limit(element, delay)
      rounding = rounding(element)
      Timer.new(id: id(element, index),
                event: event(element), delay_us: delay, limit: attributes['bs:limit'], rounding: rounding,
                threshold_us: threshold(element, delay, rounding), line: element.line)
    end

    def id(element, index)
      name = element.attributes.fetch('id') { return @context.unnamed(element, index) }
      @context.name(name, element.line)
    end

    def event(element)
      @context.name(element.attributes['event'], element.line)
    end

    # Only conformance charts have a delayexpr; it must be one quoted time.
    def delay(element)
      text, expression = element.attributes.values_at('delay', 'delayexpr')
      return microseconds(text || '0s', element.line, 'delay') unless expression
      return microseconds(expression, element.line, 'delayexpr', QUOTED) unless text

      @context.refuse(element.line, 3, 'the send has delay and delayexpr; remove one')
    end

    def microseconds(text, line, attribute, pattern = PLAIN)
      time = text.match(pattern)
      found = time && (Rational("0#{time[:number]}") * UNITS.fetch(time[:unit]))
      return found.to_i if found&.denominator == 1

      @context.refuse(line, 15, "#{attribute}=\"#{text}\" is no constant of whole microseconds; " \
                                'write a number of us, ms or s')
    end

    def check_limit(element, delay)
      name = element.attributes['bs:limit']
      return if name.nil? || @context.lenient?

      limit = @context.limits.fetch(name) do
        known = @context.limits.keys.grep(/_us\z/).sort.join(', ')
        @context.refuse(element.line, 15, "limit #{name} is unknown; write one of: #{known}")
      end
      return if delay == lasting(name, limit, element.line)

      @context.refuse(element.line, 15, "the delay is #{delay} us but #{name} is #{limit} us; " \
                                        "write delay=\"#{words(limit)}\"")
    end

    def words(microseconds)
      unit, size = UNITS.to_a.reverse.find { |_unit, one| (microseconds % one).zero? }
      "#{microseconds / size}#{unit}"
    end

    def rounding(element)
      kind = element.attributes['bs:kind']
      return :up if kind.nil? && @context.engine?

      ROUNDING.fetch(kind) do
        return if @context.mode == :difference

        @context.refuse(element.line, 32, 'the timer does not say how it rounds to ticks; write bs:kind="watchdog" ' \
                                          '(down) or bs:kind="hold_off" (up)')
      end
    end

    # A conformance chart may send without delay: that lasts one tick. nil where a compared version does not say.
    def threshold(element, delay, rounding)
      return unless tick_us && rounding

      ticks = rounding == :down ? delay / tick_us : (delay + tick_us - 1) / tick_us
      refuse_endless(element) if ticks * tick_us > LONGEST_US && @context.mode != :difference
      return ticks * tick_us if ticks.positive?
      return tick_us if @context.lenient?

      @context.refuse(element.line, 32, "the delay rounds to no tick; write #{words(tick_us)} at least")
    end

    def refuse_endless(element)
      @context.refuse(element.line, 32, "the timer would never expire; write at most #{LONGEST_US}us, in whole ticks")
    end
  end
end
