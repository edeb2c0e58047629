# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../refusal'

module Chart
  # From where an event enters a state, with some values of inputs and data. A leaf from which it always does says so by itself;
  # an event for which no leaf says it depends on several regions at once, and is refused.
  # @satisfies SWR-TOOL-072
  class Entering
    def initialize(document, walk)
      @document = document
      @walk = walk
    end

    # Refuses an event of bs:enters for which leaves do not say it.
    def check
      @document.entering.each { |event| check_event(event) }
    end

    # The leaves from which the event enters a state, in document order.
    def leaves(event)
      entered, other = configurations(event).partition(&:last).map { |pairs| pairs.flat_map(&:first) }
      @document.leaves.select { |leaf| (entered - other).include?(leaf.id) }
    end

    # { ids of the leaves of a reachable configuration => whether the event enters a state from there }
    def configurations(event)
      pairs = @walk.reachable_pairs.select { |pair| pair.stimulus == [:event, event] }
      pairs.group_by { |pair| pair.before.leaves }.transform_values do |alike|
        alike.any? { |pair| pair.outcomes.any? { |outcome| outcome.taken.any? { |one| one.targets.any? } } }
      end
    end

    private

    def check_event(event)
      entered = configurations(event).select { |_, is_entered| is_entered }.keys
      refuse("\"#{event}\" enters no state; remove it from bs:enters") if entered.empty?
      reported = leaves(event).map(&:id)
      missed = entered.find { |ids| (ids & reported).empty? }
      return unless missed

      refuse("whether \"#{event}\" enters a state from #{missed.join(' ')} depends on several regions; remove it from bs:enters")
    end

    def refuse(message)
      raise Refusal.new(@document.file, @document.root.line, 42, message)
    end
  end
end
