# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'c'
require_relative 'node'

module Interface
  # In which workphases commands are obeyed: what core/interface/commands.yml says, and modes.yml of those that arm a mode.
  #
  # @satisfies SWR-TOOL-011
  class Commands
    KEYS = %w[workphases].freeze
    # Up to so many are named; of more those that are left.
    NAMED_MOST = 4

    # What the header has besides.
    DECLARATION = <<~CODE
      /** By command_kind_t, where it may be obeyed; bit n: workphase_t n. All bits: no workphase stands against it, or
       * the chart of workphases decides. */
      extern const uint32_t command_workphases[COMMAND_KIND_COUNT];
    CODE

    def initialize(model)
      @kinds = model.enumeration('command_kind')
      @all = model.enumeration('workphase').values.map(&:name)
      @prefix = model.enumeration('workphase').prefix
      @modes = model.modes&.modes.to_a.reject { |mode| mode.command == Modes::BY_WORKPHASE }
      @workphases = @kinds.values.to_h { |value| [value.name, workphases_of(value)] }
    end

    # Adds to what is said of each where it may be obeyed.
    def complete
      @kinds.values.each { |value| value.says = told(value.says, value) }
    end

    def files
      { 'command.c' => source }
    end

    # `says` and where it may be obeyed.
    def told(says, value)
      [says, sentence(value)].reject(&:empty?).join(' ')
    end

    def find(name)
      @kinds.values.find { |value| value.name == name }
    end

    # "Only in MANUAL."; empty if no workphase stands against it.
    def sentence(value)
      here = @workphases[value.name]
      return '' unless here

      here.size > NAMED_MOST ? "Not in #{any_of(@all - here)}." : "Only in #{any_of(here)}."
    end

    private

    # nil: all.
    def workphases_of(value)
      own = value.more['workphases']
      mode = @modes.find { |one| one.command == value.name && value.name != Modes::NO_COMMAND }
      return own&.sequence&.map { |node| node.choice(@all) } unless mode

      own&.refuse("stand in modes.yml, with #{mode.value.name}")
      mode.workphases
    end

    def any_of(names)
      [names[0..-2].join(', '), names.last].reject(&:empty?).join(' or ')
    end

    def source
      rows = @kinds.values.map { |value| "    [#{@kinds.constant(value)}] = #{bits(@workphases[value.name])},\n" }
      <<~CODE
        #{C.file('Where commands may be obeyed.', 'core/interface/commands.yml').chomp}
        #include "command.h"

        #include "workphase_list.h"

        #define IN(workphase) ((uint32_t)1U << (uint32_t)(workphase))
        #define IN_ALL UINT32_MAX

        const uint32_t command_workphases[COMMAND_KIND_COUNT] = {
        #{rows.join}};
      CODE
    end

    def bits(here)
      here ? here.map { |name| "IN(#{@prefix}_#{name})" }.join(" |\n        ") : 'IN_ALL'
    end
  end
end
