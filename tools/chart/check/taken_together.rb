# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../refusal'

module Chart
  # A transition of a parallel, or of a state around one, is selected by each region that has none of its own for the
  # event. Without target it conflicts with nothing, so it is taken beside the inner ones of other regions, before or
  # after them, as the leaves stand. Then its content and theirs must not depend on the order.
  class TakenTogether
    def initialize(document)
      @document = document
    end

    def check
      @document.transitions.permutation(2) do |outer, inner|
        next unless together?(outer, inner) && [outer, inner].all? { |one| ordered?(one) }

        raise Refusal.new(@document.file, inner.line, 31,
                          "#{inner.id} and #{outer.id} may be taken together, in either order; " \
                          'keep raise, assign, send and cancel in one of them')
      end
    end

    private

    def together?(outer, inner)
      (outer.targetless? || inner.targetless?) && across_regions?(outer.source, inner.source) &&
        (outer.eventless? ? inner.eventless? : (outer.events & inner.events).any?)
    end

    # A parallel lies between, or is the outer state itself.
    def across_regions?(outer, inner)
      inner.inside?(outer) && inner.ancestors.take_while { |state| state != outer.parent }.any?(&:parallel?)
    end

    # Actions are a set; all other content is a sequence.
    def ordered?(transition)
      transition.content.any? { |step| !step.is_a?(Act) }
    end
  end
end
