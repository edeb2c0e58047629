# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'text'

module Chart
  class Promela
    # Invariants, step properties and what holds at the start as assertions. A bs:reachable is none: it speaks of
    # paths; nor is a bs:damaged: nothing is damaged here.
    class Properties
      def initialize(document, names, steps)
        @document = document
        @names = names
        @steps = steps
        @checked = document.properties.reject { |property| %i[reachable damaged].include?(property.kind) }
      end

      def marks_used
        @checked.map { |one| @names.holds(one) } + starting.map { |one| @names.began(one) } +
          events.map { |event| @names.seen(event) } + %w[taken moved]
      end

      # Before the step.
      def begun
        ['taken = 0', 'moved = 0', *events.map { |event| "#{@names.seen(event)} = 0" },
         *starting.map { |property| "#{@names.began(property)} = #{@names.term(property.from)}" }]
      end

      # Before transitions are selected: what the step is by, from outside, by a timer, or raised.
      def heard
        events.map { |event| "#{@names.seen(event)} = #{@names.seen(event)} || event == #{@names.event(event)}" }
      end

      # After a microstep.
      def noted
        targeted = @document.transitions.reject(&:targetless?).map { |one| "fate[#{one.number}] == TAKEN" }
        ['taken = taken || event != START', "moved = moved || #{Text.any(targeted)}"]
      end

      # After the step; the mark has a name, so that SPIN's message has it.
      def asserted
        @checked.flat_map do |property|
          ["#{@names.holds(property)} = #{condition(property)}", "assert(#{@names.holds(property)})"]
        end
      end

      private

      def condition(property)
        expression = @names.term(property.expression)
        case property.kind
        when :always then expression
        when :response then "!(#{speaks(property, by(property))}) || #{[expression, *effects(property)].join(' && ')}"
        when :start then "stimulus != START || #{[expression, *effects(property)].join(' && ')}"
        when :only then "!(#{speaks(property, 'taken')} && #{expression}) || #{by(property)}"
        end
      end

      def effects(property)
        started = property.starts.map { |timer| "(#{@steps.holds('started', @document.timers, timer)})" }
        started + (property.does ? did(property.does) : []) + (property.stays ? ['!moved'] : [])
      end

      # These and no others.
      def did(actions)
        @document.actions.map do |action|
          "#{'!' unless actions.include?(action)}(#{@steps.holds('actions', @document.actions, action)})"
        end
      end

      def speaks(property, what)
        ['stimulus != START', what, *(property.from ? [@names.began(property)] : [])].join(' && ')
      end

      def by(property)
        Text.any(property.events.map { |event| @names.seen(event) })
      end

      def starting
        @checked.select(&:from)
      end

      def events
        @checked.flat_map { |property| property.events || [] }.uniq
      end
    end
  end
end
