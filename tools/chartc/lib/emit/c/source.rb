# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../../flatten/shape'
require_relative 'code'
require_relative 'direct'
require_relative 'parts'
require_relative 'public'
require_relative 'staged'
require_relative 'steps'

module Chart
  module C
    # The C of one chart. Only the statement forms of this folder can come out; that is the whole list to review.
    # @satisfies SWR-CHART-004
    # @satisfies SWR-CHART-008
    # @satisfies SWR-CHART-014
    class Source
      include Layout

      # :direct or :staged.
      def self.shape(document)
        regions = Regions.new(document)
        Shape.new(document, regions, Sequences.new(document, regions)).chosen
      end

      def initialize(document, walk)
        @document = document
        @parts = Parts.new(document, walk)
        @names = @parts.names
      end

      def emit
        @code = Code.new(@names)
        stepper = (@parts.shape.chosen == :direct ? Direct : Staged).new(@parts, @code)
        define_raise
        define_enters
        define_timers
        stepper.define
        define_macrostep(stepper)
        public_lines = Public.new(@parts, @code, stepper).lines
        text([banner(@document, 'Code'), '', "#include \"#{@document.name}_chart.h\"", '', delays, run_type,
              stepper.types, @code.lines(public_lines), public_lines])[0..-2]
      end

      private

      def delays
        return [] if @document.timers.empty?

        @document.timers.map do |timer|
          "#define #{@names.delay(timer)} #{timer.threshold_us}U#{remark(timer.limit.to_s)}"
        end + ['']
      end

      # What one macrostep gathers: actions, and raised events that wait.
      def run_type
        return [] unless @parts.run?

        actions = @document.actions.empty? ? [] : ['    uint32_t actions;']
        [bound_macro, 'typedef struct {', actions, queue_fields, "} #{@names.function('run_t')};", '']
      end

      def bound_macro
        return [] unless @parts.raises?

        [comment('The most events that one macrostep raises.'), "#define #{bound} #{@parts.most_raised}U", '']
      end

      def queue_fields
        return [] unless @parts.raises?

        ["    #{@names.event_type} events[#{bound}];", '    uint32_t raised;', '    uint32_t taken;']
      end

      def bound
        @names.raised_max
      end

      def define_raise
        return unless @parts.raises?

        head = "static void #{@names.function('raise_event')}"
        @code.add('raise_event',
                  [call(head, ["#{@names.function('run_t')} *run", "#{@names.event_type} event"], ''), '{',
                   "    run->events[chart_queue_slot(run->raised, #{bound})] = event;", '    run->raised++;', '}', ''])
      end

      def define_enters
        @parts.regions.each do |region|
          field = @names.field(region.name)
          name = "enter.#{@names.stem(region.name)}"
          head = "static void #{@names.function(name)}"
          @code.add(name,
                    [call(head, ["#{@names.chart_type} *self", "#{@names.region_type(region)} leaf"], ''), '{',
                     "    self->#{field} = leaf;", "    self->#{@names.inverse(region)} = ~(uint32_t)leaf;", '}', ''])
        end
      end

      def define_timers
        @document.timers.each do |timer|
          define_timer('start', timer, 1)
          define_timer('stop', timer, 0)
        end
      end

      def define_timer(verb, timer, armed)
        @code.define('void', "#{verb}.#{@names.stem(timer.id)}",
                     ["self->#{@names.time(timer)} = 0U;", "self->#{@names.armed(timer)} = #{armed}U;"])
      end

      # What follows the first step: the rounds that raised events and eventless transitions can need; their number is
      # the exact bound over all reachable pairs. Inlined, since every event comes this way.
      def define_macrostep(stepper)
        define_settle(stepper)
        after = settled(@parts.rounds)
        @code.define('inline void', 'run_to_completion', after) if after.any?
        rounds = @parts.rounds_at_start
        @code.define('void', 'begin', @parts.steps.lines(@parts.sequences.start) + (rounds.zero? ? [] : settled(rounds)))
      end

      def settled(rounds)
        bound = @parts.raises? ? ['chart_require_settled(run->taken, run->raised);'] : []
        rounds.zero? ? bound : ["#{@code.invoke('settle')};"] * rounds + bound
      end

      def define_settle(stepper)
        return if @parts.rounds.zero?

        rest = stepper.step_at_rest
        waits = '(run->taken < run->raised)'
        return @code.define('void', 'settle', rest) unless @parts.raises?
        return @code.define('void', 'settle', dequeue_lines(stepper, waits)) if rest.empty?

        @code.define('void', 'settle', ['const uint32_t count = self->trace.count;', '', *rest,
                                        *dequeue_lines(stepper, "((self->trace.count == count) && #{waits})")])
      end

      def dequeue_lines(stepper, condition)
        step = stepper.step('next', @parts.raised_events)
        event = step.join.match?(/\bnext\b/) ? ["const #{@names.event_type} next = run->events[run->taken];", ''] : []
        ["if #{condition} {", *[*event, 'run->taken++;', *step].map { |line| line.empty? ? '' : "    #{line}" }, '}']
      end
    end
  end
end
