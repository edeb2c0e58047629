# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

module Chart
  class Promela
    # What the parsed chart says without running: domains, tracks, what a history remembers.
    class Tree
      attr_reader :document

      def initialize(document)
        @document = document
      end

      # All that can be active, the root first, in document order.
      def states
        @states ||= [@document.root, *@document.states.reject(&:history?)]
      end

      # The state whose inside a transition leaves and enters, nil without target. Where a history leads does not
      # change it, because such a transition starts outside the parent of the history.
      def domain(transition)
        return nil if transition.targetless?

        source = transition.source
        inside = ->(state) { transition.targets.all? { |target| target.inside?(state) } }
        return source if transition.internal && source.kind == :compound && inside.call(source)

        source.ancestors.find { |state| state.compound? && inside.call(state) }
      end

      def domains
        @domains ||= @document.transitions.filter_map { |transition| domain(transition) }.uniq
      end

      # The largest subtrees without a parallel: while its root is active, exactly one leaf of a track is.
      def tracks(state = @document.root)
        return [state] if sequential?(state)

        state.substates.flat_map { |child| tracks(child) }
      end

      def sequential?(state)
        !state.parallel? && state.substates.all? { |child| sequential?(child) }
      end

      # The states of a track from which a transition is looked for: descendants before ancestors.
      def lookup(track)
        innermost_first(track) + track.ancestors
      end

      # The states that a history records one by one.
      def remembered(history)
        history.depth == :deep ? history.parent.leaves : history.parent.substates
      end

      # A state and its ancestors inside a limit, outermost last.
      def path(state, limit)
        [state, *state.ancestors].take_while { |one| one != limit }
      end

      private

      def innermost_first(state)
        state.substates.flat_map { |child| innermost_first(child) } + [state]
      end
    end
  end
end
