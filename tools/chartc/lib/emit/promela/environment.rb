# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'text'

module Chart
  class Promela
    # The process: any event with any inputs, or any of the running timers expire together; then one step, which runs to
    # its end before anything is stored. It is made of several d_steps because one is limited in length.
    class Environment
      # Above four running timers only one or two expire together, as in the walk.
      MOST_TOGETHER = 4

      def initialize(document, names, steps, properties)
        @document = document
        @names = names
        @steps = steps
        @properties = properties
        @begun = names.active(document.root)
        @armed = document.timers.map { |timer| names.armed(timer) }
        @expiring = document.timers.map { |timer| names.expiring(timer) }
      end

      # What the environment chooses, and how far the step is.
      def variables
        @expiring.map { |timer| "bit #{timer}" } +
          ['short stimulus', 'byte inputs', 'byte room', 'short asked', 'bit settled']
      end

      def text
        choices = ["if\n#{(events + expiries).join}fi", *inputs, *step]
        body = "end:\n  do\n  :: atomic {\n#{Text.indent(Text.indent(Text.indent(Text.block(choices))))}\n  }\n  od"
        [begin_step, end_step, "active proctype environment() {\n#{body}\n}\n"].join("\n")
      end

      private

      def events
        outside = @document.events - @document.internal_events
        [Text.option("!#{@begun}", ['stimulus = START'])] +
          outside.map { |event| Text.option(@begun, ["stimulus = #{@names.event(event)}"]) }
      end

      # Each timer in turn may expire; the last one that can must, when none before it did.
      def expiries
        return [] if @armed.empty?

        room = "room = (#{@armed.join(' + ')} > #{MOST_TOGETHER} -> 2 : #{MOST_TOGETHER})"
        each = @armed.each_index.map do |index|
          others = @expiring.first(index) + @armed.drop(index + 1)
          expire = Text.option("#{@armed[index]} && room > 0", ["#{@expiring[index]} = 1", 'room--'])
          "if\n#{expire}#{":: #{Text.any(others)}\n" unless others.empty?}fi"
        end
        [Text.option(Text.any(@armed), ['stimulus = EXPIRY', room, *each])]
      end

      def inputs
        count = @document.inputs.length
        return [] if count.zero?

        others = (1...(1 << count)).map { |bits| Text.option(@begun, ["inputs = #{bits}"]) }
        ["if\n:: inputs = 0\n#{others.join}fi"]
      end

      def step
        round = [d_step(['select_transitions()']), d_step([Text.choose([['asked > 0', microstep]], ['next_event()'])])]
        [d_step(['begin_step()']), Text.repeat('!settled', round), d_step(['end_step()'])]
      end

      # Transitions without a target leave and enter nothing.
      def microstep
        [Text.choose([['moves', ['leave_states()']]]), 'take_transitions()',
         Text.choose([['moves', ['mark_targets()', 'enter_states()']]]), 'end_microstep()']
      end

      def d_step(statements)
        "d_step {\n#{Text.indent(Text.block(statements))}\n}"
      end

      # Timers that expire are taken up one after the other.
      def begin_step
        gathered = @steps.gathered('actions', @document.actions) + @steps.gathered('started', @document.timers)
        Text.inline('begin_step()', 'Of one step, from one stable configuration to the next.',
                    [@steps.print_before, gathered.map { |word| "#{word} = 0" }, 'first = 0', 'last = 0',
                     'event = (stimulus == EXPIRY -> NOTHING : stimulus)', @properties.begun])
      end

      def end_step
        Text.inline('end_step()', 'Its line and its properties.',
                    [@steps.print_after, @properties.asserted,
                     %w[stimulus inputs room settled].map { |name| "#{name} = 0" }])
      end
    end
  end
end
