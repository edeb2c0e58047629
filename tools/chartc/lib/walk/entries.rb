# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../model'

module Chart
  # What transitions enter and inside which state they stay: the functions of appendix D that read the tree and the
  # recorded histories ({ history id => [state ids] }), but not the configuration.
  class Entries
    # A state to enter, with its <onentry> and what follows from a default taken below it.
    Entry = Struct.new(:state, :content)

    def initialize(document)
      @document = document
      @remembers = document.histories.any?
      @entered = {}
      @domains = {}
    end

    # computeEntrySet, in entry order.
    def of(transitions, history)
      key = transitions.map(&:number)
      key << history if @remembers
      @entered[key] ||= EntrySet.new(self, history).add_all(transitions).entries
    end

    # Entering the chart.
    def at_start
      EntrySet.new(self, {}).add(@document.root.initial.targets, @document.root.initial.targets, @document.root).entries
    end

    # getTransitionDomain: nil without target. An internal transition of a compound state to its own inside stays
    # there; every other one goes up to the nearest compound state (a parallel is none) around source and targets.
    def domain(transition, history)
      return compute_domain(transition, history) if transition.targets.any?(&:history?)

      @domains.fetch(transition.number) { |number| @domains[number] = compute_domain(transition, history) }
    end

    # getEffectiveTargetStates
    def effective(targets, history)
      targets.flat_map do |target|
        next [target] unless target.history?

        recorded(target, history) || effective(target.initial.targets, history)
      end.uniq
    end

    def recorded(target, history)
      history[target.id]&.map { |id| @document.state(id) }
    end

    private

    def compute_domain(transition, history)
      targets = effective(transition.targets, history)
      return nil if targets.empty?

      source = transition.source
      return source if transition.internal && source.compound? && targets.all? { |target| target.inside?(source) }

      source.ancestors.find { |state| state.compound? && targets.all? { |target| target.inside?(state) } }
    end
  end

  # The set of states to enter while it is being computed.
  class EntrySet
    def initialize(tree, history)
      @tree = tree
      @history = history
      @states = []
      @defaults = []
      @history_content = {}
    end

    def add_all(transitions)
      transitions.each do |transition|
        next if transition.targetless?

        effective = @tree.effective(transition.targets, @history)
        add(transition.targets, effective, @tree.domain(transition, @history))
      end
      self
    end

    def add(targets, effective, limit)
      targets.each { |target| add_descendants(target) }
      effective.each { |target| add_ancestors(target, limit) }
      self
    end

    def entries
      @states.uniq.sort_by(&:order).map { |state| Entries::Entry.new(state, content(state)) }.freeze
    end

    private

    def content(state)
      default = @defaults.include?(state) ? state.initial.content : []
      state.entry + default + @history_content.fetch(state, [])
    end

    # addDescendantStatesToEnter
    def add_descendants(state)
      return add_history(state) if state.history?

      @states << state
      add_default(state) if state.kind == :compound
      add_regions(state) if state.parallel?
    end

    def add_history(history)
      found = @tree.recorded(history, @history)
      @history_content[history.parent] = history.initial.content unless found
      add_below(found || history.initial.targets, history.parent)
    end

    def add_default(state)
      @defaults << state
      add_below(state.initial.targets, state)
    end

    def add_below(targets, limit)
      targets.each { |target| add_descendants(target) }
      targets.each { |target| add_ancestors(target, limit) }
    end

    # addAncestorStatesToEnter
    def add_ancestors(state, limit)
      state.ancestors.take_while { |ancestor| ancestor != limit }.each do |ancestor|
        @states << ancestor
        add_regions(ancestor) if ancestor.parallel?
      end
    end

    def add_regions(parallel)
      parallel.substates.each do |child|
        add_descendants(child) unless @states.any? { |state| state.inside?(child) }
      end
    end
  end
end
