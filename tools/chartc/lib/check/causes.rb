# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../refusal'

module Chart
  # Which transitions a transition can bring about within its macrostep: by an event that it raises, or by entering the
  # source of an eventless one. No transition may bring about itself. All is taken from the tree alone, guards aside,
  # so that a chart that passes needs no other argument for ending.
  class Causes
    def initialize(document)
      @document = document
      @finished = {}
      @eventless = document.transitions.select(&:eventless?)
      @waiting = Hash.new { |found, event| found[event] = [] }
      document.transitions.each { |one| one.events.each { |event| @waiting[event] << one } }
      @leaving_raises = document.states.any? { |state| state.exit.grep(Raise).any? }
    end

    def check
      @document.transitions.each { |transition| follow(transition, []) }
    end

    private

    # Depth first.
    def follow(transition, path)
      return if @finished.key?(transition.number)

      refuse(path.drop_while { |one| one != transition }) if path.include?(transition)
      caused(transition).each { |following| follow(following, path + [transition]) }
      @finished[transition.number] = true
    end

    def refuse(circle)
      ids = [*circle, circle.first].map(&:id).join(' -> ')
      raise Refusal.new(@document.file, circle.last.line, 11, 'transitions may bring about each other for ever: ' \
                                                              "#{ids}; give one an event, or remove one <raise>")
    end

    def caused(transition)
      entered = entered(transition)
      raised = raised(transition, entered)
      woken = @eventless.select { |other| awakes?(transition, other, entered) }
      (woken + raised.flat_map { |event| @waiting[event] }).uniq(&:number).sort_by(&:number)
    end

    # An eventless transition that does not leave its source could be taken again at once.
    def awakes?(transition, eventless, entered)
      return true if entered.include?(eventless.source)

      transition == eventless && !left(transition).include?(transition.source)
    end

    def raised(transition, entered)
      left = @leaving_raises ? left(transition).flat_map(&:exit) : []
      contents = transition.content + left + entered.flat_map(&:entry)
      contents.grep(Raise).map(&:event) + entered.select { |state| state.kind == :final }.flat_map { |one| done(one) }
    end

    def done(state)
      [state.parent, state.parent.parent].compact.map { |one| "done.state.#{one.id}" }
    end

    # getTransitionDomain
    def domain(transition)
      source = transition.source
      inside = transition.targets.all? { |target| target.inside?(source) }
      return source if transition.internal && source.compound? && inside

      source.ancestors.find { |state| state.compound? && transition.targets.all? { |one| one.inside?(state) } }
    end

    # What is inside the domain and can be active beside the source.
    def left(transition)
      return [] if transition.targetless?

      inside = @document.states.select { |state| state.inside?(domain(transition)) }
      inside.select { |state| together?(state, transition.source) }
    end

    def together?(one, other)
      return true if one == other || one.inside?(other) || other.inside?(one)

      one.ancestors.find { |state| other.inside?(state) }.parallel?
    end

    def entered(transition)
      transition.targets.each_with_object([]) do |target, found|
        enter(target, found)
        path = target.ancestors.take_while { |state| state != domain(transition) }
        path.each { |state| state.parallel? ? enter(state, found) : found << state }
      end.uniq
    end

    # A state with all that it may begin with; a history may begin with anything inside its parent.
    def enter(state, found)
      return if found.include?(state)
      return found.concat(@document.states.select { |one| one.inside?(state.parent) }) if state.history?

      found << state
      state.substates.each { |child| enter(child, found) } if state.parallel?
      return unless state.kind == :compound

      state.initial.targets.each do |target|
        enter(target, found)
        target.ancestors.take_while { |one| one != state }.each { |one| found << one }
      end
    end
  end
end
