# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../model'

module Chart
  # Where the chart, compound states and histories without record begin.
  class Defaults
    def initialize(context, states, contents)
      @context = context
      @states = states
      @contents = contents
    end

    # The Default of a state, nil for one that has none.
    def of(element, state)
      return history_default(element, state) if state.history?
      return unless state.compound?

      chosen = initial_element(element, state)
      words = element.attributes['initial'] || chosen&.attributes&.fetch('target', nil)
      targets = words ? resolve(words, state, element.line) : first_child(element, state)
      Default.new(targets: targets, content: chosen ? @contents.read(chosen) : [], line: element.line)
    end

    # The leaves of the configuration that a state begins with, before any event.
    def leaves(state, targets = [])
      return [state] if state.leaf?

      inner = entered(targets).select { |target| target.inside?(state) }
      return state.substates.flat_map { |child| leaves(child, inner) } if state.parallel?

      inner = entered(state.initial.targets) if inner.empty?
      child = state.substates.find { |one| inner.any? { |target| target == one || target.inside?(one) } }
      leaves(child, inner)
    end

    private

    def entered(targets)
      targets.flat_map { |target| target.history? ? target.initial.targets : [target] }
    end

    def initial_element(element, state)
      chosen = element.child('initial') || return
      transitions = chosen.children
      return transitions.first if transitions.length == 1 && !element.attributes.key?('initial')

      @context.refuse(chosen.line, 4, "<initial> of \"#{state.id}\" has one <transition>, and the state no initial=; " \
                                      'write only one of both')
    end

    def first_child(element, state)
      return [state.substates.first] if @context.lenient? && state.substates.any?

      @context.refuse(element.line, 4, "\"#{state.id}\" does not say where it begins; " \
                                       "add initial=\"...\", #{@context.choice(state.children.map(&:id))}")
    end

    def resolve(words, state, line)
      inside = @states.all.select { |one| one.inside?(state) }
      @context.refuse(line, 7, "initial is empty; #{@context.choice(inside.map(&:id))}") if words.split.empty?
      words.split.map do |id|
        inside.find { |one| one.id == id } ||
          @context.refuse(line, 7, "initial \"#{id}\" is no state inside; #{@context.choice(inside.map(&:id))}")
      end
    end

    def history_default(element, history)
      transition = element.children.first
      refuse_history(history, element.line) unless element.children.length == 1
      refuse_history(history, transition.line) if (transition.attributes.keys & %w[event cond]).any?
      targets = transition.attributes.fetch('target', '').split.map { |id| @states.find(id) }
      fits = targets.any? && targets.all? { |target| target && !target.history? && target.inside?(history.parent) }
      refuse_history(history, transition.line) unless fits
      Default.new(targets: targets, content: @contents.read(transition), line: transition.line)
    end

    def refuse_history(history, line)
      states = @states.all.select { |one| one.inside?(history.parent) && !one.history? }.map(&:id)
      @context.refuse(line, 29, "history \"#{history.id}\" needs one default, <transition target=\"...\"/>; " \
                                "#{@context.choice(states)}")
    end
  end
end
