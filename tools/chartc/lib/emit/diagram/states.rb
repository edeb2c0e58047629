# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

module Chart
  class Diagram
    # Lines of DOT for the states, nested as they are.
    class States
      FILLS = %w[#f3f5f7 #ffffff].freeze

      def initialize(document, places, labels, arrows)
        @document = document
        @places = places
        @labels = labels
        @arrows = arrows
      end

      def lines
        inside(@document.root)
      end

      private

      def inside(state)
        start(state) + state.children.flat_map { |child| drawn(child) } + @arrows.boxes_in(state) + below(state)
      end

      # States that no line connects with one before them stand below the one before them all the same.
      def below(state)
        return [] if state.parallel?

        state.substates.each_cons(2).reject { |_, child| @arrows.hung?(child) }.map do |before, child|
          "#{@places.state(before.leaves.last)} -> #{@places.state(child.leaves.first)} [style=invis weight=3];"
        end
      end

      # The dot that a state begins at, if that has to be reported, or if something inside leads back to it.
      def start(state)
        return [] unless (state.initial && !obvious?(state.initial)) || @arrows.back_to?(state)

        dot = "#{@places.start(state)} [class=start shape=point width=0.12 fillcolor=\"#52606d\" label=\"\"];"
        [dot, *default(@places.start(state), state)]
      end

      def obvious?(default)
        default.content.empty? && default.targets.all?(&:parallel?)
      end

      def default(tail, state)
        return [] unless state.initial

        state.initial.targets.map do |target|
          node, cut = @places.head(target, [])
          "#{tail} -> #{node} [#{cut && "lhead=#{cut}"} label=#{@labels.default(state.initial)}];"
        end
      end

      def drawn(state)
        return history(state) if state.history?
        return leaf(state) if state.leaf?

        fill = FILLS[state.ancestors.length % 2]
        look = "style=\"#{frame(state)}\" labeljust=l color=\"#52606d\" fillcolor=\"#{fill}\""
        ["subgraph #{@places.cluster(state)} {", "graph [#{identity(state)} #{look} label=#{@labels.frame(state)}];",
         *notes(state), *inside(state), '}']
      end

      def notes(state)
        text = @labels.notes(state)
        return [] unless text

        ["#{@places.notes(state)} [class=notes shape=note margin=\"0.06,0.03\" style=filled color=\"#b8c2cc\" " \
         "label=#{text}];"]
      end

      # Regions of a parallel have a dashed frame.
      def frame(state)
        state.parent.parallel? ? 'rounded,filled,dashed' : 'rounded,filled'
      end

      def leaf(state)
        rings = state.kind == :final ? ' peripheries=2' : ''
        ["#{@places.state(state)} [#{identity(state)}#{rings} label=#{@labels.leaf(state)}];"]
      end

      def history(state)
        text = state.depth == :deep ? 'H*' : 'H'
        ["#{@places.state(state)} [#{identity(state)} shape=circle width=0.32 fixedsize=true label=\"#{text}\"];",
         *default(@places.state(state), state)]
      end

      def identity(state)
        "id=\"#{Diagram.svg_id(@document, state)}\" class=\"state #{state.kind}\""
      end
    end
  end
end
