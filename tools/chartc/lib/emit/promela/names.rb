# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

module Chart
  class Promela
    # Names and numbers of the model. Prefixes keep them apart and away from the words of Promela and C.
    class Names
      def initialize(document)
        @document = document
        @states = words([document.root, *document.states], &:id)
        @events = words(document.events, &:itself)
        @timers = words(document.timers, &:id)
        @data = words(document.data, &:name)
        @properties = words(document.properties, &:id)
      end

      def active(state)
        "in_#{@states.fetch(state)}"
      end

      # Marks of one microstep: the state is to be entered, everything inside it is to be left.
      def enter(state)
        "enter_#{@states.fetch(state)}"
      end

      def leave(state)
        "leave_#{@states.fetch(state)}"
      end

      def memory(history, state)
        "past_#{@states.fetch(history)}_#{@states.fetch(state)}"
      end

      # The history is to be recalled; it has nothing to recall, so its default content is due.
      def recall(history)
        "recall_#{@states.fetch(history)}"
      end

      def reported(history)
        "told_#{@states.fetch(history)}"
      end

      def event(name)
        "EVENT_#{@events.fetch(name)}"
      end

      def armed(timer)
        "armed_#{@timers.fetch(timer)}"
      end

      def expiring(timer)
        "expiring_#{@timers.fetch(timer)}"
      end

      def data(variable)
        "data_#{@data.fetch(variable)}"
      end

      def input(variable)
        "(inputs >> #{@document.inputs.index(variable)} & 1)"
      end

      def holds(property)
        "holds_#{@properties.fetch(property)}"
      end

      # The event was taken up in this step.
      def seen(event)
        "seen_#{@events.fetch(event)}"
      end

      # Whether the step of a property began where it says.
      def began(property)
        "began_#{@properties.fetch(property)}"
      end

      # An expression of the chart.
      def term(expression)
        kind, left, right, last = expression
        case kind
        when :in then active(@document.state(left))
        when :variable then variable(left)
        when :number then left.to_s
        when :boolean then left.to_s
        when :not then "(!#{term(left)})"
        when :compare then "(#{term(right)} #{left} #{term(last)})"
        else "(#{term(left)} #{OPERATORS.fetch(kind)} #{term(right)})"
        end
      end

      private

      OPERATORS = { and: '&&', or: '||', add: '+', subtract: '-' }.freeze

      def variable(name)
        found = @document.variables.find { |variable| variable.name == name }
        found.kind == :input ? input(found) : data(found)
      end

      def words(owners)
        owners.each_with_object({}) do |owner, found|
          word = (yield(owner) || 'chart').gsub(/\W/, '_')
          word += '_' while found.value?(word)
          found[owner] = word
        end
      end
    end
  end
end
