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
    class Source
      include Layout

      # The shapes that give the chart its meaning, the better one first.
      def self.shapes(document)
        regions = Regions.new(document)
        Shape.new(document, regions, Sequences.new(document, regions)).possible
      end

      # shape: :direct or :staged, nil for the better one.
      def initialize(document, walk, shape: nil)
        @document = document
        @parts = Parts.new(document, walk)
        @parts.shape.check
        @shape = shape || @parts.shape.possible.first
        @names = @parts.names
      end

      def emit
        @code = Code.new(@names)
        stepper = (@shape == :direct ? Direct : Staged).new(@parts, @code)
        define_raise
        define_enters
        define_timers
        stepper.define
        define_macrostep(stepper)
        public_lines = Public.new(@parts, @code).lines
        text([banner(@document, 'Code'), '', "#include \"#{@document.name}_chart.h\"", '', delays, run_type,
              stepper.types, @code.lines(public_lines), public_lines])[0..-2]
      end

      private

      def delays
        return [] if @document.timers.empty?

        @document.timers.map do |timer|
          "#define #{@names.delay(timer)} #{timer.threshold_us}U#{timer.limit ? " /* #{timer.limit} */" : ''}"
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
        "#{@names.macro}_RAISED_MAX"
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
          head = "static void #{@names.function("enter_#{field}")}"
          @code.add("enter_#{field}",
                    [call(head, ["#{@names.chart_type} *self", "#{@names.region_type(region)} leaf"], ''), '{',
                     "    self->#{field} = leaf;", "    self->#{field}_inverse = ~(uint32_t)leaf;", '}', ''])
        end
      end

      def define_timers
        @document.timers.each do |timer|
          define_timer('start', timer, true)
          define_timer('stop', timer, false)
        end
      end

      def define_timer(verb, timer, armed)
        field = @names.field(timer.id)
        @code.define('void', "#{verb}_#{field}", ["self->#{field}_us = 0U;", "self->#{field}_is_armed = #{armed};"])
      end

      # The first step, then the rounds that its events and eventless transitions can need; their number is the exact
      # bound over all reachable pairs.
      def define_macrostep(stepper)
        define_settle(stepper)
        step = stepper.call('event')
        rounds = @parts.rounds.zero? ? [] : ["#{@code.invoke('settle')};"] * @parts.rounds
        @code.define('void', 'run_to_completion', [*empty_queue, step, *rounds, *settled])
        define_begin
      end

      def define_begin
        start = @parts.steps.lines(@parts.sequences.start)
        rounds = @parts.rounds_at_start
        return @code.define('void', 'begin', start) if rounds.zero?

        @code.define('void', 'begin', [*empty_queue, *start, *["#{@code.invoke('settle')};"] * rounds, *settled])
      end

      def empty_queue
        @parts.raises? ? ['run->raised = 0U;', 'run->taken = 0U;'] : []
      end

      def settled
        @parts.raises? ? ['chart_require_settled(run->taken, run->raised);'] : []
      end

      def define_settle(stepper)
        return if @parts.rounds.zero?

        rest = stepper.call_at_rest
        dequeue = @parts.raises? ? dequeue_lines(stepper) : []
        return @code.define('void', 'settle', dequeue) if rest.nil?
        return @code.define('void', 'settle', [rest]) if dequeue.empty?

        condition = dequeue.first.sub('if (', 'if ((self->trace.count == count) && ')
        @code.define('void', 'settle', ['const uint32_t count = self->trace.count;', rest, condition, *dequeue.drop(1)])
      end

      def dequeue_lines(stepper)
        step = stepper.call('next')
        event = step.include?('next') ? ["    const #{@names.event_type} next = run->events[run->taken];", ''] : []
        ['if (run->taken < run->raised) {', *event, '    run->taken++;', "    #{step}", '}']
      end
    end
  end
end
