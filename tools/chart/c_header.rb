# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'c_layout'
require_relative 'c_names'

module Chart
  # The public face of one chart in C.
  class CHeader
    include CLayout

    def initialize(document)
      @document = document
      @names = CNames.new(document)
    end

    def emit
      guard = "BORESIGHT_#{@names.macro}_CHART_H"
      text([banner(@document, 'Interface'), about, "#ifndef #{guard}", "#define #{guard}", '',
            '#include <stdbool.h>', '#include <stdint.h>', '', region_enums, event_enum, actions, inputs, chart_struct,
            functions, "#endif /* #{guard} */"])
    end

    private

    def about
      @document.comment && !@document.comment.start_with?('SPDX') ? [comment(@document.comment), ''] : ['']
    end

    def region_enums
      @document.regions.map do |region|
        members = region.leaves.each_with_index.map do |leaf, value|
          { name: @names.leaf(leaf), value: value, note: leaf.req.join(' ') }
        end
        [comment("The leaves of region \"#{region.name}\"."), enum(members, @names.region_type(region))]
      end
    end

    def event_enum
      members = @document.events.each_with_index.map do |event, value|
        { name: @names.event(event), value: value, note: event_note(event) }
      end
      [comment('The events, in document order.'), enum(members, @names.event_type)]
    end

    def event_note(event)
      return 'internal: from outside it does nothing' if @document.internal_events.include?(event)

      timers = @document.timers.select { |timer| timer.event == event }.map(&:id)
      timers.empty? ? '' : "timer #{timers.join(', ')}"
    end

    def enum(members, type)
      rows = members.each_with_index.map do |member, index|
        comma = index == members.length - 1 ? '' : ','
        note = member[:note].empty? ? '' : " /* #{member[:note]} */"
        "    #{member[:name]} = #{member[:value]}U#{comma}#{note}"
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
        [input.comment ? comment(input.comment, '    ') : [], "    bool #{input.name};"]
      end
      [comment('What the guards read; the chart does not change it.'), 'typedef struct {', rows,
       "} #{@names.inputs_type};", '']
    end

    def chart_struct
      [comment('The state of one chart, owned by the caller; read the fields, write them only through the functions. ' \
               'Each region is stored twice, the second time inverted.'),
       'typedef struct {', @document.regions.map { |region| region_fields(region) },
       @document.timers.map { |timer| timer_fields(timer) },
       '    uint16_t last_transition; /* number of the transition taken last, 0: none yet */',
       "} #{@names.chart_type};", '']
    end

    def region_fields(region)
      ["    #{@names.region_type(region)} #{region.name};", "    uint32_t #{region.name}_inverse;"]
    end

    def timer_fields(timer)
      ["    uint32_t #{timer.id}_us; /* since entering #{timer.state.id}; 0 while not armed */",
       "    bool #{timer.id}_is_armed;"]
    end

    def functions
      [init_function, dispatch_function, advance_function, sound_functions, in_functions]
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
      return [] if @document.timers.empty?

      [comment('Adds the elapsed time to every armed timer, saturating, then lets those that reached their delay ' \
               'expire in document order, each taken to the end. Call it once per cycle, before the events. ' \
               "Returns #{returned}."),
       prototype('uint32_t', 'advance', @names.public_parameters('uint32_t elapsed_us'))]
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
      @document.compounds.map do |state|
        leaves = state.leaves.map(&:id).join(', ')
        [comment("True in #{state.id}, that is in: #{leaves}."),
         prototype('bool', "in_#{state.id}", "const #{@names.chart_type} *self")]
      end
    end
  end
end
