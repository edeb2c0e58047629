# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

module RandomCharts
  # An element of a chart, as the generator builds it and the minimiser takes it apart.
  Node = Struct.new(:name, :attributes, :children) do
    def all
      [self, *children.flat_map(&:all)]
    end

    def copy
      Node.new(name, attributes.dup, children.map(&:copy))
    end

    def state?
      %w[state parallel final].include?(name)
    end

    def states
      children.select(&:state?)
    end

    def xml(indent = '')
      words = attributes.map { |key, value| " #{key}=\"#{value.gsub('&', '&amp;').gsub('<', '&lt;')}\"" }.join
      return "#{indent}<#{name}#{words}/>\n" if children.empty?

      "#{indent}<#{name}#{words}>\n#{children.map { |child| child.xml("#{indent}  ") }.join}#{indent}</#{name}>\n"
    end
  end

  # A chart of the whole profile, of the engine's mode, by a seed.
  class Generator
    EVENTS = %w[go stop go.on tick].freeze
    RAISED = %w[echo reply].freeze
    NUMBERS = %w[level count].freeze
    BOOLEANS = %w[flag].freeze
    INPUTS = %w[door light].freeze
    ACTIONS = %w[open close].freeze
    MOST = 3
    # The last one is nearly all that a timer can count.
    DELAYS = %w[1ms 2ms 2500us 4ms 4ms 60s 4294967ms].freeze

    def initialize(seed)
      @random = Random.new(seed)
    end

    def chart
      @ids = 0
      @budget = pick(5..14)
      @root = node('scxml', 'xmlns' => 'http://www.w3.org/2005/07/scxml', 'xmlns:bs' => 'urn:boresight:chart',
                            'version' => '1.0', 'datamodel' => 'ecmascript')
      grow(@root, 0)
      link
      add_histories
      states.each { |state| behave(state) }
      add_timers
      declare
      @root
    end

    private

    def node(name, attributes = {}, children = [])
      Node.new(name, attributes, children)
    end

    def pick(from)
      from.is_a?(Range) ? @random.rand(from) : from[@random.rand(from.length)]
    end

    def chance?(percent)
      @random.rand(100) < percent
    end

    # --- the tree ------------------------------------------------------------------------------------------------

    def grow(parent, depth)
      least = parent.name == 'state' ? 1 : 2
      pick(least..3).times do |index|
        kind = kind(parent, depth, index)
        child = node(kind, 'id' => "s#{@ids += 1}")
        @budget -= 1
        parent.children << child
        next if kind == 'final'

        grow(child, depth + 1) if kind == 'parallel' || (@budget.positive? && depth < 4 && chance?(45))
      end
    end

    def kind(parent, depth, index)
      return 'state' if parent.name == 'parallel' && !(chance?(15) && depth < 4 && @budget.positive?)
      return 'parallel' if @budget.positive? && depth < 4 && chance?(35)

      parent.name != 'parallel' && index.positive? && chance?(25) ? 'final' : 'state'
    end

    def link
      @parent = {}.compare_by_identity
      @root.all.each { |one| one.children.each { |child| @parent[child] = one } }
    end

    def states
      @root.all.select(&:state?)
    end

    def ancestors(state)
      (above = @parent[state]) ? [above, *ancestors(above)] : []
    end

    def inside?(state, other)
      ancestors(state).any? { |one| one.equal?(other) }
    end

    def below(state)
      states.select { |one| inside?(one, state) }
    end

    # --- where states begin ----------------------------------------------------------------------------------------

    def add_histories
      @histories = {}.compare_by_identity
      states.select { |state| state.states.any? && chance?(25) }.each do |state|
        history = node('history', { 'id' => "h#{@ids += 1}", 'type' => pick(%w[shallow deep]) },
                       [node('transition', { 'target' => some(below(state)) }, content(10))])
        state.children.unshift(history)
        @histories[history] = state
      end
      [@root, *states].each { |state| begin_somewhere(state) if state.name != 'parallel' && state.states.any? }
    end

    def begin_somewhere(state)
      return if chance?(40)

      target = some(below(state))
      return state.attributes['initial'] = target if chance?(60) || state.name == 'scxml'

      state.children.unshift(node('initial', {}, [node('transition', { 'target' => target }, content(40))]))
    end

    # One state, or two of different regions of a parallel.
    def some(states)
      first = pick(states)
      others = states.select { |state| apart?(state, first) }
      chosen = others.any? && chance?(25) ? [first, pick(others)] : [first]
      chosen.map { |state| state.attributes['id'] }.join(' ')
    end

    def apart?(one, other)
      return false if one.equal?(other) || inside?(one, other) || inside?(other, one)

      ancestors(one).find { |state| inside?(other, state) }.name == 'parallel'
    end

    # --- what states do ----------------------------------------------------------------------------------------------

    def behave(state)
      pick(0..3).times { state.children << transition(state) } unless state.name == 'final'
      %w[onentry onexit].each do |moment|
        found = content(20)
        state.children << node(moment, actions, found) if found.any? || chance?(8)
      end
    end

    def actions
      chance?(50) ? { 'bs:do' => pick(ACTIONS) } : {}
    end

    def transition(source)
      made = node('transition', {}, content(30))
      made.attributes['event'] = event unless (eventless = chance?(9))
      made.attributes['target'] = target(source) if eventless || chance?(78)
      made.attributes['type'] = 'internal' if chance?(25)
      made.attributes['cond'] = condition(2, eventless) if eventless || chance?(35)
      made.attributes.merge!(actions) if chance?(30)
      made
    end

    def event
      roll = @random.rand(100)
      return pick(EVENTS) if roll < 62
      return pick(RAISED) if roll < 76
      return "done.state.#{pick(states).attributes['id']}" if roll < 88
      return %w[go stop].join(' ') if roll < 94

      pick(%w[go.* * late])
    end

    def target(source)
      histories = @histories.reject { |_history, parent| inside?(source, parent) }.keys
      histories.any? && chance?(25) ? pick(histories).attributes['id'] : some(states)
    end

    def content(percent)
      return [] unless chance?(percent)

      Array.new(pick(1..2)) { chance?(45) ? node('raise', 'event' => pick(RAISED)) : assign }
    end

    def assign
      return node('assign', 'location' => 'flag', 'expr' => pick(%w[true false !flag])) if chance?(25)

      name = pick(NUMBERS)
      other = (NUMBERS - [name]).first
      node('assign', 'location' => name, 'expr' => pick(['0', '1', '2', other, "#{MOST} - #{name}", "#{MOST} - #{other}"]))
    end

    def condition(depth, eventless)
      return atom(eventless) if depth.zero? || chance?(40)

      case @random.rand(3)
      when 0 then "!(#{condition(depth - 1, eventless)})"
      when 1 then "(#{condition(depth - 1, eventless)} && #{condition(depth - 1, eventless)})"
      else "(#{condition(depth - 1, eventless)} || #{condition(depth - 1, eventless)})"
      end
    end

    def atom(eventless)
      case @random.rand(eventless ? 3 : 4)
      when 0 then "In('#{pick(states).attributes['id']}')"
      when 1 then "#{pick(NUMBERS)} #{pick(%w[== != < <= > >=])} #{pick([0, 1, 2, 'level + 1', 'count - 1'])}"
      when 2 then pick(BOOLEANS)
      else pick(INPUTS)
      end
    end

    # --- time and data -----------------------------------------------------------------------------------------------

    # Most run inside their state; what starts one that runs is refused, and the next seed taken.
    def add_timers
      pick(0..2).times do |index|
        id = "t#{index}"
        send = node('send', 'id' => id, 'event' => pick(%w[late late tick]), 'delay' => pick(DELAYS))
        send.attributes['bs:kind'] = pick(%w[watchdog hold_off]) if chance?(30)
        owner = pick(states)
        in_block(owner, chance?(80) ? 'onentry' : 'onexit', send)
        in_block(owner, 'onexit', node('cancel', 'sendid' => id)) if chance?(85)
        in_block(pick(states), pick(%w[onentry onexit transition]), node('cancel', 'sendid' => id)) if chance?(30)
      end
    end

    def in_block(state, name, child)
      block = state.children.find { |one| one.name == name }
      state.children << (block = node(name)) if block.nil? && name != 'transition'
      block&.children&.insert(pick(0..block.children.length), child)
    end

    # What the chart speaks of.
    def declare
      said = @root.all.flat_map { |one| one.attributes.values_at('cond', 'expr', 'location') }.compact.join(' ')
      rows = NUMBERS.map { |name| { 'id' => name, 'expr' => '0', 'bs:min' => '0', 'bs:max' => MOST.to_s } } +
             BOOLEANS.map { |name| { 'id' => name, 'expr' => 'false' } } +
             INPUTS.map { |name| { 'id' => name, 'expr' => 'false', 'bs:input' => 'true' } }
      data = rows.select { |row| said.match?(/\b#{row['id']}\b/) }.map { |row| node('data', row) }
      @root.children.unshift(node('datamodel', {}, data)) if data.any?
    end
  end
end
