# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../../flatten/decisions'
require_relative '../../flatten/sequences'
require_relative '../../flatten/shape'
require_relative 'expressions'
require_relative 'names'
require_relative 'selection'
require_relative 'steps'

module Chart
  module C
    # What every part of the emitter needs of one chart.
    class Parts
      RAISING = [Raise, Finish].freeze

      attr_reader :document, :regions, :sequences, :decisions, :names, :expressions, :steps, :selection, :shape,
                  :most_raised, :rounds, :rounds_at_start

      def initialize(document, walk)
        @document = document
        @regions = Regions.new(document)
        @sequences = Sequences.new(document, @regions)
        @decisions = Decisions.new(document, @regions)
        @shape = Shape.new(document, @regions, @sequences)
        @names = Names.new(document, @regions)
        @expressions = Expressions.new(document, @regions, @names)
        @steps = Steps.new(@names, @regions, @expressions)
        @selection = Selection.new(document, @regions, @names, @decisions, @expressions)
        @most_raised = [walk.most_raised, 1].max
        @rounds = walk.most_rounds
        @rounds_at_start = walk.start.rounds
      end

      # The code raises events, whether or not the walk has come that way.
      def raises?
        return @raises if defined?(@raises)
        return @raises = false if document.contents.grep(Raise).empty? && document.states.none? { |one| one.kind == :final }

        steps = document.transitions.flat_map { |one| [sequences.exits(one), one.content, sequences.entries(one)] }
        @raises = Sequences.all(steps.flatten(2) + sequences.start).any? { |step| RAISING.include?(step.class) }
      end

      # A macrostep gathers actions or raised events.
      def run?
        raises? || document.actions.any?
      end

      # Events that content or the end of a final state raises.
      def raised_events
        named = document.contents.grep(Raise).map(&:event)
        document.events.select { |event| named.include?(event) || event.start_with?('done.state.') }
      end

      # Events that the caller may send.
      def outside_events
        document.events - document.internal_events
      end

      # Compound states other than regions, the ones worth asking for by name: the chart is not always in them.
      def compounds
        states = document.states.select { |state| state.kind == :compound } - regions.map(&:state)
        states.reject { |state| always?(state, regions.of(state)) }
      end

      def always?(state, region)
        regions.always_active?(region) && region.leaves == state.leaves
      end

      # "T01 (SWR-...), axis.scxml line 7: power to fault on stalled if ...": what stands above a transition's code.
      def about(transition)
        from = transition.source.id || document.name
        to = transition.targets.empty? ? '' : " to #{transition.targets.map(&:id).join(' ')}"
        on = transition.eventless? ? '' : " on #{transition.events.join(' or ')}"
        guard = transition.guard_text ? " if #{transition.guard_text}" : ''
        req = transition.req.empty? ? '' : " (#{transition.req.join(' ')})"
        "#{transition.id}#{req}, #{document.name}.scxml line #{transition.line}: #{from}#{to}#{on}#{guard}."
      end

      def trace(transition)
        "chart_trace_add(&self->trace, self->now_us, #{transition.number}U);"
      end
    end
  end
end
