# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'expression'

module Chart
  # SCXML's own algorithm (W3C SCXML 1.0, appendix D) on the tree of states: enabled set, exit set,
  # entry set. It shares nothing with the C emitter, which works on flattened regions.
  # @satisfies SWR-CHART-001
  class Interpreter
    # leaves and armed are ids in document order; started are the timers (re)started on the way.
    Outcome = Struct.new(:leaves, :armed, :actions, :started, :taken, :raised_count, keyword_init: true)

    def initialize(document)
      @document = document
    end

    def start
      begin_step([], [])
      enter(entry_of([@document.root.initial], []))
      outcome
    end

    # One macrostep for an event from outside. Internal events are not for the outside.
    def dispatch(leaves, armed, event, inputs)
      begin_step(leaves, armed)
      run(event, inputs) unless @document.internal_events.include?(event)
      outcome
    end

    # The timers expire in one call, in document order; one that an earlier expiry cancelled is skipped.
    def expire(leaves, armed, timers, inputs)
      begin_step(leaves, armed)
      @document.timers.each do |timer|
        next unless timers.include?(timer.id) && @armed.include?(timer.id) && !@started.include?(timer.id)

        @armed.delete(timer.id)
        run(timer.event, inputs)
      end
      outcome
    end

    # All active states of a configuration given by its leaves.
    def active(leaves)
      found = leaves.map { |id| @document.state(id) }
      (found + found.flat_map(&:ancestors)).uniq.reject { |state| state.kind == :root }
    end

    # Timers that run when the leaves have just been entered.
    def armed_by(leaves)
      in_order(active(leaves).flat_map(&:timers).map(&:id))
    end

    private

    def begin_step(leaves, armed)
      @configuration = active(leaves)
      @armed = armed.dup
      @actions = []
      @started = []
      @taken = []
      @queue = []
      @raised_count = 0
    end

    def outcome
      leaves = @configuration.select(&:leaf?).sort_by(&:order).map(&:id)
      Outcome.new(leaves: leaves, armed: in_order(@armed), actions: @actions.uniq,
                  started: in_order(@started & @armed), taken: @taken, raised_count: @raised_count)
    end

    def in_order(timers)
      @document.timers.map(&:id).select { |id| timers.include?(id) }
    end

    def run(event, inputs)
      @queue << event
      until @queue.empty?
        enabled = select(@queue.shift, inputs)
        microstep(enabled) unless enabled.empty?
      end
    end

    # selectTransitions and removeConflictingTransitions.
    def select(event, inputs)
      leaves = @configuration.select(&:leaf?).sort_by(&:order)
      enabled = leaves.filter_map { |leaf| first_enabled(leaf, event, inputs) }.uniq
      enabled.each_with_object([]) { |transition, kept| resolve_conflict(transition, kept) }
    end

    def first_enabled(leaf, event, inputs)
      [leaf, *leaf.ancestors].flat_map(&:transitions).find do |transition|
        transition.event == event && guard_true?(transition, inputs)
      end
    end

    def guard_true?(transition, inputs)
      transition.guard.nil? || Expression.true?(transition.guard) do |kind, name|
        kind == :in ? @configuration.any? { |state| state.id == name } : inputs.fetch(name)
      end
    end

    def resolve_conflict(transition, kept)
      rivals = kept.select { |other| (exit_set([transition]) & exit_set([other])).any? }
      return unless rivals.all? { |other| transition.source.inside?(other.source) }

      rivals.each { |other| kept.delete(other) }
      kept << transition
    end

    def microstep(enabled)
      left = exit_set(enabled)
      entered = entry_of(enabled.filter_map(&:target), enabled.filter_map { |one| domain(one) })
      left.sort_by { |state| -state.order }.each { |state| leave(state) }
      enabled.each { |transition| execute(transition) }
      enter(entered)
    end

    def leave(state)
      @armed -= state.timers.map(&:id)
      @configuration -= [state]
    end

    def execute(transition)
      @taken << transition
      @actions.concat(transition.actions)
      @queue.concat(transition.raises)
      @raised_count += transition.raises.length
    end

    def enter(states)
      states.sort_by(&:order).each do |state|
        @configuration |= [state]
        @armed |= state.timers.map(&:id)
        @started |= state.timers.map(&:id)
      end
    end

    def exit_set(transitions)
      transitions.select(&:target).flat_map do |transition|
        @configuration.select { |state| state.inside?(domain(transition)) }
      end.uniq
    end

    # getTransitionDomain: an internal transition of a compound state to its own descendant stays inside;
    # every other one leaves up to the nearest compound ancestor (a parallel is none) of source and target.
    def domain(transition)
      return nil unless transition.target

      source = transition.source
      return source if transition.internal && source.kind == :compound && transition.target.inside?(source)

      source.ancestors.find do |state|
        %i[compound root].include?(state.kind) && transition.target.inside?(state)
      end
    end

    # computeEntrySet: the targets, their default descendants, and their ancestors up to the domain,
    # with the other regions of a parallel that is entered on the way.
    def entry_of(targets, domains)
      limits = domains.empty? ? [@document.root] : domains
      targets.each_with_object([]) do |target, found|
        add_descendants(target, found)
        path = target.ancestors.take_while { |state| !limits.include?(state) }
        path.each { |state| add_ancestor(state, found) }
      end.uniq
    end

    def add_descendants(state, found)
      found << state
      case state.kind
      when :compound then add_descendants(state.initial, found)
      when :parallel then state.children.each { |child| add_descendants(child, found) }
      end
    end

    def add_ancestor(state, found)
      found << state
      return unless state.kind == :parallel

      missing = state.children.reject { |child| found.any? { |one| one == child || one.inside?(child) } }
      missing.each { |child| add_descendants(child, found) }
    end
  end
end
