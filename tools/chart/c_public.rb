# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'c_layout'

module Chart
  # The public functions of a chart in C; a part of CSource.
  module CPublic
    include CLayout

    private

    def public_functions
      [intact_function, leaves_function, init_function, dispatch_function, advance_function, sound_function,
       check_function,
       @document.compounds.map { |state| in_function(state) }]
    end

    def intact_function
      tests = @document.regions.map { |region| "(self->#{region.name}_inverse == ~(uint32_t)self->#{region.name})" }
      ["static bool #{@names.function('is_intact')}(const #{@names.chart_type} *self)", '{', joined(tests), '}', '']
    end

    def joined(tests, operator = '&&')
      return ["    return #{tests.first};"] if tests.length == 1

      short = "    return (#{tests.join(" #{operator} ")});"
      return [short] if short.length <= WIDTH

      rows = tests.map.with_index do |test, index|
        lead = index.zero? ? '    return (' : '            '
        tail = index == tests.length - 1 ? ');' : " #{operator}"
        "#{lead}#{test}#{tail}"
      end
      [rows]
    end

    def enter_configuration(leaves)
      active = leaves.flat_map { |leaf| [leaf, *leaf.ancestors] }
      entries = leaves.map do |leaf|
        "#{@names.function("enter_#{@document.region_of(leaf).name}")}(self, #{@names.leaf(leaf)});"
      end
      entries + @document.timers.map do |timer|
        active.include?(timer.state) ? start_timer(timer) : stop_timer(timer)
      end
    end

    def init_function
      leaves = @document.regions.map { |region| @flat.entered_leaf(region.state) }
      ["void #{@names.chart_function('init')}(#{@names.chart_type} *self)", '{',
       enter_configuration(leaves).map { |line| "    #{line}" }, '    self->last_transition = 0U;', '}', '']
    end

    def dispatch_function
      head = "uint32_t #{@names.chart_function('dispatch')}"
      inner = @document.internal_events.map { |event| "(event != #{@names.event(event)})" }
      intact = "#{@names.function('is_intact')}(self)"
      condition = inner.empty? ? intact : [intact, *inner].join(' && ')
      [call(head, @names.public_parameters("#{@names.event_type} event").split(', '), ''), '{',
       '    uint32_t actions = 0U;', '', "    if (#{condition}) {",
       "        actions = #{macro_name}(#{macro_needs.join(', ')});", '    }', '    return actions;', '}', '']
    end

    def advance_function
      return [] if @document.timers.empty?

      head = "uint32_t #{@names.chart_function('advance')}"
      [count_function, call(head, @names.public_parameters('uint32_t elapsed_us').split(', '), ''), '{',
       '    uint32_t actions = 0U;', '', "    if (#{@names.function('is_intact')}(self)) {",
       "        #{@names.function('count_time')}(self, elapsed_us);",
       @document.timers.map { |timer| expiry_lines(timer) }, '    }', '    return actions;', '}', '']
    end

    def count_function
      rows = @document.timers.map do |timer|
        add = "#{@names.function('add_saturated')}(self->#{timer.id}_us, elapsed_us)"
        ["    if (self->#{timer.id}_is_armed) {", "        self->#{timer.id}_us = #{add};", '    }']
      end
      head = "static void #{@names.function('count_time')}"
      [call(head, ["#{@names.chart_type} *self", 'uint32_t elapsed_us'], ''), '{', rows, '}', '',
       @document.timers.map { |timer| expired_function(timer) }]
    end

    def expired_function(timer)
      head = "static bool #{@names.function("#{timer.id}_has_expired")}"
      [call(head, ["const #{@names.chart_type} *self"], ''), '{',
       joined(["self->#{timer.id}_is_armed", "(self->#{timer.id}_us >= #{@names.delay(timer)})"]), '}', '']
    end

    def expiry_lines(timer)
      arguments = macro_needs.map { |name| name == :event ? @names.event(timer.event) : name.to_s }
      ["        if (#{@names.function("#{timer.id}_has_expired")}(self)) {",
       "            #{stop_timer(timer)}",
       "            actions |= #{macro_name}(#{arguments.join(', ')});", '        }']
    end

    def leaves_function
      tests = @document.regions.map do |region|
        "((uint32_t)self->#{region.name} <= (uint32_t)#{@names.last_leaf(region)})"
      end
      head = "static bool #{@names.function('is_in_leaves')}"
      [call(head, ["const #{@names.chart_type} *self"], ''), '{', joined(tests), '}', '']
    end

    def sound_function
      head = "bool #{@names.chart_function('is_sound')}"
      tests = ["#{@names.function('is_intact')}(self)", "#{@names.function('is_in_leaves')}(self)"]
      [call(head, ["const #{@names.chart_type} *self"], ''), '{', joined(tests), '}', '']
    end

    def check_function
      ["uint32_t #{@names.chart_function('check')}(#{@names.chart_type} *self)", '{',
       '    uint32_t repaired = 0U;', '',
       "    if (!#{@names.function('is_intact')}(self) || !#{@names.function('is_in_leaves')}(self)) {",
       enter_configuration(@document.safe).map { |line| "        #{line}" }, '        repaired = 1U;', '    }',
       '    return repaired;', '}', '']
    end

    def in_function(state)
      region = @document.region_of(state)
      tests = state.leaves.map { |leaf| "(self->#{region.name} == #{@names.leaf(leaf)})" }
      ["bool #{@names.chart_function("in_#{state.id}")}(const #{@names.chart_type} *self)", '{', joined(tests, '||'),
       '}', '']
    end
  end
end
