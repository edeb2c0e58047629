# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'text'

module Chart
  class Promela
    # The transitions that one event takes: the first enabled one of each track, then of two that leave a common
    # state the one with the inner source, else the earlier one.
    class Selection
      # A transition and the condition under which its track comes to it.
      Candidate = Struct.new(:transition, :condition)

      def initialize(document, names, tree)
        @document = document
        @names = names
        @tree = tree
      end

      # heard: statements that note the event.
      def inline(heard)
        comment = 'The transitions of `event`, in the order of the tracks that ask for them.'
        Text.inline('select_transitions()', comment, ['asked = 0', 'moves = 0', *heard, Text.choose(options)])
      end

      private

      # A chart that has come to its own end takes nothing.
      def options
        final = @document.root.substates.select { |state| state.kind == :final }
        ended = final.empty? ? [] : [[Text.any(final.map { |state| @names.active(state) }), ['skip']]]
        start = ['event == START', ['next = INITIAL', 'moves = 1', 'add()']]
        ended + [start] + waiting('NOTHING', &:eventless?) + @document.events.flat_map do |event|
          waiting(@names.event(event)) { |transition| transition.events.include?(event) }
        end
      end

      # The block states which transitions wait for the event.
      def waiting(event, &wanted)
        earlier = []
        statements = @tree.tracks.filter_map do |track|
          candidates = candidates(track, &wanted)
          next if candidates.empty?

          asking = ask(candidates, earlier)
          earlier |= candidates.map(&:transition)
          asking
        end
        statements.empty? ? [] : [["event == #{event}", statements]]
      end

      def candidates(track, &wanted)
        @tree.lookup(track).flat_map do |state|
          state.transitions.select(&wanted).map { |one| Candidate.new(one, condition(one, track)) }
        end
      end

      # What stands around a track is active while the track is, and asked only then.
      def condition(transition, track)
        source = transition.source
        [@names.active(source.inside?(track) ? source : track),
         *(transition.guard ? [@names.term(transition.guard)] : [])].join(' && ')
      end

      def ask(candidates, earlier)
        found = Text.first(candidates.map { |one| [one.condition, one.transition.number] })
        duels = candidates.flat_map { |one| duels(one.transition, earlier) }
        moves = candidates.all? { |one| one.transition.targetless? } ? [] : ['moves = 1']
        add = Text.choose([['next && fate[next] == UNASKED', ['add()', *moves, Text.choose(duels)]]])
        ["next =\n#{Text.indent(found)}", add]
      end

      # Beside an earlier rival a transition stands only if its source lies inside that of the rival, which falls then.
      def duels(transition, earlier)
        weaker, stronger = earlier.select { |other| rivals?(transition, other) }
                                  .partition { |other| transition.source.inside?(other.source) }
        this = "next == #{transition.number}"
        lost = stronger.empty? ? [] : [["#{this} && #{Text.taken(stronger)}", ['fate[next] = DROPPED']]]
        won = weaker.empty? ? [] : [[this, weaker.map { |other| "drop(#{other.number})" }]]
        lost + won
      end

      # Both leave states, and one leaves all that the other leaves.
      def rivals?(one, other)
        first = @tree.domain(one)
        second = @tree.domain(other)
        return false if one == other || first.nil? || second.nil?

        first == second || first.inside?(second) || second.inside?(first)
      end
    end
  end
end
