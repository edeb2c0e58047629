# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'rexml/document'

module RandomCharts
  # The algorithm of the W3C's SCXML 1.0, appendix D, written from its text with its names, and our clock for delayed
  # sends (docs/charts.md, 7 and 8). It reads the file by itself and shares nothing with the compiler.
  class AppendixD
    # kind: the element's name; initial and content: of the default transition.
    State = Struct.new(:id, :kind, :parent, :order, :element, :children, :transitions, :initial, :content) do
      # A state is itself, whatever it holds.
      def ==(other)
        equal?(other)
      end
      alias_method :eql?, :==

      def hash
        order
      end

      def ancestors
        parent ? [parent, *parent.ancestors] : []
      end

      def inside?(other)
        ancestors.include?(other)
      end

      def atomic?
        kind == 'final' || (kind == 'state' && states.empty?)
      end

      def compound?
        kind == 'scxml' || (kind == 'state' && states.any?)
      end

      def parallel?
        kind == 'parallel'
      end

      def history?
        kind == 'history'
      end

      def states
        children.reject(&:history?)
      end
    end

    Transition = Struct.new(:number, :source, :events, :cond, :targets, :internal, :content)
    Timer = Struct.new(:id, :event, :threshold_us)

    # What a chart shows after a step; taken: numbers of transitions in document order.
    Seen = Struct.new(:leaves, :history, :data, :armed, :actions, :taken, keyword_init: true)

    # A macrostep that goes on and on.
    class Endless < StandardError; end

    STATES = %w[state parallel final history].freeze
    MOST_MICROSTEPS = 500
    UNITS = { 'us' => 1, 'ms' => 1000, 's' => 1_000_000 }.freeze

    # faults: rules that the last step broke, of those that only running shows.
    attr_reader :inputs, :outside, :inside, :faults

    def initialize(text)
      chart = REXML::Document.new(text).root
      @states = []
      @number = 0
      @root = read_state(chart, nil)
      @by_id = @states.to_h { |state| [state.id, state] }
      read_data(chart)
      read_timers(chart)
      read_events(chart)
      @code = {}
      @blocks = Hash.new { |found, key| found[key] = key.first.element.get_elements(key.last) }
      @pieces = {}.compare_by_identity
    end

    def start
      @configuration = []
      @history = {}
      @data = @first_data.dup
      @armed = {}
      begin_step({})
      enter_states([Transition.new(nil, @root, [], nil, @root.initial, false, [])])
      settle
      seen
    end

    # Events of timers, of states that can be done and those of bs:internal do nothing when they come from outside.
    def dispatch(event, inputs)
      begin_step(inputs)
      macrostep(event) unless @inside.include?(event)
      seen
    end

    # All timers move; those that reached their delay expire in document order, each to the end.
    def advance(elapsed_us, inputs)
      begin_step(inputs)
      @armed.transform_values! { |time| time + elapsed_us }
      expire_due
      seen
    end

    # A number from outside that is no event.
    def ignore(inputs)
      begin_step(inputs)
      seen
    end

    # These timers, of those that run, have reached their delay.
    def expire(ids, inputs)
      begin_step(inputs)
      @timers.each { |timer| @armed[timer.id] = timer.threshold_us if ids.include?(timer.id) && @armed.key?(timer.id) }
      expire_due
      seen
    end

    def armed
      @timers.map(&:id).uniq & @armed.keys
    end

    # What it goes on from; how long timers have run is no part of it.
    def memory
      [@configuration.sort_by(&:order), @history, @data, armed]
    end

    def memory=(memory)
      @configuration, @history, @data = memory.first(3).map(&:dup)
      @armed = memory.last.to_h { |id| [id, 0] }
    end

    # Whether an event from outside would be taken.
    def awaits?(event, inputs)
      @with = inputs
      !@inside.include?(event) && select_transitions(event).any?
    end

    private

    # --- reading -----------------------------------------------------------------------------------------------------

    def read_state(element, parent)
      state = State.new(element.attributes['id'], element.name, parent, @states.length, element, [], [], [], [])
      @states << state
      element.elements.each do |child|
        state.children << read_state(child, state) if STATES.include?(child.name)
        state.transitions << read_transition(child, state) if child.name == 'transition' && !state.history?
      end
      read_default(element, state)
      state
    end

    def read_transition(element, source)
      @number += 1
      Transition.new(@number, source, element.attributes['event'].to_s.split, element.attributes['cond'],
                     element.attributes['target'].to_s.split, element.attributes['type'] == 'internal', [element])
    end

    def read_default(element, state)
      chosen = element.elements['initial/transition'] || (state.history? && element.elements['transition']) || nil
      state.initial = (chosen || element).attributes[chosen ? 'target' : 'initial'].to_s.split
      state.initial = state.states.first(1).map(&:id) if state.initial.empty? && state.compound?
      state.content = [chosen].compact
    end

    def read_data(chart)
      product = chart.attributes['bs:safe']
      found = chart.elements.to_a('datamodel/data').partition { |data| product || data.attributes['bs:input'] == 'true' }
      @bounds = found.last.to_h { |data| [data.attributes['id'], bounds(data)] }
      @inputs = found.first.map { |data| data.attributes['id'] }
      @first_data = found.last.to_h { |data| [data.attributes['id'], literal(data.attributes['expr'])] }
    end

    def bounds(data)
      range = data.attributes.values_at('bs:min', 'bs:max').compact.map { |text| Integer(text) }
      Range.new(*range) if range.any?
    end

    def literal(text)
      %w[true false].include?(text) ? text == 'true' : Integer(text)
    end

    def read_timers(chart)
      tick = microseconds(chart.attributes['bs:tick'] || '1ms')
      sends = chart.get_elements('//send').reject { |send| send.attributes['target'] }
      @timers = sends.map do |send|
        delay = Rational(microseconds(send.attributes['delay'] || '0s'), tick)
        ticks = send.attributes['bs:kind'] == 'watchdog' ? delay.floor : delay.ceil
        Timer.new(send.attributes['id'], send.attributes['event'], [ticks, 1].max * tick)
      end
    end

    def microseconds(text)
      (Rational(text[/[\d.]+/]) * UNITS.fetch(text[/[a-z]+/])).to_i
    end

    def read_events(chart)
      words = %w[transition raise send].flat_map { |name| chart.get_elements("//#{name}") }
      words = words.flat_map { |element| element.attributes['event'].to_s.split }
      @outside = words.map { |word| word.delete_suffix('*').delete_suffix('.') }.uniq - ['']
      done = @states.select { |state| can_be_done?(state) }.map { |state| "done.state.#{state.id}" }
      @inside = @timers.map(&:event) + chart.attributes['bs:internal'].to_s.split + done
    end

    def can_be_done?(state)
      return state.states.all? { |one| can_be_done?(one) } if state.parallel?

      state.states.any? { |one| one.kind == 'final' }
    end

    # --- the algorithm -----------------------------------------------------------------------------------------------

    def expire_due
      @timers.each do |timer|
        next unless @armed.fetch(timer.id, 0) >= timer.threshold_us

        @armed.delete(timer.id)
        macrostep(timer.event)
      end
    end

    def begin_step(inputs)
      @with = inputs
      @taken = []
      @actions = []
      @queue = []
      @faults = []
    end

    def macrostep(event)
      microstep(select_transitions(event))
      settle
    end

    def settle
      loop do
        enabled = select_transitions(nil)
        break if enabled.empty? && @queue.empty?

        microstep(enabled.empty? ? select_transitions(@queue.shift) : enabled)
        raise Endless if @taken.length > MOST_MICROSTEPS
      end
    end

    def microstep(transitions)
      exit_states(transitions)
      transitions.each { |transition| execute(transition.content) }
      enter_states(transitions)
      @taken.concat(transitions.map(&:number))
    end

    def select_transitions(event)
      enabled = @configuration.select(&:atomic?).sort_by(&:order).filter_map do |atomic|
        [atomic, *atomic.ancestors].flat_map(&:transitions).find { |one| matches?(one, event) && holds?(one.cond) }
      end
      remove_conflicting(enabled.uniq(&:number))
    end

    def matches?(transition, event)
      return transition.events.empty? if event.nil?

      transition.events.any? do |word|
        prefix = word.delete_suffix('*').delete_suffix('.')
        word == '*' || event == prefix || event.start_with?("#{prefix}.")
      end
    end

    def remove_conflicting(enabled)
      enabled.each_with_object([]) do |first, filtered|
        rivals = filtered.select { |second| (exit_set([first]) & exit_set([second])).any? }
        next if rivals.any? { |second| !first.source.inside?(second.source) }

        rivals.each { |second| filtered.delete(second) }
        filtered << first
      end
    end

    def exit_set(transitions)
      transitions.reject { |one| one.targets.empty? }.flat_map do |transition|
        domain = domain(transition)
        @configuration.select { |state| state.inside?(domain) }
      end.uniq
    end

    def exit_states(transitions)
      leaving = exit_set(transitions).sort_by(&:order).reverse
      leaving.each do |state|
        state.children.select(&:history?).each do |history|
          deep = history.element.attributes['type'] == 'deep'
          @history[history.id] = @configuration.select do |one|
            deep ? one.atomic? && one.inside?(state) : one.parent == state
          end
        end
      end
      leaving.each do |state|
        execute(@blocks[[state, 'onexit']])
        @configuration.delete(state)
      end
    end

    def enter_states(transitions)
      compute_entry_set(transitions)
      @to_enter.uniq.sort_by(&:order).each do |state|
        @configuration << state
        execute(@blocks[[state, 'onentry']])
        execute(state.content) if @default_entry.include?(state)
        execute(@history_content.fetch(state.id, []))
        finish(state) if state.kind == 'final' && state.parent.parent
      end
    end

    def finish(state)
      @queue << "done.state.#{state.parent.id}"
      above = state.parent.parent
      @queue << "done.state.#{above.id}" if above.parallel? && above.states.all? { |one| in_final_state?(one) }
    end

    def in_final_state?(state)
      return state.states.all? { |one| in_final_state?(one) } if state.parallel?

      state.compound? && state.states.any? { |one| one.kind == 'final' && @configuration.include?(one) }
    end

    def compute_entry_set(transitions)
      @to_enter = []
      @default_entry = []
      @history_content = {}
      transitions.reject { |one| one.targets.empty? }.each do |transition|
        targets(transition.targets).each { |state| add_descendants(state) }
        effective_targets(transition.targets).each { |state| add_ancestors(state, domain(transition)) }
      end
    end

    def add_descendants(state)
      return add_history(state) if state.history?

      @to_enter << state
      @default_entry << state if state.compound?
      add_all(targets(state.initial), state) if state.compound?
      add_regions(state) if state.parallel?
    end

    def add_history(history)
      recorded = @history[history.id]
      @history_content[history.parent.id] = history.content unless recorded
      add_all(recorded || targets(history.initial), history.parent)
    end

    def add_all(states, ancestor)
      states.each { |state| add_descendants(state) }
      states.each { |state| add_ancestors(state, ancestor) }
    end

    def add_ancestors(state, ancestor)
      state.ancestors.take_while { |one| one != ancestor }.each do |one|
        @to_enter << one
        add_regions(one) if one.parallel?
      end
    end

    def add_regions(parallel)
      parallel.states.each do |child|
        add_descendants(child) unless @to_enter.any? { |state| state.inside?(child) }
      end
    end

    def domain(transition)
      states = effective_targets(transition.targets)
      source = transition.source
      return source if transition.internal && source.compound? && states.all? { |state| state.inside?(source) }

      source.ancestors.find { |one| one.compound? && states.all? { |state| state.inside?(one) } }
    end

    def effective_targets(ids)
      targets(ids).flat_map do |state|
        next [state] unless state.history?

        @history[state.id] || effective_targets(state.initial)
      end.uniq
    end

    def targets(ids)
      ids.map { |id| @by_id.fetch(id) }
    end

    # --- content and expressions -------------------------------------------------------------------------------------

    def execute(blocks)
      blocks.each do |block|
        actions, elements = @pieces[block] ||= pieces(block)
        @actions |= actions
        elements.each { |name, attributes| perform(name, attributes) }
      end
    end

    # Looking into the file takes time.
    def pieces(block)
      [block.attributes['bs:do'].to_s.split, block.elements.map { |one| [one.name, attributes(one)] }]
    end

    def attributes(element)
      element.attributes.each_attribute.to_h { |one| [one.expanded_name, one.value] }
    end

    def perform(name, attributes)
      case name
      when 'raise' then @queue << attributes['event']
      when 'send' then attributes['target'] ? @queue << attributes['event'] : arm(attributes['id'])
      when 'cancel' then @armed.delete(attributes['sendid'])
      when 'assign' then assign(attributes['location'], value(attributes['expr']))
      end
    end

    def arm(id)
      @faults << 33 if @armed.key?(id)
      @armed[id] = 0
    end

    def assign(name, value)
      @faults << 34 if @bounds.fetch(name)&.include?(value) == false
      @data[name] = value
    end

    def holds?(condition)
      condition.nil? || value(condition)
    end

    # What the profile has of ECMAScript is Ruby as it stands, once In() and names are questions.
    def value(text)
      code = @code[text] ||= instance_eval("-> { #{in_ruby(text)} }", __FILE__, __LINE__)
      code.call
    end

    def in_ruby(text)
      text.gsub(/In\('([^']+)'\)|[a-z]\w*/) do |word|
        next "active?('#{Regexp.last_match(1)}')" if Regexp.last_match(1)

        %w[true false].include?(word) ? word : "named('#{word}')"
      end
    end

    def active?(id)
      @configuration.any? { |state| state.id == id }
    end

    def named(name)
      @data.fetch(name) { @with.fetch(name, false) }
    end

    def seen
      leaves = @configuration.select(&:atomic?)
      Seen.new(leaves: ids(leaves), history: @history.transform_values { |states| ids(states) }, data: @data.dup,
               armed: @timers.map(&:id).uniq.select { |id| @armed.key?(id) }, actions: @actions.sort, taken: @taken)
    end

    def ids(states)
      states.sort_by(&:order).map(&:id)
    end
  end
end
