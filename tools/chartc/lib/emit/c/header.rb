# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../../check/entering'
require_relative 'layout'
require_relative 'parts'

module Chart
  module C
    # The public face of one chart.
    class Header
      include Layout

      def initialize(document, walk)
        @document = document
        @entering = Entering.new(document, walk)
        @parts = Parts.new(document, walk)
        @names = @parts.names
        @regions = @parts.regions
      end

      def emit
        guard = @names.header_guard
        text([banner(@document, 'Interface'), about, "#ifndef #{guard}", "#define #{guard}", '', '#include "base/chart.h"',
              '', '#include <stdbool.h>', stddef, '#include <stdint.h>', '', region_enums, event_enum, actions, inputs,
              chart_struct, deciding_bytes, functions, "#endif /* #{guard} */"])
      end

      private

      def about
        @document.comment && !@document.comment.start_with?('SPDX') ? [comment(@document.comment), ''] : ['']
      end

      def region_enums
        @regions.map do |region|
          members = @regions.none?(region) ? [{ name: @names.value(region, nil), note: 'not active' }] : []
          members = region.leaves.map { |leaf| { name: @names.leaf(leaf), note: leaf.req.join(' ') } } + members
          [comment("The leaves of region \"#{region.name}\"."), enum(members, @names.region_type(region))]
        end
      end

      def event_enum
        members = @document.events.map { |event| { name: @names.event(event), note: event_note(event) } }
        members = [{ name: @names.no_event, note: 'the chart waits for nothing' }] if members.empty?
        [comment('The events.'), enum(members, @names.event_type)]
      end

      def event_note(event)
        timers = @document.timers.select { |timer| timer.event == event }.map(&:id)
        return "timer #{timers.join(', ')}: from outside it does nothing" if timers.any? && internal?(event)

        internal?(event) ? 'internal: from outside it does nothing' : ''
      end

      def internal?(event)
        @document.internal_events.include?(event)
      end

      def enum(members, type)
        rows = members.each_with_index.map do |member, value|
          comma = value == members.length - 1 ? '' : ','
          "    #{member[:name]} = #{value}U#{comma}#{remark(member[:note])}"
        end
        ['typedef enum {', rows, "} #{type};", '']
      end

      def actions
        return [] if @document.actions.empty?

        rows = @document.actions.each_with_index.map do |action, bit|
          "#define #{@names.action(action)} ((uint32_t)0x#{format('%08X', 1 << bit)}U)"
        end
        [comment('What a step asks its caller to do: one bit per action.'), rows, '']
      end

      def inputs
        return [] if @document.inputs.empty?

        rows = @document.inputs.map do |input|
          [input.comment ? comment(input.comment, '    ') : [], "    bool #{@names.field(input.name)};"]
        end
        [comment('What the guards read; the chart does not change it.'), 'typedef struct {', rows,
         "} #{@names.inputs_type};", '']
      end

      def chart_struct
        [comment('The state of one chart, owned by the caller; read the fields, write them only through the ' \
                 'functions. Each region is stored twice, the second time inverted.'),
         'typedef struct {', @regions.map { |region| region_fields(region) },
         @regions.memories.map { |memory| "    #{@names.region_type(memory.region)} #{@names.memory(memory)};" },
         @document.data.map { |variable| data_field(variable) },
         @document.timers.map { |timer| timer_fields(timer) },
         '    uint64_t now_us; /* sum of the time handed to advance */',
         '    chart_trace_t trace; /* the transitions taken last, by number */', "} #{@names.chart_type};", '']
      end

      # State that is held once has no copy to be compared with, and needs another guard.
      def held_once?
        [@regions.memories, @document.data, @document.timers].any?(&:any?)
      end

      def stddef
        held_once? ? ['#include <stddef.h>'] : []
      end

      def deciding_bytes
        return [] unless held_once?

        [comment('The bytes of the chart that decide about its steps: all before its clock.'),
         "#define #{@names.bytes} offsetof(#{@names.chart_type}, now_us)", '']
      end

      def region_fields(region)
        field = @names.field(region.name)
        ["    #{@names.region_type(region)} #{field};", "    uint32_t #{@names.inverse(region)};"]
      end

      def data_field(variable)
        range = variable.kind == :integer ? " /* #{variable.minimum} to #{variable.maximum} */" : ''
        "    #{@names.variable_type(variable)} #{@names.field(variable.name)};#{range}"
      end

      # A bool of another value than 0 and 1 is undefined.
      # @satisfies SWR-CHART-510
      def timer_fields(timer)
        ["    uint32_t #{@names.time(timer)}; /* since it was armed; 0 while it is not */",
         "    uint32_t #{@names.armed(timer)}; /* 1, or 0; any other number is a damaged 1 */"]
      end

      def functions
        [init_function, dispatch_function, advance_function, sound_functions, in_functions, enters_functions]
      end

      def prototype(type, name, parameters)
        [call("#{type} #{@names.chart_function(name)}", parameters.split(', '), ';'), '']
      end

      def init_function
        [comment('Enters the initial configuration and starts its timers.'),
         prototype('void', 'init', "#{@names.chart_type} *self")]
      end

      def dispatch_function
        [comment("Takes one event, and the events that it raises, to the end. Returns #{returned}. " \
                 'A damaged chart takes no event; see the check below.'),
         prototype('uint32_t', 'dispatch', @names.public_parameters("#{@names.event_type} event"))]
      end

      def returned
        @document.actions.empty? ? '0U: this chart has no actions' : 'the actions of all transitions taken, or 0U'
      end

      def advance_function
        timers = @document.timers.empty? ? '' : ' and of every armed timer, saturating, then lets those that reached ' \
                                                'their delay expire in document order, each taken to the end'
        [comment("Moves the chart's clock#{timers}. Call it once per cycle, before the events. Returns #{returned}."),
         @document.timers.empty? ? advance_clock : prototype('uint32_t', 'advance', @names.advance_parameters)]
      end

      # Here, so that it is cheaper than a call.
      def advance_clock
        [call("static inline uint32_t #{@names.chart_function('advance')}", @names.advance_parameters.split(', '), ''),
         '{', '    self->now_us += elapsed_us;', '    return 0U;', '}', '']
      end

      def sound_functions
        safe = @document.safe.map(&:id).join(' ')
        [comment('True while every region is a leaf and the complement of its inverse copy.'),
         prototype('bool', 'is_sound', "const #{@names.chart_type} *self"),
         comment_with("Puts a damaged chart into its safe configuration: #{safe}. Returns 1U when it did, 0U when " \
                      'the chart is sound and nothing was done.', '@satisfies SWR-CORE-004'),
         prototype('uint32_t', 'check', "#{@names.chart_type} *self")]
      end

      # A comment whose last line is a mark for the trace.
      def comment_with(words, mark)
        wrapped = comment(words)
        wrapped[-1] = wrapped[-1].delete_suffix(' */')
        wrapped + ["   #{mark} */"]
      end

      def in_functions
        @parts.compounds.map do |state|
          leaves = @regions.of(state).leaves.select { |leaf| leaf.inside?(state) }
          [comment("True in #{state.id}, that is in: #{leaves.map(&:id).join(', ')}."), in_function(state, leaves), '']
        end
      end

      def enters_functions
        @document.entering.map do |event|
          leaves = @entering.leaves(event)
          [comment("True where #{event} enters a state, with some inputs: from #{leaves.map(&:id).join(', ')}."),
           leaves_function(@names.enters_function(event), leaves), '']
        end
      end

      def in_function(state, leaves)
        leaves_function(@names.in_function(state), leaves)
      end

      # Here, so that asking is cheaper than a call.
      def leaves_function(name, leaves)
        [call("static inline bool #{name}", ["const #{@names.chart_type} *self"], ''), '{',
         joined(leaves.map { |leaf| "(self->#{@names.field(@regions.of(leaf).name)} == #{@names.leaf(leaf)})" }, '||'), '}']
      end
    end
  end
end
