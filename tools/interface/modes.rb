# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'c'
require_relative 'node'

module Interface
  # The table of modes: what core/interface/modes.yml says beside their names, checked.
  #
  # @satisfies SWR-TOOL-011
  class Modes
    KEYS = %w[command workphases unhomed axes needle].freeze
    # The command that arms several modes, each in a workphase of its own.
    BY_WORKPHASE = 'WORKPHASE'
    NO_COMMAND = 'NONE'

    # `command`, `workphases`, `axes`, `needle`: names of values of the model's enumerations.
    Mode = Struct.new(:value, :command, :workphases, :unhomed, :axes, :needle, keyword_init: true)

    attr_reader :modes

    def initialize(model)
      @model = model
      @kinds = model.enumeration('mode_kind')
      raise Refused.new('core/interface', 'mode_kind', 'says no count') unless @kinds.counted?

      @modes = @kinds.values.map { |value| mode(value) }
      armed_twice
    end

    def files
      { 'mode_list.c' => source }
    end

    # What the header has besides.
    DECLARATION = <<~CODE
      /** What is special about a mode. */
      typedef struct {
          /** command_kind_t that arms it; COMMAND_WORKPHASE: one for the workphase where it runs. */
          uint32_t command;
          /** Where it may be armed and runs; bit n: workphase_t n. */
          uint32_t workphases;
          /** mode_axes_t that must be able. */
          uint32_t axes;
          /** mode_needle_t. */
          uint32_t needle;
          /** It may drive axes that are not homed; otherwise every axis must be homed. */
          bool may_be_unhomed;
      } mode_row_t;

      /** By mode_kind_t. */
      extern const mode_row_t mode_rows[MODE_KIND_COUNT];
    CODE

    private

    def mode(value)
      missing = KEYS.find { |key| !value.more.key?(key) }
      value.node.refuse("has no #{missing}") if missing
      nodes = value.more
      Mode.new(value: value, command: one_of(nodes['command'], 'command_kind'),
               workphases: nodes['workphases'].sequence.map { |node| one_of(node, 'workphase') },
               unhomed: nodes['unhomed'].true?, axes: one_of(nodes['axes'], 'mode_axes'),
               needle: one_of(nodes['needle'], 'mode_needle'))
    end

    def one_of(node, name)
      enumeration = @model.enumeration(name) || raise(Refused.new('core/interface', name, 'is missing'))
      node.choice(enumeration.values.map(&:name))
    end

    # A command, or entering a workphase, arms one mode.
    def armed_twice
      armed = modes.reject { |mode| mode.command == NO_COMMAND }.flat_map { |mode| ways(mode).map { |way| [way, mode] } }
      armed.group_by(&:first).each_value do |same|
        same.drop(1).each do |way, mode|
          mode.value.node.refuse("is armed by #{way} like #{same.first.last.value.name}")
        end
      end
    end

    def ways(mode)
      return [mode.command] unless mode.command == BY_WORKPHASE

      mode.workphases.map { |workphase| "#{BY_WORKPHASE} #{workphase}" }
    end

    def source
      rows = modes.map { |mode| "    [#{@kinds.constant(mode.value)}] = #{row(mode)},\n" }
      <<~CODE
        #{C.file('What is special about each mode.', 'core/interface/modes.yml').chomp}
        #include "mode_list.h"

        #include "command.h"
        #include "workphase_list.h"

        #define IN(workphase) ((uint32_t)1U << (uint32_t)(workphase))

        const mode_row_t mode_rows[MODE_KIND_COUNT] = {
        #{rows.join}};
      CODE
    end

    def row(mode)
      workphases = mode.workphases.map { |name| "IN(#{constant('workphase', name)})" }
      fields = ["command = (uint32_t)#{constant('command_kind', mode.command)}",
                "workphases = #{workphases.empty? ? '0U' : workphases.join(' | ')}",
                "axes = (uint32_t)#{constant('mode_axes', mode.axes)}",
                "needle = (uint32_t)#{constant('mode_needle', mode.needle)}", "may_be_unhomed = #{mode.unhomed}"]
      "{.#{fields.join(",\n         .")}}"
    end

    def constant(name, value)
      "#{@model.enumeration(name).prefix}_#{value}"
    end
  end
end
