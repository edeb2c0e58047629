# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'c'

module Interface
  # The calls into the folders of the modes, core/mode/NAME/NAME_mode.h: for each mode those that its row names, as switches.
  # A call lists what of the request and of the state it is given, in the order of its arguments.
  #
  # @satisfies SWR-MODE-014
  # @satisfies SWR-TOOL-081
  class ModeCalls
    FROM = 'core/interface/modes.yml'
    SAYS = 'Which function of the folder of a mode does what.'
    # Arguments that a call may get, of the request and of the state of all modes.
    REQUEST = { 'way' => '&%ssealed.way', 'move' => '&%ssealed.move', 'span' => '&%ssealed.span',
                'axis' => '%ssealed.way.axis', 'end' => '%ssealed.way.end_ticks', 'own' => '&%sown.%s' }.freeze
    STATE = %w[leg escort steer trajectory list program].to_h { |part| [part, "&self->sealed.#{part}"] }.freeze
    GIVEN = { 'ask' => REQUEST.keys - %w[axis end], 'judge' => REQUEST.keys, 'step' => REQUEST.keys + STATE.keys,
              'is_done' => REQUEST.keys + STATE.keys }.freeze
    # The payload of a command that says an axis and nothing else.
    BARE_AXIS = 'axis'

    def initialize(modes, kinds, commands)
      @modes = modes
      @kinds = kinds
      @commands = commands
    end

    def files
      { 'mode_own.h' => own_header, 'mode_dispatch.c' => source }
    end

    # Layout that two programs must agree on.
    def layout
      "mode_own #{owners.map(&:folder).join(' ')}"
    end

    private

    def owners
      @modes.select(&:own)
    end

    def own_header
      includes = owners.map { |mode| "#include \"#{mode.header}\"\n" }.sort.join
      members = owners.map { |mode| "    #{mode.folder}_mode_t #{mode.folder};\n" }.join
      C.file('Request and state of one mode alone.', FROM) + C.guard('mode_own', <<~CODE)
        #include "mode_list.h"
        #{includes}
        #include <stdint.h>

        /** A member for each mode that has one; all zero before it begins. */
        typedef struct {
        #{members}} mode_own_t;

        /** Place of a member, bytes; none: the mode has no member. */
        typedef struct {
            uint32_t from;
            uint32_t bytes;
        } mode_own_range_t;

        /** By mode_kind_t. */
        extern const mode_own_range_t mode_own_ranges[MODE_KIND_COUNT];
      CODE
    end

    def source
      includes = @modes.select { |mode| mode.calls.any? }.map { |mode| "#include \"#{mode.header}\"\n" }.sort.join
      <<~CODE
        #{C.file(SAYS, FROM).chomp}
        #include "mode/mode_dispatch.h"

        #include "base/seal.h"
        #include "interface/command.h"
        #include "interface/mode_own.h"
        #{includes}#include "mode/mode.h"

        #include <stddef.h>

        #{[ranges, of_command, ask, judge, step, is_done].join("\n").chomp}
      CODE
    end

    def ranges
      rows = owners.map do |mode|
        "    [#{@kinds.constant(mode.value)}] = {.from = (uint32_t)offsetof(mode_own_t, #{mode.folder}),\n" \
          "         .bytes = (uint32_t)WHOLE_WORDS(sizeof(#{mode.folder}_mode_t))},\n"
      end
      "const mode_own_range_t mode_own_ranges[MODE_KIND_COUNT] = {\n#{rows.join}};\n"
    end

    def of_command
      armed = @modes.select { |mode| mode.commands.any? }
      cases = armed.map do |mode|
        labels = mode.commands.map { |value| "    case (uint32_t)#{@commands.constant(value)}:\n" }
        "#{labels.join}        found = #{@kinds.constant(mode.value)};\n        break;\n"
      end
      function('mode_kind_t mode_of_command(uint32_t command_kind)', 'mode_kind_t found = MODE_NONE', 'command_kind', cases,
               'found = MODE_NONE', 'found')
    end

    def ask
      cases = @modes.filter_map { |mode| asked(mode)&.then { |lines| one(mode, lines) } }
      function('mode_request_t mode_ask(mode_kind_t kind, const mode_asked_t *asked)', 'mode_request_t request = {.sealed = {.axes = 0U}}',
               '(uint32_t)kind', cases, nil, 'request')
    end

    def asked(mode)
      if mode.calls.key?('ask')
        ["request.sealed.axes = #{call(mode, 'ask', ['asked'], [], 'request.')}"]
      elsif mode.payload == BARE_AXIS
        ['request.sealed.way.axis = command_as_axis(asked->command)->axis',
         'request.sealed.axes = mode_asked_axes(request.sealed.way.axis)']
      elsif mode.axes == 'COMMANDED'
        mode.value.node.refuse('has no ask, is COMMANDED for axes, and its command has not the payload axis')
      end
    end

    def judge
      cases = with('judge') { |mode| "result = #{call(mode, 'judge', [], %w[robot axes], 'request->')}" }
      function("solution_t mode_judge(mode_kind_t kind, const mode_request_t *request, const robot_t *robot,\n" \
               '                      const axis_t axes[ROBOT_AXIS_MAX])',
               'solution_t result = {.status = STATUS_OK, .axis = 0U, .is_maximum = 0U}', '(uint32_t)kind', cases, nil, 'result')
    end

    def step
      cases = with('step') { |mode| call(mode, 'step', [], %w[frame result], 'self->request.') }
      function("bool mode_dispatch_step(mode_state_t *self, mode_kind_t kind, const mode_frame_t *frame,\n" \
               '                        mode_result_t *result)', 'bool is_known = true', '(uint32_t)kind', cases,
               'is_known = false', 'is_known')
    end

    def is_done
      cases = with('is_done') { |mode| "is_done = #{call(mode, 'is_done', [], %w[frame], 'self->request.')}" }
      function('bool mode_dispatch_is_done(const mode_state_t *self, mode_kind_t kind, const mode_frame_t *frame)',
               'bool is_done = false', '(uint32_t)kind', cases, 'is_done = false', 'is_done')
    end

    def with(name)
      @modes.select { |mode| mode.calls.key?(name) }.map { |mode| one(mode, [yield(mode)]) }
    end

    def one(mode, lines)
      "    case (uint32_t)#{@kinds.constant(mode.value)}:\n#{lines.map { |line| "        #{line};\n" }.join}        break;\n"
    end

    # "jog_mode_step(&self->request.sealed.way, &self->sealed.leg, frame, result)".
    def call(mode, name, first, last, request)
      given = mode.calls.fetch(name).map do |part|
        STATE[part] || format(REQUEST.fetch(part), request, mode.folder)
      end
      "#{mode.folder}_mode_#{name}(#{[*first, *given, *last].join(', ')})"
    end

    # `otherwise` nil: nothing becomes of what has no case.
    def function(signature, start, kind, cases, otherwise, result)
      <<~CODE
        #{signature}
        {
            #{start};
            switch (#{kind}) {
        #{cases.join.chomp}
            default:#{otherwise ? "\n        #{otherwise};" : ' /* It has none. */'}
                break;
            }
            return #{result};
        }
      CODE
    end
  end
end
