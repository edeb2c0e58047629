# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

module Chart
  class Diagram
    # Lines of DOT for the transitions that lead somewhere. Each way is a box between its source and its targets, so
    # that Graphviz lets nothing overlap its text. States stand in document order from top to bottom: an arrow that
    # leads back is reported to Graphviz from its head to its tail.
    class Arrows
      BOX = 'style=filled color="#e4e9ee" fillcolor="#e4e9ee" margin="0.08,0.04"'

      def initialize(places, labels, ways)
        @places = places
        @labels = labels
        @ways = ways.reject(&:targetless?)
      end

      def boxes_in(state)
        @ways.select { |way| way.home == state }.map do |way|
          "#{@places.box(way)} [#{marked(way, way.id, 'way')} #{BOX} label=#{@labels.way(way)}];"
        end
      end

      # Does something inside the state, or the state itself, lead to the state?
      def back_to?(state)
        @ways.any? do |way|
          way.targets.include?(state) && way.sources.any? { |source| within?(source, state) }
        end
      end

      # Does a line connect the state with one of its siblings before it?
      def hung?(state)
        @ways.any? do |way|
          ends = [way.line_from, *way.targets].compact
          ends.any? { |one| within?(one, state) } &&
            ends.any? { |one| one.order < state.order && one.inside?(state.parent) }
        end
      end

      def lines
        @ways.flat_map { |way| [*line(way), *heads(way)] }
      end

      private

      def within?(one, state)
        one == state || one.inside?(state)
      end

      def line(way)
        return unless way.line_from

        node, cut = @places.tail(way.line_from)
        attributes = "#{marked(way, "#{way.id}-from", 'way line')} arrowhead=none"
        return "#{@places.box(way)} -> #{node} [#{attributes} #{cut && "lhead=#{cut}"}];" if back?(way)

        "#{node} -> #{@places.box(way)} [#{attributes} weight=3 #{cut && "ltail=#{cut}"}];"
      end

      def heads(way)
        way.targets.each_with_index.map do |target, index|
          node, cut = @places.head(target, way.sources)
          attributes = marked(way, "#{way.id}-to-#{index + 1}", 'way line')
          next "#{node} -> #{@places.box(way)} [#{attributes} dir=back #{cut && "ltail=#{cut}"}];" if back?(way)

          "#{@places.box(way)} -> #{node} [#{attributes} weight=#{way.line_from ? 3 : 1} #{cut && "lhead=#{cut}"}];"
        end
      end

      def back?(way)
        from = way.line_from
        from && way.targets.first.order <= from.order
      end

      def marked(way, id, kind)
        "id=\"#{id}\" class=\"#{kind}\" tooltip=\"#{@labels.tooltip(way)}\""
      end
    end
  end
end
