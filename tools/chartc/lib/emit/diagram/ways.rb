# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../words'

module Chart
  class Diagram
    # Transitions that are drawn as one: they have the same guard, do the same and lead to the same states.
    Way = Struct.new(:transitions, :sources, keyword_init: true) do
      def first
        transitions.first
      end

      def id
        first.id
      end

      def targets
        first.targets
      end

      def events
        transitions.flat_map(&:events).uniq
      end

      def targetless?
        first.targetless?
      end

      # Of a state with states in it, into itself.
      def around?
        source = sources.first
        !source.leaf? && targets.any? { |target| target == source || target.inside?(source) }
      end

      # The state that the box of this way stands in.
      def home
        return sources.first if around?

        ends = sources + targets
        sources.first.ancestors.find { |ancestor| ends.all? { |one| one.inside?(ancestor) } }
      end

      # The one source that a line connects with the box, of many the last one before the target.
      def line_from
        return if around?
        return sources.first if sources.length == 1

        sources.select { |source| source.leaf? && source.order < targets.first.order }.max_by(&:order)
      end

      # Ids of the elements of the drawing: a line inside the state, or a box, the line into it and the arrows that
      # leave it.
      def marks
        return [id] if targetless?

        [id, *("#{id}-from" if line_from), *targets.each_index.map { |index| "#{id}-to-#{index + 1}" }]
      end
    end

    # Finds the ways of a chart.
    class Ways
      # So many sources with the same transition make one way.
      MANY = 3

      def self.of(document)
        new(document).to_a
      end

      def initialize(document)
        @transitions = document.transitions
      end

      def to_a
        of_one_source.group_by { |way| [way.events, *meaning(way.first)] }.values.flat_map { |alike| joined(alike) }
      end

      private

      # Several events of one state that lead to the same.
      def of_one_source
        @transitions.group_by { |transition| [transition.source, *meaning(transition)] }.map do |(source, *_), alike|
          Way.new(transitions: alike, sources: [source])
        end
      end

      def meaning(transition)
        [transition.targets, transition.guard_text, transition.internal, transition.eventless?,
         Words.content(transition.content)]
      end

      def joined(alike)
        return alike if alike.first.targetless?

        around, others = alike.partition(&:around?)
        return alike if others.length < MANY

        around << Way.new(transitions: others.flat_map(&:transitions), sources: others.flat_map(&:sources))
      end
    end
  end
end
