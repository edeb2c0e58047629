# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'layout'

module Chart
  module C
    # The public functions of a chart.
    class Public
      include Layout

      def initialize(parts, code, stepper)
        @parts = parts
        @code = code
        @stepper = stepper
        @document = parts.document
        @names = parts.names
        @regions = parts.regions
      end

      def lines
        [intact_function, leaves_function, reset_function, init_function, dispatch_function, advance_function,
         sound_function, check_function]
      end

      private

      def constant_self
        ["const #{@names.chart_type} *self"]
      end

      def field(region)
        "self->#{@names.field(region.name)}"
      end

      def intact_function
        tests = @regions.map { |region| "(self->#{@names.inverse(region)} == ~(uint32_t)#{field(region)})" }
        [call("static bool #{@names.function('is_intact')}", constant_self, ''), '{', joined(tests), '}', '']
      end

      # Every region is one of its leaves, and "none" just when the parallel around it is not active.
      def leaves_function
        tests = @regions.map do |region|
          operator = @names.resting_values(region).length == 1 ? '==' : '<='
          "((uint32_t)#{field(region)} #{operator} (uint32_t)#{@names.last_value(region)})"
        end
        tests += @regions.reject { |region| @regions.always_active?(region) }.map { |region| presence(region) }
        [call("static bool #{@names.function('is_in_leaves')}", constant_self, ''), '{', joined(tests), '}', '']
      end

      def presence(region)
        around = @parts.expressions.place(region.outer, 'self')
        none = @names.value(region, nil)
        "(#{around} ? (#{field(region)} != #{none}) : (#{field(region)} == #{none}))"
      end

      # Everything but the regions that the caller enters next.
      def reset_function
        rows = [vanish_lines, memory_lines, data_lines, timer_lines].flatten
        return [] if rows.empty?

        ["static void #{@names.function('clear')}(#{@names.chart_type} *self)", '{',
         rows.map { |row| "    #{row}" }, '}', '']
      end

      def vanish_lines
        vanishing = @regions.select { |region| @regions.vanishes?(region) }
        vanishing.flat_map { |region| @parts.steps.lines([Enter.new(region, nil)]) }
      end

      def memory_lines
        @regions.memories.map { |memory| "self->#{@names.memory(memory)} = #{@names.value(memory.region, nil)};" }
      end

      def data_lines
        @document.data.map { |variable| "self->#{@names.field(variable.name)} = #{variable.initial};" }
      end

      def timer_lines
        @document.timers.flat_map { |timer| @parts.steps.lines([Cancel.new(timer)]) }
      end

      def reset_call
        lines = [vanish_lines, memory_lines, data_lines, timer_lines].flatten
        lines.empty? ? [] : ["#{@names.function('clear')}(self);"]
      end

      # What the lines gather in, if they do.
      def run_lines(lines)
        return [] if @document.actions.empty? && lines.flatten.none? { |line| line.match?(/\brun\b/) }

        first = @document.actions.empty? ? '.raised = 0U' : '.actions = 0U'
        ["#{@names.function('run_t')} run = {#{first}};"]
      end

      def init_function
        start = "#{@code.invoke('begin', 'run' => '&run', 'inputs' => '&no_inputs')};"
        body = ['self->now_us = 0U;', 'self->trace.count = 0U;', *reset_call, start]
        needs = start.match?(/\brun\b/) ? [*run_lines([start]), ''] : []
        ["void #{@names.chart_function('init')}(#{@names.chart_type} *self)", '{',
         [*needs, *no_inputs(body), *body].map { |line| line.empty? ? line : "    #{line}" }, '}', '']
      end

      def no_inputs(body)
        return [] unless body.any? { |line| line.include?('no_inputs') }

        ["const #{@names.inputs_type} no_inputs = {",
         *@document.inputs.map { |input| "    .#{@names.field(input.name)} = false," }, '};', '']
      end

      def dispatch_function
        condition = ["#{@names.function('is_intact')}(self)", *from_outside].join(' && ')
        runs = macrostep(@stepper.step_from_outside('&run'))
        [call("uint32_t #{@names.chart_function('dispatch')}",
              @names.public_parameters("#{@names.event_type} event").split(', '), ''), '{',
         unused('event', [*runs, condition]), unused('inputs', runs), run_lines(runs).map { |line| ["    #{line}", ''] },
         at_operators("if (#{condition}) {", 90).map { |line| "    #{line}" }, runs.map { |line| "        #{line}" },
         '    }', "    return #{actions};", '}', '']
      end

      def from_outside
        return [] if @stepper.sorts?

        @document.internal_events.map { |event| "(event != #{@names.event(event)})" }
      end

      # A first step and all that follows.
      def macrostep(step)
        return step unless @code.defined?('run_to_completion')

        [*step, "#{@code.invoke('run_to_completion', 'run' => '&run')};"]
      end

      def actions
        @document.actions.empty? ? '0U' : 'run.actions'
      end

      # Of a chart without timers it stands in the header.
      def advance_function
        return [] if @document.timers.empty?

        head = "uint32_t #{@names.chart_function('advance')}"
        [count_function, call(head, @names.advance_parameters.split(', '), ''),
         '{', unused('inputs', advance_body), advance_body, '}', '']
      end

      def unused(parameter, lines)
        return [] if parameter == 'inputs' && @document.inputs.empty?

        lines.any? { |line| line.match?(/\b#{parameter}\b/) } ? [] : ["    (void)#{parameter};"]
      end

      def advance_body
        expiries = @document.timers.flat_map { |timer| expiry_lines(timer) }
        [*run_lines(expiries).flat_map { |line| ["    #{line}", ''] }, '    self->now_us += elapsed_us;',
         "    if (#{@names.function('is_intact')}(self)) {",
         "        #{@names.function('count_time')}(self, elapsed_us);", *expiries, '    }', "    return #{actions};"]
      end

      def count_function
        rows = @document.timers.map do |timer|
          time = "self->#{@names.time(timer)}"
          ["    if (self->#{@names.armed(timer)} != 0U) {",
           "        #{time} = #{@names.function('add_saturated')}(#{time}, elapsed_us);", '    }']
        end
        head = "static void #{@names.function('count_time')}"
        [saturate, call(head, ["#{@names.chart_type} *self", 'uint32_t elapsed_us'], ''),
         '{', rows, '}', '', @document.timers.map { |timer| expired_function(timer) }]
      end

      def saturate
        ["static uint32_t #{@names.function('add_saturated')}(uint32_t sum_us, uint32_t elapsed_us)", '{',
         '    return (elapsed_us > (UINT32_MAX - sum_us)) ? UINT32_MAX : (sum_us + elapsed_us);', '}', '']
      end

      def expired_function(timer)
        [call("static bool #{expired(timer)}", constant_self, ''), '{',
         joined(["(self->#{@names.armed(timer)} != 0U)", "(self->#{@names.time(timer)} >= #{@names.delay(timer)})"]), '}', '']
      end

      def expired(timer)
        @names.function("#{@names.stem(timer.id)}.has_expired")
      end

      def expiry_lines(timer)
        runs = macrostep(@stepper.step(@names.event(timer.event), [timer.event], '&run'))
        ["        if (#{expired(timer)}(self)) {",
         *[*@parts.steps.lines([Cancel.new(timer)]), *empty_queue(timer, runs), *runs].map { |line| "            #{line}" },
         '        }']
      end

      # What the timers before have raised is done.
      def empty_queue(timer, runs)
        return [] if !@parts.raises? || timer == @document.timers.first || runs.none? { |line| line.include?('&run') }

        ['run.raised = 0U;', 'run.taken = 0U;']
      end

      def sound_function
        tests = ["#{@names.function('is_intact')}(self)", "#{@names.function('is_in_leaves')}(self)"]
        [call("bool #{@names.chart_function('is_sound')}", constant_self, ''), '{', joined(tests), '}', '']
      end

      def check_function
        repair = [*reset_call, *@parts.steps.lines(safe_steps), 'chart_trace_add(&self->trace, self->now_us, 0U);',
                  'repaired = 1U;']
        ["uint32_t #{@names.chart_function('check')}(#{@names.chart_type} *self)", '{',
         '    uint32_t repaired = 0U;', '',
         "    if (!#{@names.function('is_intact')}(self) || !#{@names.function('is_in_leaves')}(self)) {",
         repair.map { |line| "        #{line}" }, '    }', '    return repaired;', '}', '']
      end

      # The safe leaves, with the timers of their states.
      def safe_steps
        active = @document.safe.flat_map { |leaf| [leaf, *leaf.ancestors] }.uniq.reject(&:root?).sort_by(&:order)
        enters = active.select { |state| state.leaf? || state.parallel? }.select { |state| @regions.of(state) }
        enters.map { |state| Enter.new(@regions.of(state), state) } + active.flat_map { |state| state.entry.grep(Send) }
      end
    end
  end
end
