# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'c'
require_relative 'mode_calls'
require_relative 'node'

module Interface
  # The table of modes: columns of core/interface/modes.yml beside their names, checked.
  #
  # @satisfies SWR-TOOL-011
  class Modes
    REQUIRED = %w[workphases unhomed axes needle].freeze
    KEYS = [*REQUIRED, 'command', 'commands', 'own', 'aim', 'hand', *ModeCalls::GIVEN.keys].freeze
    # The command that arms several modes, each in a workphase of its own.
    BY_WORKPHASE = 'WORKPHASE'
    NO_COMMAND = 'NONE'
    NO_AIM = 'NONE'

    # `command`: what arms it; of several the first. `commands`: values of command_kind that arm it and nothing else.
    # `workphases`, `axes`, `needle`, `aim`: names of values of the model's enumerations. `calls`: what each call is given.
    Mode = Struct.new(:value, :command, :commands, :workphases, :unhomed, :axes, :needle, :aim, :hand, :own, :calls, keyword_init: true) do
      # Where its code is: core/mode/FOLDER.
      def folder
        value.name.downcase
      end

      def header
        "mode/#{folder}/#{folder}_mode.h"
      end

      # Data of its command; nil: nothing but its kind, or several things.
      def payload
        names = commands.map { |one| one.more['payload']&.identifier }.uniq
        names.size == 1 ? names.first : nil
      end
    end

    # The nodes of the commands that modes bring with them, of parsed files.
    def self.commands(nodes)
      kinds = nodes.flat_map { |node| node.at('enumerations')&.sequence.to_a }.find { |one| one.at('name').word == 'mode_kind' }
      kinds ? kinds.at('values').sequence.flat_map { |value| value.at('commands')&.sequence.to_a } : []
    end

    attr_reader :modes

    def initialize(model)
      @model = model
      @kinds = model.enumeration('mode_kind')
      raise Refused.new('core/interface', 'mode_kind', 'says no count') unless @kinds.counted?

      @modes = @kinds.values.map { |value| mode(value) }
      armed_twice
      @calls = ModeCalls.new(modes, @kinds, model.enumeration('command_kind'))
    end

    def files
      { 'mode_list.c' => source }.merge(@calls.files)
    end

    # The mode that a command arms, whatever the workphase; nil for others.
    def of_command(name)
      modes.find { |mode| mode.commands.any? { |value| value.name == name } }
    end

    # Layout that two programs must agree on.
    def layout
      @calls.layout
    end

    # Further parts of the header.
    DECLARATION = <<~CODE
      /** Traits of a mode. */
      typedef struct {
          /** command_kind_t that arms it, of several the first; COMMAND_WORKPHASE: one for the workphase where it runs. */
          uint32_t command;
          /** Where it may be armed and runs; bit n: workphase_t n. */
          uint32_t workphases;
          /** mode_axes_t that must be able. */
          uint32_t axes;
          /** mode_needle_t. */
          uint32_t needle;
          /** mode_aim_t. */
          uint32_t aim;
          /** A hand moves the needle: the sensor of its force must be trusted. */
          bool is_by_hand;
          /** It may drive axes that are not homed; otherwise every axis must be homed. */
          bool may_be_unhomed;
      } mode_row_t;

      /** By mode_kind_t. */
      extern const mode_row_t mode_rows[MODE_KIND_COUNT];
    CODE

    private

    def mode(value)
      missing = REQUIRED.find { |key| !value.more.key?(key) }
      value.node.refuse("has no #{missing}") if missing
      nodes = value.more
      commands = commands_of(nodes['commands'])
      Mode.new(value: value, command: command(value, commands), commands: commands,
               workphases: nodes['workphases'].sequence.map { |node| one_of(node, 'workphase') },
               unhomed: nodes['unhomed'].true?, axes: one_of(nodes['axes'], 'mode_axes'),
               needle: one_of(nodes['needle'], 'mode_needle'), aim: nodes['aim'] ? one_of(nodes['aim'], 'mode_aim') : NO_AIM,
               hand: nodes['hand']&.true? || false, own: nodes['own']&.true?, calls: calls(value))
    end

    # Those that stand in its row.
    def commands_of(node)
      kinds = @model.enumeration('command_kind') || raise(Refused.new('core/interface', 'command_kind', 'is missing'))
      node&.sequence.to_a.map { |one| kinds.values.find { |value| value.name == one.at('name').word } || one.refuse('is no command') }
    end

    def command(value, commands)
      node = value.more['command']
      value.node.refuse('has both command and commands, or neither') if node.nil? == commands.empty?
      node ? node.choice([NO_COMMAND, BY_WORKPHASE]) : commands.first.name
    end

    def calls(value)
      ModeCalls::GIVEN.select { |name, _| value.more.key?(name) }.to_h do |name, parts|
        given = value.more[name].sequence.map { |node| node.choice(parts) }
        value.more[name].refuse('has own, which the mode has not') if given.include?('own') && !value.more['own']&.true?
        [name, given]
      end
    end

    def one_of(node, name)
      enumeration = @model.enumeration(name) || raise(Refused.new('core/interface', name, 'is missing'))
      node.choice(enumeration.values.map(&:name))
    end

    # Entering a workphase arms one mode.
    def armed_twice
      by_workphase = modes.select { |mode| mode.command == BY_WORKPHASE }
      armed = by_workphase.flat_map { |mode| mode.workphases.map { |workphase| ["#{BY_WORKPHASE} #{workphase}", mode] } }
      armed.group_by(&:first).each_value do |same|
        same.drop(1).each do |way, mode|
          mode.value.node.refuse("is armed by #{way} like #{same.first.last.value.name}")
        end
      end
    end

    def source
      rows = modes.map { |mode| "    [#{@kinds.constant(mode.value)}] = #{row(mode)},\n" }
      <<~CODE
        #{C.file('Traits of each mode.', 'core/interface/modes.yml').chomp}
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
                "needle = (uint32_t)#{constant('mode_needle', mode.needle)}", "aim = (uint32_t)#{constant('mode_aim', mode.aim)}",
                "is_by_hand = #{mode.hand}", "may_be_unhomed = #{mode.unhomed}"]
      "{.#{fields.join(",\n         .")}}"
    end

    def constant(name, value)
      "#{@model.enumeration(name).prefix}_#{value}"
    end
  end
end
