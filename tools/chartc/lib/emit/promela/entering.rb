# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'text'

module Chart
  class Promela
    # Where the taken transitions lead. They mark their targets and what lies between those and their domains; then one
    # pass from the outside in enters what is marked and marks what must be active inside it.
    class Entering
      def initialize(document, names, tree, content)
        @document = document
        @names = names
        @tree = tree
        @content = content
      end

      def inlines
        entries = @tree.states.map { |state| entry(state) }
        done = reported.map { |history| "#{@names.reported(history)} = 0" }
        [Text.inline('take_transitions()', 'Content of the transitions, in their order.', taking),
         Text.inline('mark_targets()', 'Where the transitions lead.', [targets, recalls]),
         Text.inline('enter_states()', 'In document order; what is marked without anything inside begins there.',
                     [entries, done])]
      end

      def marks_used
        @tree.states.map { |state| @names.enter(state) } +
          @document.histories.map { |history| @names.recall(history) } + reported.map { |history| @names.reported(history) }
      end

      private

      # Histories whose default has content.
      def reported
        @document.histories.reject { |history| history.initial.content.empty? }
      end

      def taking
        options = @document.transitions.reject { |transition| transition.content.empty? }.map do |transition|
          ["one == #{transition.number}", @content.statements(transition.content)]
        end
        start = @document.root.initial.content
        options << ['one == INITIAL', @content.statements(start)] unless start.empty?
        number = Text.choose([['one != INITIAL', ['printf(" %d", one)']]])
        standing = ['fate[one] == TAKEN', [number, Text.choose(options)]]
        Text.each_place('asked', ['one = chosen[place]', Text.choose([standing])])
      end

      # state or history => transitions that mark it; nil stands for the start of the chart.
      def aims
        found = Hash.new { |aims, state| aims[state] = [] }
        [nil, *@document.transitions].each do |transition|
          targets = transition ? transition.targets : @document.root.initial.targets
          limit = transition && @tree.domain(transition)
          targets.flat_map { |target| way(target, limit) }.uniq.each { |state| found[state] << transition }
        end
        found
      end

      # From the outside in, the target last.
      def way(target, limit)
        @tree.path(target, limit).reverse
      end

      def targets
        aims.map { |state, transitions| "#{mark_of(state)} = #{Text.taken(transitions)}" }
      end

      def mark_of(state)
        state.history? ? @names.recall(state) : @names.enter(state)
      end

      def recalls
        aims.keys.select(&:history?).map { |history| recall(history) }
      end

      # What a history marks that is to be recalled.
      def recall(history)
        mark = @names.recall(history)
        recorded = @tree.remembered(history)
        remembered = recorded.flat_map { |state| @tree.path(state, history.parent) }.uniq.map do |state|
          held = recorded.select { |one| one == state || one.inside?(state) }
          also(@names.enter(state), "#{mark} && #{past(history, held)}")
        end
        first = "#{mark} && !#{past(history, recorded)}"
        due = reported.include?(history) ? [also(@names.reported(history), first)] : []
        due + default(history.initial.targets, history.parent, first) + remembered + ["#{mark} = 0"]
      end

      def past(history, states)
        Text.any(states.map { |state| @names.memory(history, state) })
      end

      def default(targets, limit, condition)
        targets.flat_map { |target| way(target, limit) }.uniq.map { |state| also(mark_of(state), condition) }
      end

      def also(mark, condition)
        "#{mark} = #{mark} || #{condition}"
      end

      def entry(state)
        enter = @names.enter(state)
        content = @content.statements(state.entry)
        [also(@names.active(state), enter), content.empty? ? [] : Text.choose([[enter, content]]),
         inside(state), first_content(state), done(state), "#{enter} = 0"]
      end

      def inside(state)
        return default(state.substates, state, @names.enter(state)) if state.parallel?

        state.kind == :compound ? initial(state) : []
      end

      def initial(state)
        marked = Text.any(state.substates.map { |child| @names.enter(child) })
        content = @content.statements(state.initial.content)
        ["fresh = #{@names.enter(state)} && !#{marked}", default(state.initial.targets, state, 'fresh'),
         state.initial.targets.select(&:history?).map { |history| recall(history) },
         content.empty? ? [] : Text.choose([['fresh', content]])]
      end

      def first_content(state)
        (state.histories & reported).map do |history|
          Text.choose([["#{@names.enter(state)} && #{@names.reported(history)}",
                        @content.statements(history.initial.content)]])
        end
      end

      def done(state)
        parent = state.parent
        return [] if state.kind != :final || parent.root?

        around = parent.parent
        all = around.parallel? ? @content.raising("done.state.#{around.id}") : []
        raised = [@content.raising("done.state.#{parent.id}"), all.empty? ? [] : Text.choose([[ended(around), all]])]
        raised.flatten.empty? ? [] : Text.choose([[@names.enter(state), raised]])
      end

      # A compound state is done in a final child, a parallel when all its regions are.
      def ended(state)
        return "(#{state.substates.map { |child| ended(child) }.join(' && ')})" if state.parallel?

        finals = state.substates.select { |child| child.kind == :final }
        finals.empty? ? 'false' : Text.any(finals.map { |child| @names.active(child) })
      end
    end
  end
end
