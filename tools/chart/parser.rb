# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'expression'
require_relative 'model'
require_relative 'profile'
require_relative 'xml_reader'

module Chart
  # Turns a file into a Document: names resolved, ids unique, nothing outside the profile.
  class Parser
    DELAY = { 'ms' => 1000, 's' => 1_000_000 }.freeze

    # limits: name => microseconds
    def self.parse(file, text, limits)
      new(file, limits).parse(XmlReader.read(file, text))
    end

    def initialize(file, limits)
      @file = file
      @limits = limits
      @states = []
      @targets = {}.compare_by_identity
      @cancels = []
    end

    def parse(element)
      refuse(element.line, 2, "<#{element.name}> is not a chart; write <scxml>") unless element.name == 'scxml'
      Profile.check(@file, element)
      @document = Document.new(name: chart_name(element), file: @file, comment: element.comment)
      read_tree(element)
      read_data(element)
      resolve(element)
      @document
    end

    private

    def refuse(line, rule, message)
      raise Refusal.new(@file, line, rule, message)
    end

    def chart_name(element)
      name = element.attributes['name']
      expected = File.basename(@file, '.scxml')
      check_name(name, element.line)
      refuse(element.line, 6, "the chart is named #{name}; write name=\"#{expected}\"") unless name == expected
      name
    end

    def check_name(name, line)
      return if name.match?(Profile::NAME)

      refuse(line, 6, "\"#{name}\" is no name here; write lower-case words joined by underscores, one name only")
    end

    def read_tree(element)
      @document.root = State.new(id: nil, kind: :root, children: [], transitions: [], timers: [], req: [],
                                 line: element.line, order: -1)
      add_children(element, @document.root)
      @document.states = @states
      @document.transitions = @targets.keys
      @document.transitions.each.with_index(1) { |transition, number| transition.number = number }
      @document.timers = @states.flat_map(&:timers)
    end

    def add_children(element, parent)
      element.children.each do |child|
        case child.name
        when 'state', 'parallel' then parent.children << read_state(child, parent)
        when 'transition' then parent.transitions << read_transition(child, parent)
        when 'onentry' then child.children.each { |send| parent.timers << read_timer(send, parent) }
        when 'onexit' then child.children.each { |cancel| @cancels << [cancel, parent] }
        end
      end
    end

    def read_state(element, parent)
      id = element.attributes['id']
      check_name(id, element.line)
      twin = @states.find { |state| state.id == id }
      refuse(element.line, 5, "state \"#{id}\" stands in line #{twin.line} already; choose another id") if twin
      state = State.new(id: id, kind: kind_of(element), parent: parent, children: [], transitions: [], timers: [],
                        req: requirements(element), line: element.line, order: @states.length,
                        comment: element.comment)
      @states << state
      add_children(element, state)
      check_state(element, state)
      state
    end

    def kind_of(element)
      return :parallel if element.name == 'parallel'

      element.children.any? { |child| child.name == 'state' } ? :compound : :leaf
    end

    def check_state(element, state)
      state.initial = initial_of(element, state) if state.kind == :compound
      if state.leaf? && element.attributes.key?('initial')
        refuse(element.line, 7, "leaf \"#{state.id}\" has nothing to start in; remove initial")
      end
      return unless state.leaf? && state.req.empty?

      refuse(element.line, 9, "state \"#{state.id}\" names no requirement; add bs:req=\"SWR-...\"")
    end

    def initial_of(element, state)
      children = state.children.map(&:id)
      id = element.attributes['initial']
      state.children.find { |child| child.id == id } ||
        refuse(element.line, 7, "#{id ? "initial \"#{id}\" is no child" : 'initial is missing'}; " \
                                "write one of: #{children.join(', ')}")
    end

    def requirements(element)
      words = element.attributes.fetch('bs:req', '').split
      words.each do |word|
        next if word.match?(Profile::REQUIREMENT)

        refuse(element.line, 9, "\"#{word}\" is no requirement id; write SWR-AREA-nnn")
      end
      words
    end

    def read_transition(element, source)
      attributes = element.attributes
      check_transition(element)
      transition = Transition.new(id: attributes['bs:id'], source: source, event: attributes['event'],
                                  guard_text: attributes['cond'], internal: attributes['type'] == 'internal',
                                  actions: attributes.fetch('bs:do', '').split, req: requirements(element),
                                  raises: element.children.map { |child| child.attributes['event'] },
                                  line: element.line)
      @targets[transition] = attributes['target']
      transition.actions.each { |action| check_name(action, element.line) }
      transition
    end

    def check_transition(element)
      id = element.attributes['bs:id']
      event = element.attributes['event']
      refuse(element.line, 10, 'the transition waits for nothing; add event="..."') if event.to_s.empty?
      check_name(event, element.line)
      refuse(element.line, 8, 'the transition has no id; add bs:id="NAME-Tnn"') unless id
      refuse(element.line, 8, "\"#{id}\" is no id; write NAME-Tnn") unless id.match?(Profile::TRANSITION_ID)
      refuse(element.line, 9, "#{id} names no requirement; add bs:req=\"SWR-...\"") if requirements(element).empty?
      return if [nil, 'internal', 'external'].include?(element.attributes['type'])

      refuse(element.line, 3, 'type is unknown; write internal or external')
    end

    def read_timer(element, state)
      attributes = element.attributes
      check_name(attributes['id'], element.line)
      check_name(attributes['event'], element.line)
      Timer.new(id: attributes['id'], event: attributes['event'], delay_us: delay_us(element),
                limit: attributes['bs:limit'], state: state, line: element.line)
    end

    def delay_us(element)
      delay = element.attributes['delay']
      number, unit = delay.match(/\A(\d+)(ms|s)\z/)&.captures
      refuse(element.line, 15, "delay \"#{delay}\" is no constant; write a whole number of ms or s") unless unit
      name = element.attributes['bs:limit']
      limit = @limits.fetch(name) do
        known = @limits.keys.grep(/_us\z/).sort.join(', ')
        refuse(element.line, 15, "limit #{name} is unknown; write one of: #{known}")
      end
      found = number.to_i * DELAY.fetch(unit)
      return found if found == limit

      refuse(element.line, 15, "the delay is #{found} us but #{name} is #{limit} us; " \
                               "write delay=\"#{in_words(limit)}\"")
    end

    def in_words(microseconds)
      (microseconds % 1_000_000).zero? ? "#{microseconds / 1_000_000}s" : "#{microseconds / 1000}ms"
    end

    def read_data(element)
      data = element.children.select { |child| child.name == 'datamodel' }.flat_map(&:children)
      @document.inputs = data.map { |datum| read_input(datum) }
      @document.inputs.group_by(&:name).each_value do |same|
        refuse(same[1].line, 5, "input \"#{same[1].name}\" stands twice; remove one") if same.length > 1
      end
    end

    def read_input(datum)
      name = datum.attributes['id']
      check_name(name, datum.line)
      refuse(datum.line, 14, 'inputs are booleans; write expr="false"') unless datum.attributes['expr'] == 'false'
      Input.new(name: name, comment: datum.comment, line: datum.line)
    end

    def resolve(element)
      check_parallel(element)
      @document.root.initial = initial_of(element, @document.root)
      @targets.each { |transition, id| resolve_transition(transition, id) }
      check_transition_ids
      check_timers
      read_invariants(element)
      read_safe(element)
      read_internal(element)
    end

    def check_parallel(element)
      parallel = @states.find { |state| state.kind == :parallel }
      return unless parallel

      alone = @document.root.children.length == 1
      refuse(parallel.line, 16, 'a parallel stands alone in <scxml>; move the other states into it') unless alone
      leaf = parallel.children.find(&:leaf?)
      refuse(leaf.line, 16, "region \"#{leaf.id}\" has no states; give it some, or remove it") if leaf
      return if parallel.children.length > 1

      refuse(element.line, 16, 'a parallel of one region is a plain chart; remove <parallel>')
    end

    def resolve_transition(transition, id)
      transition.guard = read_guard(transition.guard_text, transition.line) if transition.guard_text
      return unless id

      transition.target = @document.state(id)
      return if transition.target

      refuse(transition.line, 7, "target \"#{id}\" is no state; write one of: #{@states.map(&:id).join(', ')}")
    end

    def read_guard(text, line)
      expression = Expression.parse(text)
      Expression.atoms(expression).each { |kind, name| check_atom(kind, name, line) }
      expression
    rescue Expression::Unsupported => e
      refuse(line, 14, "\"#{text}\": #{e.message}; write In('state'), inputs, ! && || and parentheses")
    end

    def check_atom(kind, name, line)
      if kind == :in
        return if @document.state(name)

        refuse(line, 13, "In('#{name}') names no state; write one of: #{@states.map(&:id).join(', ')}")
      end
      inputs = @document.inputs.map(&:name)
      return if inputs.include?(name)

      refuse(line, 14, "\"#{name}\" is no declared input; write <data id=\"#{name}\" expr=\"false\"/> or one of: " \
                       "#{inputs.join(', ')}")
    end

    def check_transition_ids
      @document.transitions.group_by(&:id).each_value do |same|
        next if same.length == 1

        refuse(same[1].line, 8, "#{same[1].id} stands in line #{same[0].line} already; choose another bs:id")
      end
    end

    def check_timers
      @document.timers.group_by(&:id).each_value do |same|
        refuse(same[1].line, 5, "send \"#{same[1].id}\" stands twice; choose another id") if same.length > 1
      end
      @document.timers.each { |timer| check_cancelled(timer) }
      @cancels.each { |element, state| check_cancel(element, state) }
    end

    def check_cancelled(timer)
      cancelled = @cancels.any? do |element, state|
        state == timer.state && element.attributes['sendid'] == timer.id
      end
      return if cancelled

      refuse(timer.line, 12, "timer \"#{timer.id}\" outlives state \"#{timer.state.id}\"; add " \
                             "<onexit><cancel sendid=\"#{timer.id}\"/></onexit> to the state")
    end

    def check_cancel(element, state)
      id = element.attributes['sendid']
      return if state.timers.any? { |timer| timer.id == id }

      refuse(element.line, 12, "state \"#{state.id}\" does not start timer \"#{id}\"; cancel it where it is sent")
    end

    def read_invariants(element)
      found = element.children.select { |child| child.name == 'bs:invariant' }
      @document.invariants = found.map do |child|
        id = child.attributes['id']
        refuse(child.line, 8, 'the invariant has no id; add id="NAME-Inn"') unless id
        refuse(child.line, 9, "#{id} names no requirement; add bs:req=\"SWR-...\"") if requirements(child).empty?
        Invariant.new(id: id, req: requirements(child), text: child.attributes['expr'], line: child.line,
                      expression: read_guard(child.attributes['expr'], child.line))
      end
      check_invariants
    end

    def check_invariants
      @document.invariants.group_by(&:id).each_value do |same|
        refuse(same[1].line, 8, "#{same[1].id} stands twice; choose another id") if same.length > 1
      end
      @document.invariants.each do |invariant|
        input = Expression.atoms(invariant.expression).find { |kind, _name| kind == :input }
        next unless input

        refuse(invariant.line, 14, "an invariant speaks of states only; remove \"#{input[1]}\"")
      end
    end

    def read_safe(element)
      ids = element.attributes['bs:safe'].split
      leaves = @document.regions.map { |region| region.leaves.select { |leaf| ids.include?(leaf.id) } }
      fits = ids.length == leaves.length && leaves.all? { |found| found.length == 1 }
      regions = @document.regions.map { |region| "one of #{region.leaves.map(&:id).join('|')}" }
      refuse(element.line, 18, "bs:safe does not fit; write #{regions.join(' and ')}") unless fits
      @document.safe = leaves.flatten
    end

    def read_internal(element)
      @document.internal_events = element.attributes.fetch('bs:internal', '').split
      raised = @document.transitions.flat_map(&:raises)
      stray = (@document.internal_events - raised).first
      return unless stray

      refuse(element.line, 7, "bs:internal names \"#{stray}\", which nothing raises; " \
                              "write one of: #{raised.uniq.join(', ')}")
    end
  end
end
