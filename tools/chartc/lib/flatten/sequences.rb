# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../model'
require_relative 'regions'

module Chart
  # Steps of a sequence beside the model's Raise, Send, Cancel, Assign and Act. leaf nil: the region becomes inactive.
  Enter = Struct.new(:region, :leaf)
  Remember = Struct.new(:memory)
  # subject: a Region or a Memory; cases: [[leaves, steps], ...], a leaf nil stands for "none".
  Switch = Struct.new(:subject, :cases)
  # Raises the event if every one of the parallel's other regions is in a final state.
  Finish = Struct.new(:event, :parallel, :region)

  # What a transition does, resolved as far as the tree allows: exits inner to outer, content, entries outer to inner.
  class Sequences
    # The steps, with those in the cases of switches.
    def self.all(steps)
      steps.flat_map { |step| step.is_a?(Switch) ? all(step.cases.flat_map(&:last)) : [step] }
    end

    def initialize(document, regions)
      @document = document
      @regions = regions
    end

    # The state whose inside a transition leaves and enters; nil without target.
    def domain(transition)
      return nil if transition.targetless?

      source = transition.source
      inside = transition.targets.all? { |target| target.inside?(source) }
      return source if transition.internal && source.kind == :compound && inside

      source.ancestors.find { |state| state.compound? && transition.targets.all? { |target| target.inside?(state) } }
    end

    def exits(transition)
      scope = domain(transition)
      steps = scope ? leave_inside(scope, transition.source) : []
      steps.reject { |step| step.is_a?(Cancel) && expired?(step.timer, transition) }
    end

    def entries(transition)
      scope = domain(transition)
      scope ? enter_inside(scope, transition.targets, entered: false) : []
    end

    # Entering the chart.
    def start
      enter_inside(@document.root, [], entered: false)
    end

    # Regions that a transition may change.
    def reach(transition)
      scope = domain(transition)
      return [] unless scope

      region = @regions.of(scope)
      region ? @regions.with_nested(region) : @regions.to_a
    end

    private

    # True when only the expiry of this timer, which has stopped it, can lead to the transition.
    def expired?(timer, transition)
      return false unless @document.mode == :product && transition.events == [timer.event]

      causes = @document.timers.map(&:event) + @document.contents.grep(Raise).map(&:event)
      causes.count(timer.event) == 1
    end

    # --- exits: source reports which of the leaves can be active ---------------------------------------------------

    def leave_inside(scope, source)
      region = @regions.of(scope)
      return leave_lone(scope.substates.first, source) unless region

      cases = region.leaves.select { |leaf| leaf.inside?(scope) && possible?(leaf, source) }.map do |leaf|
        [[leaf], leave_leaf(leaf, scope, source)]
      end
      switch(region, cases) + (@regions.vanishes?(region) && region.outer ? [Enter.new(region, nil)] : [])
    end

    def leave_lone(parallel, source)
      remember([parallel]) + leave_children(parallel, source) + parallel.exit
    end

    # A leaf of the source's own region, or one that holds the source, or one of another region.
    def possible?(leaf, source)
      return true if source.nil?
      return true if leaf == source || leaf.inside?(source) || source.inside?(leaf)

      @regions.of(leaf) != @regions.of(source) && !source.inside?(@regions.of(leaf).state)
    end

    def leave_leaf(leaf, scope, source)
      path = [leaf, *leaf.ancestors].take_while { |state| state != scope }
      inner = leaf.parallel? ? leave_children(leaf, source) : []
      remember(path) + inner + path.flat_map(&:exit)
    end

    def remember(path)
      path.flat_map(&:histories).flat_map { |history| @regions.memories_of(history) }.map { |one| Remember.new(one) }
    end

    def leave_children(parallel, source)
      @regions.children(parallel).reverse.flat_map { |region| leave_region(region, source) }
    end

    def leave_region(region, source)
      cases = region.leaves.select { |leaf| possible?(leaf, source) }.map do |leaf|
        [[leaf], leave_leaf(leaf, region.state.parent, source)]
      end
      switch(region, cases) + (@regions.vanishes?(region) ? [Enter.new(region, nil)] : [])
    end

    # --- entries -------------------------------------------------------------------------------------------------

    # entered: the state itself is entered as well; what a default does belongs to that.
    def enter_inside(state, targets, entered: true)
      return enter_parallel(state, targets) if state.parallel?
      return default(state.initial, entered) + enter_inside(state, state.initial.targets) if targets.empty?

      history = targets.find { |target| target.history? && target.parent == state }
      return enter_history(history, entered) if history

      child = state.substates.find { |one| targets.all? { |target| target == one || target.inside?(one) } }
      enter_state(child, targets - [child])
    end

    def default(initial, entered)
      entered ? initial.content : []
    end

    def enter_parallel(state, targets)
      history = targets.find { |target| target.history? && target.parent == state }
      return enter_history(history) if history

      state.substates.flat_map do |child|
        enter_state(child, targets.select { |target| target.inside?(child) })
      end
    end

    def enter_state(state, targets)
      region = @regions.of(state)
      place = region && (state.leaf? || state.parallel?) ? [Enter.new(region, state)] : []
      inner = state.leaf? ? [] : enter_inside(state, targets)
      place + state.entry + inner + finish(state)
    end

    # done.state events of a final state's parent and of the parallel above it.
    def finish(state)
      parent = state.parent
      return [] if state.kind != :final || parent.root?

      above = parent.parent
      found = ["done.state.#{parent.id}"].select { |event| @document.events.include?(event) }
      steps = found.map { |event| Raise.new(event, state.line) }
      event = "done.state.#{above.id}"
      return steps unless above.parallel? && @document.events.include?(event)

      steps + [Finish.new(event, above, @regions.of(state))]
    end

    # --- histories -----------------------------------------------------------------------------------------------

    def enter_history(history, entered = true)
      parent = history.parent
      fallback = default(history.initial, entered) + enter_inside(parent, history.initial.targets)
      return recall_parallel(history, fallback) if parent.parallel?

      region = @regions.of(parent)
      cases = region.leaves.select { |leaf| leaf.inside?(parent) }.map { |leaf| [[leaf], recall(history, leaf)] }
      switch(Memory.new(history, region), [[[nil], fallback]] + cases)
    end

    def recall_parallel(history, fallback)
      parent = history.parent
      steps = @regions.children(parent).flat_map do |region|
        history.depth == :deep ? recall_region(history, region) : enter_state(region.state, [])
      end
      first = @regions.children(parent).first
      switch(Memory.new(history, first), [[[nil], fallback], [first.leaves, steps]])
    end

    def recall(history, leaf)
      parent = history.parent
      path = [leaf, *leaf.ancestors].take_while { |state| state != parent }.reverse
      return enter_state(path.first, []) if history.depth == :shallow

      follow(history, path)
    end

    # Enters the states of a path, the last of which is a leaf of its region.
    def follow(history, path)
      leaf = path.last
      region = @regions.of(leaf)
      inner = leaf.parallel? ? @regions.children(leaf).flat_map { |one| recall_region(history, one) } : []
      path[0..-2].flat_map(&:entry) + [Enter.new(region, leaf)] + leaf.entry + inner + finish(leaf)
    end

    def recall_region(history, region)
      cases = region.leaves.map do |leaf|
        path = [leaf, *leaf.ancestors].take_while { |state| state != region.state.parent }.reverse
        [[leaf], follow(history, path)]
      end
      switch(Memory.new(history, region), cases)
    end

    # --- switches ------------------------------------------------------------------------------------------------

    # Cases that do the same are one; if all do the same, no switch is left.
    def switch(subject, cases)
      merged = cases.group_by(&:last).map { |steps, same| [same.flat_map(&:first), steps] }
      return merged.first.last if merged.length == 1
      return [] if merged.empty?

      cancels_only?(merged) ? merged.flat_map(&:last).uniq : [Switch.new(subject, merged)]
    end

    # In the product profile a timer runs only inside its state, so that cancelling it elsewhere is harmless.
    def cancels_only?(cases)
      @document.mode == :product && cases.flat_map(&:last).all? { |step| step.is_a?(Cancel) }
    end
  end
end
