# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'interpreter'

module Chart
  # An interpreter that remembers what it has come across in all its runs, also in the middle of macrosteps.
  class Probe < Interpreter
    # Two transitions of one state enabled at once, with where and with which inputs.
    Overlap = Struct.new(:first, :second, :leaves, :inputs)

    # guards: { number of a transition => the values its guard had when it was asked }
    attr_reader :guards, :overlaps

    def initialize(document)
      super
      @guards = Hash.new { |found, number| found[number] = [] }
      @overlaps = []
      @seen = 0
    end

    # Ids of all states that were ever active.
    def seen
      @tree.ids(@seen)
    end

    private

    def first_enabled(candidates)
      found = super
      note_overlap(found, candidates) if found && candidates.length > 1
      found
    end

    def enabled?(transition)
      note_guard(transition, super)
    end

    def note_guard(transition, answer)
      known = @guards[transition.number]
      known << answer unless known.include?(answer)
      answer
    end

    def note_overlap(found, candidates)
      later = candidates.drop_while { |one| !one.equal?(found) }.drop(1)
      rivals = later.select do |one|
        one.source == found.source && (one.guard.nil? || note_guard(one, value(one.guard)))
      end
      rivals.each { |rival| @overlaps << Overlap.new(found, rival, @tree.leaves(@configuration), @inputs) }
    end

    def enter(entries)
      super
      @seen |= @configuration
    end
  end
end
