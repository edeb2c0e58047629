# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../model'
require_relative 'outcome'

module Chart
  # The configurations that the tree of states allows, reached or not, for charts that remember nothing else.
  module Legal
    MOST = 5000

    module_function

    # Each with the timers that entering its states starts; [] when the chart has histories, data, or too many.
    def snapshots(document)
      return [] if document.histories.any? || document.data.any? || count(document.root) > MOST

      configurations(document.root).map do |leaves|
        Snapshot.new(leaves.map(&:id).freeze, {}.freeze, {}.freeze, timers(document, leaves).freeze).freeze
      end
    end

    def count(state)
      return 1 if state.leaf?

      counts = state.substates.map { |child| count(child) }
      state.parallel? ? counts.reduce(:*) : counts.sum
    end

    # Lists of leaves in document order.
    def configurations(state)
      return [[state]] if state.leaf?

      first, *rest = state.substates.map { |child| configurations(child) }
      state.parallel? ? first.product(*rest).map(&:flatten) : [first, *rest].flatten(1)
    end

    def timers(document, leaves)
      active = leaves + leaves.flat_map(&:ancestors)
      started = active.uniq.flat_map(&:entry).grep(Send).map { |send| send.timer.id }
      document.timers.map(&:id) & started
    end
  end
end
