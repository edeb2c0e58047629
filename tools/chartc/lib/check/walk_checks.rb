# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../refusal'
require_relative 'completeness'
require_relative 'entering'
require_relative 'overlapping'
require_relative 'properties'

module Chart
  # The rules that a complete walk decides. The walk itself has refused endless macrosteps, timers started twice and
  # values out of range. A chart in engine mode may overlap, ignore, and hold what is never used.
  # @satisfies SWR-CHART-002
  # @satisfies SWR-CHART-030
  # @satisfies SWR-CHART-041
  class WalkChecks
    def self.run(document, walk)
      new(document, walk).run
    end

    def initialize(document, walk)
      @document = document
      @walk = walk
    end

    # A broken guard shows itself in several rules: the violated property, with its list of events, says most.
    def run
      product = @document.mode == :product
      check_overlaps if product
      PropertyChecks.new(@document, @walk).check
      return unless product

      check_states_reached
      check_transitions_taken
      check_guards
      Completeness.new(@document, @walk).check
      Entering.new(@document, @walk).check
    end

    private

    def refuse(line, rule, message)
      raise Refusal.new(@document.file, line, rule, message)
    end

    def check_overlaps
      overlap = @walk.probe.overlaps.first
      return unless overlap

      raise Overlapping.new(@document, @walk).refusal(overlap)
    end

    def check_states_reached
      seen = @walk.probe.seen
      entered = taken.flat_map(&:targets) + defaults(seen).flat_map(&:targets)
      missed = @document.states.find do |state|
        state.history? ? !entered.include?(state) : !seen.include?(state.id)
      end
      return unless missed

      refuse(missed.line, 20, "state \"#{missed.id}\" is never reached; add a transition to it, or remove it")
    end

    def defaults(seen)
      states = @document.states.select { |state| seen.include?(state.id) || state.history? }
      [@document.root, *states].filter_map(&:initial)
    end

    def check_transitions_taken
      numbers = taken.map(&:number)
      missed = @document.transitions.find { |transition| !numbers.include?(transition.number) }
      return unless missed

      refuse(missed.line, 21, "#{missed.id} is never taken; correct its event or guard, or remove it")
    end

    def taken
      @taken ||= @walk.reachable_outcomes.flat_map(&:taken).uniq(&:number)
    end

    # Rule 21 has seen every guard true.
    def check_guards
      always = @document.transitions.find do |transition|
        transition.guard && !@walk.probe.guards[transition.number].include?(false)
      end
      return unless always

      refuse(always.line, 35, "the guard of #{always.id} is never false when it is asked; remove it, or its cause")
    end
  end
end
