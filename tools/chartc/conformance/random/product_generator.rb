# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'generator'

module RandomCharts
  # A chart of the profile of products, by a seed: what the compiler knows of these only, of timers above all, goes into
  # their code. Rules that ask whether a chart is well meant are left out: overlaps, forgotten events, properties.
  class ProductGenerator < Generator
    EVENTS = %w[go stop go_on tick].freeze
    UNITS = { 'us' => 1, 'ms' => 1000, 's' => 1_000_000 }.freeze
    # Limit of a delay => microseconds.
    LIMITS = DELAYS.to_h { |text| ["limit_#{text}", text.to_i * UNITS.fetch(text[/[a-z]+/])] }
                   .merge('cycle_us' => 1000).freeze

    def chart
      super
      @root.attributes.update('name' => 'chart', 'initial' => @root.attributes['initial'] || some(below(@root)),
                              'bs:tick' => '1ms', 'bs:safe' => safe(@root).join(' '))
      forget_unheard
      declare_internal
      @root.all.each { |one| claim(one) }
      @root
    end

    private

    def safe(state)
      inside = state.states
      return [state.attributes['id']] if inside.empty?

      (state.name == 'parallel' ? inside : [pick(inside)]).flat_map { |one| safe(one) }
    end

    def claim(one)
      @claims = (@claims || 0) + 1
      one.attributes['bs:req'] = 'A-01' if one.state?
      return unless one.name == 'transition' && @parent_of_default.none? { |default| default.equal?(one) }

      one.attributes.update('bs:id' => "T-#{@claims}", 'bs:req' => 'A-01')
    end

    # What is raised, or sent, and waited for by nobody.
    def forget_unheard
      heard = @root.all.select { |one| one.name == 'transition' }.map { |one| one.attributes['event'] }
      silent = @root.all.select { |one| %w[raise send].include?(one.name) && !heard.include?(one.attributes['event']) }
      ids = silent.map { |one| one.attributes['id'] }.compact
      @root.all.each do |one|
        one.children.reject! { |child| silent.any? { |other| other.equal?(child) } }
        one.children.reject! { |child| ids.include?(child.attributes['sendid']) }
      end
    end

    def declare_internal
      raised = @root.all.select { |one| one.name == 'raise' }.map { |one| one.attributes['event'] }.uniq
      @root.attributes['bs:internal'] = raised.join(' ') if raised.any? && chance?(40)
    end

    def add_histories
      super
      @parent_of_default = @histories.keys.flat_map(&:children)
      @parent_of_default.each { |one| one.children.clear }
    end

    def begin_somewhere(state)
      state.attributes['initial'] = some(below(state))
    end

    def event
      roll = @random.rand(100)
      return pick(EVENTS) if roll < 75

      ended = @root.all.select { |one| one.name == 'state' && one.children.any? { |child| child.name == 'final' } }
      return "done.state.#{pick(ended).attributes['id']}" if ended.any? && roll < 88

      pick([*RAISED, 'late', 'late'])
    end

    # Raised events lead on: with many of them, transitions bring about each other, and the chart is refused. What a
    # timer says may be raised too.
    def content(percent)
      chance?(percent / 3) ? [node('raise', 'event' => pick([*RAISED, 'late']))] : []
    end

    def atom(eventless)
      chance?(eventless ? 100 : 50) ? "In('#{pick(states).attributes['id']}')" : pick(INPUTS)
    end

    # Each stands in the state that starts and stops it.
    def add_timers
      pick(0..3).times do |index|
        delay = pick(DELAYS)
        owner = chance?(50) && @timed ? @timed : pick(states)
        @timed = owner
        send = { 'id' => "t#{index}", 'event' => pick(%w[late late tick]), 'delay' => delay,
                 'bs:limit' => "limit_#{delay}", 'bs:kind' => pick(%w[watchdog hold_off]) }
        in_block(owner, 'onentry', node('send', send))
        in_block(owner, 'onexit', node('cancel', 'sendid' => "t#{index}"))
      end
    end

    # Inputs only.
    def declare
      said = @root.all.filter_map { |one| one.attributes['cond'] }.join(' ')
      read = INPUTS.select { |name| said.match?(/\b#{name}\b/) }
      data = read.map { |name| node('data', 'id' => name, 'expr' => 'false') }
      @root.children.unshift(node('datamodel', {}, data)) if data.any?
    end
  end
end
