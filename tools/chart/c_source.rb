# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'c_condition'
require_relative 'c_layout'
require_relative 'c_names'
require_relative 'c_public'
require_relative 'flat'

module Chart
  # The C of one chart: one function per transition, one per leaf, one switch per region.
  # Only the statement forms in this file can come out; that is the whole list to review.
  class CSource
    include CLayout
    include CPublic

    def initialize(document)
      @document = document
      @names = CNames.new(document)
      @flat = Flat.new(document)
      @condition = CCondition.new(document, @names)
    end

    def emit
      text([banner(@document, 'Code'), '', "#include \"#{@document.name}_chart.h\"", '', delays, raised,
            local_functions, @document.transitions.map { |transition| transition_function(transition) },
            @document.regions.map { |region| region_functions(region) },
            microstep, macrostep, public_functions].compact)[0..-2]
    end

    private

    # --- the parameters that each function needs, by name ------------------------------------

    PARAMETERS = %i[self before inputs event raised].freeze

    def declare(parameters)
      types = { self: "#{@names.chart_type} *self", before: "const #{@names.chart_type} *before",
                inputs: "const #{@names.inputs_type} *inputs", event: "#{@names.event_type} event",
                raised: "#{@names.raised_type} *raised" }
      parameters.map { |parameter| types.fetch(parameter) }
    end

    def ordered(*parameters)
      PARAMETERS & parameters.flatten
    end

    def transition_needs(transition)
      ordered(:self, transition.raises.any? ? :raised : nil)
    end

    def decision_needs(decision)
      case decision
      when nil then []
      when Transition then transition_needs(decision)
      else
        atom = decision.atom.first == :in ? :before : :inputs
        ordered(atom, decision_needs(decision.yes), decision_needs(decision.no))
      end
    end

    def leaf_needs(leaf)
      ordered(:self, :event, @flat.decisions(leaf).values.map { |decision| decision_needs(decision) })
    end

    def busy_leaves(region)
      region.leaves.reject { |leaf| @flat.decisions(leaf).empty? }
    end

    def region_needs(region)
      ordered(:self, :event, busy_leaves(region).map { |leaf| leaf_needs(leaf) })
    end

    def step_needs
      needs = ordered(:self, :event, @document.regions.map { |region| region_needs(region) })
      needs - [:before]
    end

    # --- file-local types and functions -------------------------------------------------------

    def delays
      return [] if @document.timers.empty?

      @document.timers.map { |timer| "#define #{@names.delay(timer)} #{timer.delay_us}U /* #{timer.limit} */" } + ['']
    end

    def raised
      return [] unless @document.raises?

      bound = "#{@names.macro}_RAISED_MAX"
      [comment('The most events that one event can raise, directly and through those it raises.'),
       "#define #{bound} #{@flat.raise_bound}U", '',
       'typedef struct {', "    #{@names.event_type} events[#{bound}];", '    uint32_t count;',
       "} #{@names.raised_type};", '', raise_function]
    end

    def raise_function
      head = "static void #{@names.function('raise_event')}"
      [call(head, declare(%i[raised event]), ''), '{', '    raised->events[raised->count] = event;',
       '    raised->count++;', '}', '']
    end

    def local_functions
      [@document.regions.map { |region| enter_function(region) }, timer_functions]
    end

    def enter_function(region)
      head = "static void #{@names.function("enter_#{region.name}")}"
      [call(head, ["#{@names.chart_type} *self", "#{@names.region_type(region)} leaf"], ''), '{',
       "    self->#{region.name} = leaf;", "    self->#{region.name}_inverse = ~(uint32_t)leaf;", '}', '']
    end

    def timer_functions
      return [] if @document.timers.empty?

      saturate = ["static uint32_t #{@names.function('add_saturated')}(uint32_t sum_us, uint32_t elapsed_us)", '{',
                  '    return (elapsed_us > (UINT32_MAX - sum_us)) ? UINT32_MAX : (sum_us + elapsed_us);', '}', '']
      [@document.timers.map { |timer| [set_timer('start', timer, true), set_timer('stop', timer, false)] }, saturate]
    end

    def set_timer(verb, timer, armed)
      ["static void #{@names.function("#{verb}_#{timer.id}")}(#{@names.chart_type} *self)", '{',
       "    self->#{timer.id}_us = 0U;", "    self->#{timer.id}_is_armed = #{armed};", '}', '']
    end

    def start_timer(timer)
      "#{@names.function("start_#{timer.id}")}(self);"
    end

    def stop_timer(timer)
      "#{@names.function("stop_#{timer.id}")}(self);"
    end

    # --- transitions --------------------------------------------------------------------------

    def transition_function(transition)
      head = "static uint32_t #{@names.take(transition)}"
      [transition_comment(transition), call(head, declare(transition_needs(transition)), ''), '{',
       transition_body(transition), '}', '']
    end

    def transition_comment(transition)
      from = transition.source.id || @document.name
      to = transition.target ? " to #{transition.target.id}" : ''
      guard = transition.guard_text ? " if #{transition.guard_text}" : ''
      comment("#{transition.id} (#{transition.req.join(' ')}), #{@document.name}.scxml line #{transition.line}: " \
              "#{from}#{to} on #{transition.event}#{guard}.")
    end

    def transition_body(transition)
      started = @flat.started(transition)
      stopped = @flat.cancelled(transition) - started
      lines = stopped.map { |timer| stop_timer(timer) }
      lines << enter_target(transition) if transition.target
      lines += started.map { |timer| start_timer(timer) }
      lines << "self->last_transition = #{transition.number}U;"
      lines += transition.raises.map { |event| "#{@names.function('raise_event')}(raised, #{@names.event(event)});" }
      lines << "return #{action_mask(transition.actions)};"
      lines.map { |line| "    #{line}" }
    end

    def enter_target(transition)
      leaf = @flat.entered_leaf(transition.target)
      region = @document.region_of(leaf)
      "#{@names.function("enter_#{region.name}")}(self, #{@names.leaf(leaf)});"
    end

    def action_mask(actions)
      masks = actions.map { |action| @names.action(action) }
      masks.length > 1 ? "(#{masks.join(' | ')})" : masks.fetch(0, '0U')
    end

    # --- leaves and regions -------------------------------------------------------------------

    def region_functions(region)
      [busy_leaves(region).map { |leaf| leaf_function(region, leaf) }, region_function(region)]
    end

    def leaf_name(region, leaf)
      @names.function("#{region.name}_in_#{leaf.id}")
    end

    def leaf_function(region, leaf)
      head = "static uint32_t #{leaf_name(region, leaf)}"
      [call(head, declare(leaf_needs(leaf)), ''), '{', '    uint32_t actions = 0U;', '', event_chain(leaf),
       '    return actions;', '}', '']
    end

    def event_chain(leaf)
      decisions = @flat.decisions(leaf)
      rows = decisions.each_with_index.map do |(event, decision), index|
        opening = index.zero? ? '    if' : '    } else if'
        ["#{opening} (event == #{@names.event(event)}) {", decision_lines(decision, '        ')]
      end
      closing = decisions.length > 1 ? ['    } else {', "        /* not for this state */"] : []
      [rows, closing, '    }']
    end

    def decision_lines(decision, indent)
      return take_lines(decision, indent) unless decision.is_a?(Flat::Choice)

      condition, yes, no = @condition.flatten(decision)
      ["#{indent}if (#{condition}) {", decision_lines(yes, "#{indent}    "), else_lines(no, indent), "#{indent}}"]
    end

    def take_lines(transition, indent)
      "#{indent}actions = #{@names.take(transition)}(#{transition_needs(transition).join(', ')});"
    end

    def else_lines(decision, indent)
      return [] if decision.nil?
      return ["#{indent}} else {", decision_lines(decision, "#{indent}    ")] unless decision.is_a?(Flat::Choice)

      condition, yes, no = @condition.flatten(decision)
      rest = no ? else_lines(no, indent) : ["#{indent}} else {", "#{indent}    /* no guard holds */"]
      ["#{indent}} else if (#{condition}) {", decision_lines(yes, "#{indent}    "), rest]
    end

    def region_function(region)
      head = "static uint32_t #{region_name(region)}"
      [call(head, declare(region_needs(region)), ''), '{', '    uint32_t actions = 0U;', '',
       "    switch (self->#{region.name}) {", region.leaves.map { |leaf| leaf_case(region, leaf) },
       '    default:', '        /* damaged: the check repairs it */', '        break;', '    }',
       '    return actions;', '}', '']
    end

    def region_name(region)
      @document.regions.length == 1 ? @names.function('take_microstep') : @names.function("#{region.name}_take")
    end

    def leaf_case(region, leaf)
      needs = leaf_needs(leaf)
      work = if @flat.decisions(leaf).empty?
               '/* takes no event */'
             else
               "actions = #{leaf_name(region, leaf)}(#{needs.join(', ')});"
             end
      ["    case #{@names.leaf(leaf)}:", "        #{work}", '        break;']
    end

    # --- steps --------------------------------------------------------------------------------

    def microstep
      return [] if @document.regions.length == 1

      head = "static uint32_t #{@names.function('take_microstep')}"
      needs = @document.regions.map { |region| region_needs(region) }
      [call(head, declare(step_needs), ''), '{',
       needs.any? { |one| one.include?(:before) } ? "    const #{@names.chart_type} before = *self;" : [],
       @document.regions.each_with_index.map { |region, index| region_call(region, index) },
       '    return actions;', '}', '']
    end

    def region_call(region, index)
      arguments = region_needs(region).map { |name| name == :before ? '&before' : name.to_s }
      opening = index.zero? ? '    uint32_t actions =' : '    actions |='
      [call("#{opening} #{region_name(region)}", arguments, ';'), index.zero? ? '' : []]
    end

    def macro_needs
      step_needs - [:raised]
    end

    def macro_name
      @document.raises? ? @names.function('run_to_completion') : @names.function('take_microstep')
    end

    def macrostep
      return [] unless @document.raises?

      step = @names.function('take_microstep')
      later = step_needs.map { |name| { event: 'raised.events[next]', raised: '&raised' }.fetch(name, name.to_s) }
      first = step_needs.map { |name| name == :raised ? '&raised' : name.to_s }
      [call("static uint32_t #{macro_name}", declare(macro_needs), ''), '{',
       "    #{@names.raised_type} raised;", '', '    raised.count = 0U;',
       call("    uint32_t actions = #{step}", first, ';'), '    uint32_t next = 0U;',
       '    while (next < raised.count) {', "        actions |= #{step}(#{later.join(', ')});", '        next++;',
       '    }', '    return actions;', '}', '']
    end
  end
end
