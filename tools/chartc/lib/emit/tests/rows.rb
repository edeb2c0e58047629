# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../vector'
require_relative 'shared'

module Chart
  # The table of expected results, one row per pair and per group of input values with one result.
  class TestRows
    include TestShared

    def initialize(document, walk, names)
      @document = document
      @walk = walk
      @names = names
      @vector = Vector.new(document)
    end

    def tables
      ['static const pair_t pairs[] = {', @walk.pairs.flat_map { |pair| rows(pair) }, '};', '']
    end

    private

    def rows(pair)
      read = inputs_read(pair.outcomes)
      groups = pair.outcomes.each_index.group_by { |bits| bits & read }
      groups.keys.sort.map { |bits| row(pair, read, bits) }
    end

    # The inputs that change the outcome for some value of the others.
    def inputs_read(outcomes)
      @document.inputs.each_index.sum do |bit|
        differs = outcomes.each_index.any? { |bits| result(outcomes[bits]) != result(outcomes[bits ^ (1 << bit)]) }
        differs ? 1 << bit : 0
      end
    end

    def result(outcome)
      [outcome.after, outcome.started, outcome.actions, outcome.taken.last&.number]
    end

    def row(pair, read, bits)
      outcome = pair.outcomes[bits]
      kind, what = pair.stimulus
      event = kind == :event ? what : @document.events.first
      expiring = kind == :expire ? timer_mask(what) : 0
      cells = places(pair.before)
      cells += ["#{timer_mask(pair.before.armed)}U", "#{expiring}U"] if timers?
      cells << @names.event(event)
      cells += ["#{read}U", "#{bits}U"] if @document.inputs.any?
      "    { #{(cells + result_cells(outcome, pair.reachable)).join(', ')} },"
    end

    def result_cells(outcome, reachable)
      cells = places(outcome.after)
      cells += ["#{timer_mask(outcome.after.armed)}U", "#{timer_mask(outcome.started)}U"] if timers?
      cells << actions_cell(outcome.actions)
      cells + ["#{outcome.taken.last&.number || 0}U", reachable.to_s]
    end

    # The same for many rows.
    def places(snapshot)
      @places ||= {}
      (@places[[snapshot.leaves, snapshot.history]] ||= leaf_names(snapshot.leaves) + remembered(snapshot)).dup
    end

    # What the histories say, leaves or "none".
    def remembered(snapshot)
      memories = @vector.fields.zip(@vector.encode(snapshot)).select { |field, _number| field.kind == :memory }
      memories.map do |field, number|
        region = field.part.region
        @names.value(region, @names.values(region)[number])
      end
    end

    def leaf_names(ids)
      active = ids.map { |id| @document.state(id) }
      @names.regions.map do |region|
        @names.value(region, region.leaves.find { |leaf| active.any? { |one| one == leaf || one.inside?(leaf) } })
      end
    end
  end
end
