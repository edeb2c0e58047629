# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'expression'

module Chart
  # The chart as the C emitter sees it: per region a list of leaves, per leaf and event one decision.
  class Flat
    # A decision is nil (ignore), a Transition, or a Choice on one atom.
    Choice = Struct.new(:atom, :yes, :no)

    def initialize(document)
      @document = document
    end

    # event => decision, for the events that some transition of the leaf or its ancestors waits for.
    def decisions(leaf)
      candidates = [leaf, *leaf.ancestors].flat_map(&:transitions).group_by(&:event)
      @document.events.filter_map do |event|
        decision = decide(leaf, candidates.fetch(event, []))
        [event, decision] if decision
      end.to_h
    end

    # The timers that may run when the transition is taken and whose state it leaves. One of them may have
    # expired already, or its state may be a sibling's child: cancelling it then is harmless.
    def cancelled(transition)
      return [] unless transition.target

      domain = domain(transition)
      source = transition.source
      @document.timers.select do |timer|
        state = timer.state
        state.inside?(domain) && (state == source || state.inside?(source) || source.inside?(state))
      end
    end

    def started(transition)
      transition.target ? timers_from(entered_leaf(transition.target), domain(transition)) : []
    end

    def entered_leaf(state)
      state = state.initial until state.leaf?
      state
    end

    # Timers of a leaf and of its ancestors below the domain, outermost first.
    def timers_from(leaf, domain)
      path = [leaf, *leaf.ancestors].take_while { |state| state != domain }
      @document.timers.select { |timer| path.include?(timer.state) }
    end

    # The most events that one macrostep can raise; the raise graph is acyclic.
    def raise_bound
      @raise_bound ||= @document.events.map { |event| raised_after(event) }.max || 0
    end

    private

    def domain(transition)
      source = transition.source
      return source if transition.internal && !source.leaf? && transition.target.inside?(source)

      source.ancestors.find { |state| transition.target.inside?(state) }
    end

    def raised_after(event)
      @document.regions.sum do |region|
        mine = @document.transitions.select { |one| one.event == event && in_region?(one, region) }
        mine.map { |one| one.raises.sum { |raised| 1 + raised_after(raised) } }.max || 0
      end
    end

    def in_region?(transition, region)
      transition.source == region.state || transition.source.inside?(region.state)
    end

    def decide(leaf, candidates)
      atoms = candidates.filter_map(&:guard).flat_map { |guard| Expression.atoms(guard) }.uniq
      build(assignments(leaf, atoms), atoms, candidates)
    end

    # Every combination of truth values that the atoms can have while the leaf is active.
    def assignments(leaf, atoms)
      others = @document.regions.map do |region|
        region == @document.region_of(leaf) ? [leaf] : region.leaves
      end
      inputs = atoms.select { |kind, _name| kind == :input }
      others.first.product(*others.drop(1)).flat_map do |leaves|
        [false, true].repeated_permutation(inputs.length).map do |values|
          truth = inputs.zip(values).to_h
          atoms.to_h { |atom| [atom, atom.first == :in ? active?(atom.last, leaves) : truth.fetch(atom)] }
        end
      end.uniq
    end

    def active?(id, leaves)
      leaves.any? { |leaf| [leaf, *leaf.ancestors].any? { |state| state.id == id } }
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
      candidates.find do |transition|
        transition.guard.nil? || Expression.true?(transition.guard) { |atom| truth.fetch(atom) }
      end
    end
  end
end
