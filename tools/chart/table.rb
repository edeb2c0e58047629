# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'json'
require_relative 'c_names'
require_relative 'diagram'

module Chart
  # charts.json: what the trace and the console know about all charts.
  class Table
    def self.emit(charts)
      "#{JSON.pretty_generate('charts' => charts.map { |chart| new(chart.document, chart.walk).to_h })}\n"
    end

    def initialize(document, walk)
      @document = document
      @walk = walk
      @names = CNames.new(document)
    end

    def to_h
      { 'name' => @document.name, 'file' => "statecharts/#{@document.name}.scxml", 'about' => @document.comment,
        'regions' => @document.regions.map { |region| region(region) },
        'states' => @document.states.map { |state| state(state) },
        'events' => @document.events.each_with_index.map { |event, value| event(event, value) },
        'inputs' => @document.inputs.map { |input| input(input) },
        'actions' => @document.actions.each_with_index.map { |action, bit| action(action, bit) },
        'timers' => @document.timers.map { |timer| timer(timer) },
        'transitions' => @document.transitions.map { |transition| transition(transition) },
        'invariants' => @document.invariants.map { |invariant| invariant(invariant) },
        'safe' => @document.safe.map(&:id), 'initial' => @walk.start.leaves,
        'configurations' => @walk.reached.length, 'pairs' => @walk.pair_count }
    end

    private

    def region(region)
      leaves = region.leaves.each_with_index.map do |leaf, value|
        { 'id' => leaf.id, 'enumerator' => @names.leaf(leaf), 'value' => value }
      end
      { 'name' => region.name, 'leaves' => leaves }
    end

    def state(state)
      { 'id' => state.id, 'kind' => state.kind.to_s, 'parent' => state.parent.id, 'initial' => state.initial&.id,
        'region' => @document.region_of(state)&.name, 'req' => state.req, 'line' => state.line,
        'svg_id' => Diagram.svg_id(@document, state) }
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
        'state' => timer.state.id, 'line' => timer.line }
    end

    def transition(transition)
      { 'id' => transition.id, 'number' => transition.number, 'region' => @document.region_of(transition.source).name,
        'source' => transition.source.id, 'event' => transition.event, 'cond' => transition.guard_text,
        'target' => transition.target&.id, 'actions' => transition.actions, 'raises' => transition.raises,
        'req' => transition.req, 'line' => transition.line }
    end

    def invariant(invariant)
      { 'id' => invariant.id, 'expr' => invariant.text, 'req' => invariant.req, 'line' => invariant.line }
    end
  end
end
