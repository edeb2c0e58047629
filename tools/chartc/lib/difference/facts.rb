# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../emit/words'

module Chart
  # What a chart means, without the place of anything: section => { id => { aspect => value } }. A value is one word
  # or number (nil for none), an Array of names without order, or a Sequence, where only the order counts.
  class Facts
    Sequence = Struct.new(:names)

    def self.of(chart)
      new(chart).to_h
    end

    def initialize(chart)
      @document = chart.document
      @walk = chart.walk
    end

    def to_h
      { 'chart' => { nil => whole }, 'event' => events, 'state' => states, 'transition' => transitions,
        'order' => orders, 'timer' => timers, 'variable' => variables, 'property' => properties,
        'size' => { nil => sizes } }
    end

    private

    def whole
      { 'initial' => default(@document.root), 'safe' => ids(@document.safe), 'tick' => duration(@document.tick_us) }
    end

    def sizes
      return {} unless @walk

      { 'configurations' => @walk.reached.length, 'pairs' => @walk.pair_count,
        'microsteps at most' => @walk.most_microsteps, 'raised events at most' => @walk.most_raised }
    end

    def events
      @document.events.to_h do |event|
        [event, { 'caused by' => @document.internal_events.include?(event) ? 'the chart alone' : 'outside' }]
      end
    end

    def states
      @document.states.to_h do |state|
        [state.id, { 'kind' => [state.depth, state.kind].compact.join(' '), 'in' => state.parent.id,
                     'initial' => default(state), 'entry' => content(state.entry), 'exit' => content(state.exit),
                     'ignores' => state.ignores, **claims(state) }]
      end
    end

    def default(state)
      return unless state.initial

      [state.initial.targets.map(&:id).sort.join(' + '), content(state.initial.content)].compact.join(' / ')
    end

    def transitions
      @document.transitions.to_h do |one|
        [one.id, { 'source' => one.source.id, 'events' => one.events, 'guard' => expression(one.guard),
                   'targets' => ids(one.targets), 'kind' => ('internal' if one.internal),
                   'actions' => content(one.content), **claims(one) }]
      end
    end

    def claims(one)
      { 'requirements' => one.req, 'hazards' => one.hazards }
    end

    # Where the place in the file has a meaning: transitions of one state that hear the same event, regions of a
    # parallel, timers that expire together.
    def orders
      parallels = @document.states.select(&:parallel?)
      regions = parallels.to_h { |state| ["of regions in #{state.id}", order(state.substates)] }
      heard.merge(regions, 'of timers' => order(@document.timers))
    end

    def heard
      @document.states.each_with_object({}) do |state, found|
        heads = state.transitions.flat_map { |one| heads(one).map { |head| [head, one] } }
        heads.group_by(&:first).each { |head, pairs| found["of #{head} in #{state.id}"] = order(pairs.map(&:last)) }
      end
    end

    def heads(transition)
      transition.eventless? ? ['at once'] : transition.events
    end

    def order(elements)
      { nil => Sequence.new(elements.map(&:id)) }
    end

    def timers
      @document.timers.to_h do |timer|
        [timer.id, { 'event' => timer.event, 'delay' => duration(timer.delay_us), 'limit' => timer.limit,
                     'rounds' => timer.rounding&.to_s, 'threshold' => duration(timer.threshold_us) }]
      end
    end

    def variables
      @document.variables.to_h do |one|
        [one.name, { 'kind' => one.kind.to_s, 'initial' => one.initial.to_s, 'minimum' => one.minimum,
                     'maximum' => one.maximum }]
      end
    end

    def properties
      @document.properties.to_h do |one|
        [one.id, { 'kind' => one.kind.to_s, 'on' => one.events, 'from' => expression(one.from),
                   'expression' => expression(one.expression), 'does' => one.does, 'starts' => ids(one.starts),
                   'stays' => (true if one.stays), 'steps' => one.steps, **claims(one) }]
      end
    end

    def ids(things)
      things.map(&:id)
    end

    def content(items)
      Words.content(items).join(', ') unless items.empty?
    end

    def expression(tree)
      tree && Words.expression(tree)
    end

    def duration(microseconds)
      microseconds && Words.duration(microseconds)
    end
  end
end
