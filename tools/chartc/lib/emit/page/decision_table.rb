# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../../read/expression'
require_relative '../words'
require_relative 'html'

module Chart
  # What a region decides: for each of its leaves and each event that it reacts to, what happens.
  class DecisionTable
    AT_ONCE = 'at once'

    def initialize(document, region)
      @document = document
      @region = region
    end

    # Every event of a transition in the region, or around it; AT_ONCE stands for eventless ones.
    def events
      @events ||= begin
        heard = sources.flat_map(&:transitions)
        (@document.events & heard.flat_map(&:events)) + (heard.any?(&:eventless?) ? [AT_ONCE] : [])
      end
    end

    def table
      rows = @region.leaves.map { |leaf| [leaf.id, *events.map { |event| decision(leaf, event) }] }
      Html.table([@region.name, *events], rows, 'decisions')
    end

    private

    def sources
      @sources ||= @region.leaves.flat_map { |leaf| [leaf, *leaf.ancestors] }.uniq
    end

    def decision(leaf, event)
      found = candidates(leaf, event)
      pieces = found.map { |transition| piece(transition) }
      pieces << Html.tag('span', 'ignored', 'quiet') if ignored?(leaf, event) && !certain?(found)
      Html.lines(pieces)
    end

    # In the order they are asked, as far as they are.
    def candidates(leaf, event)
      asked = [leaf, *leaf.ancestors].flat_map(&:transitions).select { |one| hears?(one, event) }
      (1..asked.length).map { |count| asked.take(count) }.find { |first| certain?(first) } || asked
    end

    def hears?(transition, event)
      transition.events.include?(event) || (transition.eventless? && event == AT_ONCE)
    end

    # Is one of them always taken?
    def certain?(transitions)
      guards = transitions.map(&:guard)
      return true if guards.include?(nil)

      atoms = guards.flat_map { |guard| Expression.atoms(guard) }.uniq
      return false if atoms.any? { |kind, name| kind == :variable && integer?(name) }

      [true, false].repeated_permutation(atoms.length).all? do |values|
        guards.any? { |guard| Expression.value(guard) { |*atom| values[atoms.index(atom)] } }
      end
    end

    def integer?(name)
      @document.variables.find { |variable| variable.name == name }.kind == :integer
    end

    def ignored?(leaf, event)
      [leaf, *leaf.ancestors].any? { |state| !state.root? && state.ignores.include?(event) }
    end

    def piece(transition)
      guard = transition.guard_text && Html.tag('span', "[#{transition.guard_text}] ", 'guard')
      Html.join([guard, result(transition)].compact, '')
    end

    def result(transition)
      return Html.tag('b', "→\u00a0#{transition.targets.map(&:id).join(', ')}") unless transition.targetless?

      work = Words.content(transition.content)
      work.empty? ? 'taken' : Html.tag('span', work.join(', '), 'work')
    end
  end
end
