# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../refusal'
require_relative 'counterexample'

module Chart
  # The refusal of two transitions of one state that are enabled together, with the shortest way there.
  class Overlapping
    def initialize(document, walk)
      @document = document
      @walk = walk
    end

    def refusal(overlap)
      first, second, leaves, inputs = overlap.to_a
      set = inputs.map { |name, value| value ? name : "!#{name}" }
      event = first.eventless? ? 'without event' : "by \"#{(first.events & second.events).first}\""
      Refusal.new(@document.file, second.line, 22,
                  "#{second.id} and #{first.id} are both enabled #{event} in #{[*leaves, *set].join(' ')}, " \
                  "reached by: #{@walk.words(@walk.overlapping)}; add to one guard the negation of the other",
                  counterexample: (counterexample(first, second) if at_once?(first, second, leaves)))
    end

    private

    # A test can hold both guards against the chart only before a step, not in the middle of one.
    def at_once?(first, second, leaves)
      return false if @walk.overlapping.empty?

      kind, what = @walk.overlapping.last.first
      events = kind == :event ? [what] : @document.timers.select { |one| what.include?(one.id) }.map(&:event)
      (first.events & second.events & events).any? && before_last_step.leaves == leaves
    end

    def before_last_step
      @walk.reached.keys.find { |snapshot| @walk.steps_to(snapshot) == @walk.overlapping[0..-2] }
    end

    def counterexample(first, second)
      both = [first, second].map { |one| one.guard || [:boolean, true] }
      claim = Counterexample::Claim.new(id: second.id, req: second.req, line: second.line, at: :before,
                                        says: "#{second.id} and #{first.id} are never enabled together.",
                                        demand: [:not, [:and, *both]])
      Counterexample.new(@document, @walk, claim, @walk.overlapping)
    end
  end
end
