# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'sequences'

module Chart
  # How the regions of a chart may step together.
  #   :direct  each region takes its transition at once, in document order: nothing that one does is seen by another
  #   :staged  select in all regions, resolve conflicts, then all exits, all content, all entries
  class Shape
    def initialize(document, regions, sequences)
      @document = document
      @regions = regions
      @sequences = sequences
      @together = rivals
    end

    # The shapes that give the chart its meaning, the better one first.
    def possible
      @together.all? { |first, second| independent?(first, second) } ? %i[direct staged] : %i[staged]
    end

    private

    # Pairs of transitions of different regions that one event may take together.
    def rivals
      @document.transitions.combination(2).select do |first, second|
        home(first) != home(second) && together?(first, second)
      end
    end

    def home(transition)
      @regions.of(transition.source)
    end

    def together?(first, second)
      return false unless concurrent?(first.source, second.source)

      first.eventless? ? second.eventless? : (first.events & second.events).any?
    end

    # Both can be active: one inside the other, or in different regions of one parallel.
    def concurrent?(one, other)
      return true if one.inside?(other) || other.inside?(one)

      [one, *one.ancestors].find { |state| other.inside?(state) }.parallel?
    end

    def independent?(first, second)
      return false if nested?(first, second)

      apart = (@sequences.reach(first) & @sequences.reach(second)).empty?
      apart && [first, second].any? { |one| ordered(one).empty? } || (apart && content_only?(first, second))
    end

    def nested?(first, second)
      first.source.inside?(second.source) || second.source.inside?(first.source)
    end

    # The order among the contents is kept either way; what exits and entries raise or assign is not.
    def content_only?(first, second)
      [first, second].none? { |one| ordered?(@sequences.exits(one)) || ordered?(@sequences.entries(one)) }
    end

    def ordered(transition)
      (@sequences.exits(transition) + transition.content + @sequences.entries(transition)).select do |step|
        ordered?([step])
      end
    end

    # Steps that another transition of the same moment could see.
    def ordered?(steps)
      steps.any? do |step|
        case step
        when Raise, Assign, Finish then true
        when Switch then step.cases.any? { |_leaves, inner| ordered?(inner) }
        else false
        end
      end
    end
  end
end
