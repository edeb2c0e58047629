# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'sequences'

module Chart
  # How the regions of a chart may step together.
  #   :direct  each region takes its transition at once, in document order: nothing that one does is seen by another
  #   :staged  select in all regions, resolve conflicts, then all exits, all content, all entries
  class Shape
    def initialize(document, regions, sequences)
      @steps = {}
      @document = document
      @regions = regions
      @sequences = sequences
    end

    # The shorter one, if it gives the chart its meaning.
    # @satisfies SWR-CHART-015
    # @satisfies SWR-CHART-045
    def chosen
      rivals.all? { |first, second| independent?(first, second) } ? :direct : :staged
    end

    # Regions that a transition of an earlier one may have moved when an event comes to them: what they take is to be
    # selected by where they were before.
    def moved_by_others
      @regions.select { |region| heard_with(region).any? { |other| @sequences.reach(other).include?(region) } }
    end

    private

    # Transitions of earlier regions that an event may take which the region waits for too.
    def heard_with(region)
      mine, others = @document.transitions.partition { |one| home(one) == region }
      earlier = others.select { |one| order.fetch(home(one), -1) < order.fetch(region) }
      earlier.select { |one| mine.any? { |own| one_event?(one, own) } }
    end

    def order
      @order ||= @regions.each_with_index.to_h
    end

    # Pairs of transitions of different regions that one event may take together.
    def rivals
      @document.transitions.group_by { |one| home(one) }.values.combination(2).flat_map do |some, others|
        some.product(others).map { |pair| pair.sort_by(&:number) }.select do |first, second|
          one_event?(first, second) && concurrent?(first.source, second.source)
        end
      end
    end

    def home(transition)
      @regions.of(transition.source)
    end

    def one_event?(first, second)
      first.eventless? ? second.eventless? : first.events.intersect?(second.events)
    end

    # Both can be active: one inside the other, or in different regions of one parallel.
    def concurrent?(one, other)
      return true if one.inside?(other) || other.inside?(one)

      [one, *one.ancestors].find { |state| other.inside?(state) }.parallel?
    end

    def independent?(first, second)
      return false if nested?(first, second) || @sequences.reach(first).intersect?(@sequences.reach(second))
      return false if reads?(first, second) || reads?(second, first) || timers(first).intersect?(timers(second))

      [first, second].any? { |one| steps(one).none? { |step| ordered?(step) } } || content_only?(first, second)
    end

    def nested?(first, second)
      first.source.inside?(second.source) || second.source.inside?(first.source)
    end

    # The end of a parallel asks for regions that the other one may move.
    def reads?(first, second)
      asked = steps(first).grep(Finish).flat_map { |step| @regions.children(step.parallel) }
      asked.intersect?(@sequences.reach(second))
    end

    def timers(transition)
      steps(transition).select { |step| step.is_a?(Send) || step.is_a?(Cancel) }.map(&:timer)
    end

    # The order among the contents is kept either way; what exits and entries raise or assign is not.
    def content_only?(first, second)
      [first, second].none? do |one|
        Sequences.all(@sequences.exits(one) + @sequences.entries(one)).any? { |step| ordered?(step) }
      end
    end

    def steps(transition)
      @steps[transition.number] ||=
        Sequences.all(@sequences.exits(transition) + transition.content + @sequences.entries(transition))
    end

    # What another transition of the same moment could see.
    def ordered?(step)
      step.is_a?(Raise) || step.is_a?(Assign) || step.is_a?(Finish)
    end
  end
end
