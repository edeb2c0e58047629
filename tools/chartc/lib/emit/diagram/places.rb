# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

module Chart
  class Diagram
    # Where arrows begin and end. Graphviz connects nodes only: for a state with states in it, its first leaf stands,
    # and the arrow is cut at the frame.
    class Places
      def initialize(document)
        @document = document
      end

      def state(state)
        quoted(state.id)
      end

      # The dot that a state, or the chart, begins at.
      def start(state)
        quoted("start of #{state.root? ? @document.name : state.id}")
      end

      def box(way)
        quoted("way #{way.id}")
      end

      def notes(state)
        quoted("notes of #{state.id}")
      end

      def cluster(state)
        quoted("cluster_#{state.id}")
      end

      # A node, and the frame that the line is cut at.
      def tail(state)
        [state(leaf(state)), state.leaf? ? nil : cluster(state)]
      end

      # From inside, the way into a state is its start.
      def head(target, sources)
        return [state(target), nil] if target.leaf? || target.history?
        return [start(target), nil] if sources.any? { |source| source == target || source.inside?(target) }

        [state(leaf(target)), cluster(target)]
      end

      private

      def leaf(state)
        state = state.initial&.targets&.first || state.substates.first until state.leaf? || state.history?
        state
      end

      def quoted(text)
        "\"#{text}\""
      end
    end
  end
end
