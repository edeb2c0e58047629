# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'json'
require_relative '../check/properties'
require_relative '../flatten/regions'
require_relative 'c/names'
require_relative 'diagram'
require_relative 'words'

module Chart
  # charts.json: what the console and other tools know about all charts. An svg_id is the id of an element of the
  # chart's drawing: of the live leaves by their values, of the transitions taken by their numbers.
  class Table
    def self.emit(charts)
      "#{JSON.pretty_generate('charts' => charts.map { |chart| new(chart.document, chart.walk).to_h })}\n"
    end

    def initialize(document, walk)
      @document = document
      @walk = walk
      @regions = Regions.new(document)
      @names = C::Names.new(document, @regions)
      @marks = Diagram.new(document).marks
    end

    def to_h
      about.merge('regions' => @regions.map { |one| region(one) },
                  'states' => @document.states.map { |one| state(one) },
                  'events' => @document.events.each_with_index.map { |one, value| event(one, value) },
                  'inputs' => @document.inputs.map { |one| input(one) },
                  'actions' => @document.actions.each_with_index.map { |one, bit| action(one, bit) },
                  'timers' => @document.timers.map { |one| timer(one) },
                  'transitions' => @document.transitions.map { |one| transition(one) },
                  'properties' => PropertyChecks.verdicts(@document, @walk).map { |one| property(one) })
    end

    private

    def about
      name = @document.name
      { 'name' => name, 'file' => "statecharts/#{name}.scxml", 'about' => @document.comment, 'svg' => "#{name}.svg",
        'tick_us' => @document.tick_us, 'safe' => @document.safe.map(&:id), 'initial' => @walk.start.after.leaves,
        'configurations' => @walk.reached.length, 'pairs' => @walk.pair_count,
        'bounds' => { 'most_microsteps' => @walk.most_microsteps, 'most_queued' => @walk.most_raised } }
    end

    # outer: the parallel state that the region lies in. A region without an active leaf has the value none.
    def region(region)
      values = @names.values(region)
      leaves = region.leaves.map do |leaf|
        { 'id' => leaf.id, 'enumerator' => @names.value(region, leaf), 'value' => values.index(leaf),
          'svg_id' => svg_id(leaf) }
      end
      { 'name' => region.name, 'outer' => region.outer&.id, 'none' => values.index(nil), 'leaves' => leaves }
    end

    def state(state)
      { 'id' => state.id, 'kind' => state.kind.to_s, 'parent' => state.parent.id, 'region' => @regions.of(state)&.name,
        'initial' => state.initial && state.initial.targets.map(&:id), 'entry' => Words.content(state.entry),
        'exit' => Words.content(state.exit), 'ignores' => state.ignores, 'req' => state.req,
        'hazards' => state.hazards, 'line' => state.line, 'svg_id' => svg_id(state) }
    end

    def svg_id(state)
      Diagram.svg_id(@document, state)
    end

    def event(event, value)
      { 'name' => event, 'enumerator' => @names.event(event), 'value' => value,
        'internal' => @document.internal_events.include?(event) }
    end

    def input(input)
      { 'name' => input.name, 'about' => input.comment, 'line' => input.line }
    end

    def action(action, bit)
      { 'name' => action, 'mask' => 1 << bit, 'macro' => @names.action(action) }
    end

    def timer(timer)
      { 'id' => timer.id, 'event' => timer.event, 'delay_us' => timer.delay_us, 'limit' => timer.limit,
        'rounding' => timer.rounding.to_s, 'ticks' => timer.threshold_us / @document.tick_us,
        'threshold_us' => timer.threshold_us, 'states' => Words.starters(@document, timer).map(&:id),
        'line' => timer.line }
    end

    def transition(transition)
      { 'id' => transition.id, 'number' => transition.number, 'region' => @regions.of(transition.source)&.name,
        'source' => transition.source.id, 'events' => transition.events, 'cond' => transition.guard_text,
        'targets' => transition.targets.map(&:id), 'internal' => transition.internal, 'actions' => transition.actions,
        'raises' => transition.raises, 'req' => transition.req, 'hazards' => transition.hazards,
        'line' => transition.line, 'svg_ids' => @marks.fetch(transition.id) }
    end

    def property(verdict)
      property = verdict.property
      { 'id' => property.id, 'kind' => property.kind.to_s, 'text' => property.text, 'req' => property.req,
        'hazards' => property.hazards, 'verdict' => verdict.verdict.to_s, 'checked' => verdict.checked,
        'line' => property.line }
    end
  end
end
