# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../model'
require_relative '../read/expression'
require_relative 'regions'

module Chart
  # Per leaf and event one decision: nil (ignore), a Transition, or a Choice on one atom of the guards.
  class Decisions
    Choice = Struct.new(:atom, :yes, :no)

    def initialize(document, regions)
      @document = document
      @regions = regions
      @found = {}
    end

    # event => decision, for the events that a transition of the leaf or of its ancestors in the region waits for; the
    # event nil stands for eventless transitions.
    def of(leaf)
      @found[leaf] ||= decide_all(leaf)
    end

    # The regions that wait for one of the events; nil stands for eventless transitions.
    def waiting(events)
      @regions.select { |region| region.leaves.any? { |leaf| (of(leaf).keys & events).any? } }
    end

    def eventless?
      @document.transitions.any?(&:eventless?)
    end

    # Transitions of the leaf's region that are looked at while the leaf is active, inner ones first.
    def candidates(leaf)
      region = @regions.of(leaf)
      [leaf, *leaf.ancestors].select { |state| @regions.of(state) == region }.flat_map(&:transitions)
    end

    private

    def decide_all(leaf)
      candidates = candidates(leaf)
      [*@document.events, nil].filter_map do |event|
        rivals = candidates.select { |one| event ? one.events.include?(event) : one.eventless? }
        decision = decide(leaf, rivals)
        [event, decision] if decision
      end.to_h
    end

    def decide(leaf, candidates)
      atoms = candidates.filter_map(&:guard).flat_map { |guard| Guard.atoms(guard) }.uniq
      build(assignments(leaf, atoms), atoms, candidates)
    end

    # Every combination of truth values that the atoms can have while the leaf is active: In() atoms as the regions
    # allow them together, all others free.
    def assignments(leaf, atoms)
      places, free = atoms.partition { |kind, _name| kind == :in }
      places = place_assignments(leaf, places)
      free = [false, true].repeated_permutation(free.length).map { |values| free.zip(values).to_h }
      places.product(free).map { |one, other| one.merge(other) }
    end

    def place_assignments(leaf, places)
      regions = places.map { |_in, id| @regions.of(@document.state(id)) }.compact.uniq
      choices = regions.map { |region| region == @regions.of(leaf) ? [leaf] : possible(region, leaf) }
      first, *rest = choices
      return [places.to_h { |place| [place, true] }] if first.nil?

      first.product(*rest).map { |active| truths(places, [leaf, *active].compact) }.uniq
    end

    # nil stands for an inactive region.
    def possible(region, leaf)
      holder = region.leaves.find { |one| leaf.inside?(one) }
      return [holder] if holder

      @regions.always_active?(region) ? region.leaves : region.leaves + [nil]
    end

    def truths(places, active)
      places.to_h do |place|
        state = @document.state(place.last)
        [place, @regions.of(state).nil? || active.any? { |leaf| leaf == state || leaf.inside?(state) }]
      end
    end

    def build(assignments, atoms, candidates)
      outcomes = assignments.map { |truth| first_enabled(candidates, truth) }.uniq(&:object_id)
      return outcomes.first if outcomes.length == 1

      atom = atoms.find { |one| assignments.map { |truth| truth[one] }.uniq.length == 2 }
      yes, no = assignments.partition { |truth| truth[atom] }
      rest = atoms - [atom]
      choice(atom, build(yes, rest, candidates), build(no, rest, candidates))
    end

    def choice(atom, yes, no)
      same?(yes, no) ? yes : Choice.new(atom, yes, no)
    end

    def same?(left, right)
      return left.equal?(right) unless left.is_a?(Choice) && right.is_a?(Choice)

      left.atom == right.atom && same?(left.yes, right.yes) && same?(left.no, right.no)
    end

    def first_enabled(candidates, truth)
      candidates.find { |transition| transition.guard.nil? || Guard.true?(transition.guard, truth) }
    end
  end

  # A guard as a formula over atoms: In(), a boolean, or a comparison as a whole.
  module Guard
    module_function

    def atoms(guard)
      case guard.first
      when :not then atoms(guard[1])
      when :and, :or then atoms(guard[1]) | atoms(guard[2])
      when :boolean then []
      else [guard]
      end
    end

    def true?(guard, truth)
      case guard.first
      when :not then !true?(guard[1], truth)
      when :and then true?(guard[1], truth) && true?(guard[2], truth)
      when :or then true?(guard[1], truth) || true?(guard[2], truth)
      when :boolean then guard[1]
      else truth.fetch(guard)
      end
    end
  end
end
