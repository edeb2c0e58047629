# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'expression'
require_relative 'refusal'

module Chart
  # The rules that a complete walk decides.
  # @satisfies SWR-CHART-002
  class WalkChecks
    def self.run(document, walk)
      new(document, walk).run
    end

    def initialize(document, walk)
      @document = document
      @walk = walk
    end

    def run
      check_overlaps
      check_states_reached
      check_transitions_taken
      @document.invariants.each { |invariant| check_invariant(invariant) }
    end

    private

    def refuse(line, rule, message)
      raise Refusal.new(@document.file, line, rule, message)
    end

    def check_overlaps
      @document.states.each do |state|
        state.transitions.group_by(&:event).each_value do |rivals|
          rivals.combination(2) { |first, second| check_pair(state, first, second) }
        end
      end
    end

    def check_pair(state, first, second)
      @walk.legal_configurations.each do |leaves, _armed|
        active = @walk.active(leaves)
        next unless active.include?(state.id)

        @walk.valuations.each do |inputs|
          next unless enabled?(first, active, inputs) && enabled?(second, active, inputs)

          refuse_overlap(first, second, leaves, inputs)
        end
      end
    end

    def enabled?(transition, active, inputs)
      transition.guard.nil? || Expression.true?(transition.guard) do |kind, name|
        kind == :in ? active.include?(name) : inputs.fetch(name)
      end
    end

    def refuse_overlap(first, second, leaves, inputs)
      set = inputs.map { |name, value| value ? name : "!#{name}" }
      refuse(second.line, 22, "#{second.id} and #{first.id} are both enabled by \"#{first.event}\" in " \
                              "#{[*leaves, *set].join(' ')}; add to one guard the negation of the other")
    end

    def check_states_reached
      reached = @walk.reached.keys.flat_map { |leaves, _armed| @walk.active(leaves) }.uniq
      missed = @document.states.find { |state| !reached.include?(state.id) }
      return unless missed

      refuse(missed.line, 20, "state \"#{missed.id}\" is never reached; add a transition to it, or remove it")
    end

    def check_transitions_taken
      taken = @walk.reachable_pairs.flat_map(&:outcomes).flat_map(&:taken).uniq(&:number)
      missed = @document.transitions.find { |transition| !taken.include?(transition) }
      return unless missed

      refuse(missed.line, 21, "#{missed.id} is never taken; correct its event or guard, or remove it")
    end

    def check_invariant(invariant)
      @walk.reached.each_key do |configuration|
        active = @walk.active(configuration.first)
        next if Expression.true?(invariant.expression) { |_kind, name| active.include?(name) }

        refuse(invariant.line, 23, "#{invariant.id} is violated in #{configuration.first.join(' ')}, reached by: " \
                                   "#{@walk.path_to(configuration)}; close that path")
      end
    end
  end
end
