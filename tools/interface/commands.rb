# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'c'
require_relative 'node'
require_relative 'command/payloads'

module Interface
  # A command: its data, its permitted senders, and the workphases in which it is obeyed, as core/interface/commands.yml
  # says, and modes.yml of those that arm a mode.
  #
  # @satisfies SWR-TOOL-011
  class Commands
    KEYS = %w[workphases payload from obeyed_by answers words label http].freeze
    # Up to so many are named; of more those that are left.
    NAMED_MOST = 4
    FROM = 'core/interface/commands.yml'

    # Further parts of the header.
    DECLARATION = <<~CODE
      /** Traits of a command. */
      typedef struct {
          /** Where it may be obeyed; bit n: workphase_t n. All bits: no workphase stands against it, or the chart of
           * workphases decides. */
          uint32_t workphases;
          uint32_t sources; /**< Permitted senders; bit n: command_source_t n. */
          uint32_t form;    /**< command_form_t. */
          uint32_t bytes;   /**< Size of its data. */
      } command_traits_t;

      /** By command_kind_t. */
      extern const command_traits_t command_traits[COMMAND_KIND_COUNT];
    CODE

    attr_reader :payloads

    def initialize(model)
      @kinds = model.enumeration('command_kind')
      @all = model.enumeration('workphase').values.map(&:name)
      @prefix = model.enumeration('workphase').prefix
      @modes = model.modes
      @payloads = Payloads.new(model, @kinds)
      @sources = model.enumeration('command_source')
      @workphases = @kinds.values.to_h { |value| [value.name, workphases_of(value)] }
    end

    # Adds to what is said of each where it may be obeyed.
    def complete
      @kinds.values.each { |value| value.says = with_workphases(value.says, value) }
    end

    def files
      { 'command.c' => source, 'command_access.c' => access, 'command_dispatch.c' => dispatch }
    end

    def prototypes
      [DECLARATION, payloads.prototypes].join("\n")
    end

    # `says` and where it may be obeyed.
    def with_workphases(says, value)
      [says, sentence(value)].reject(&:empty?).join(' ')
    end

    def find(name)
      to_a.find { |value| value.name == name }
    end

    def to_a
      @kinds.values
    end

    def constant(value)
      @kinds.constant(value)
    end

    # The mode that it arms; nil: none, or several.
    def mode(value)
      @modes&.of_command(value.name)
    end

    # The names of the sources that may send it.
    def senders_of(value)
      value.more['from']&.sequence&.map { |node| node.choice(@sources.values.map(&:name)) } || value.node.refuse('has no from')
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
      mode = mode(value)
      return own&.sequence&.map { |node| node.choice(@all) } unless mode

      own&.refuse("stand with the mode #{mode.value.name}")
      mode.workphases
    end

    def any_of(names)
      [names[0..-2].join(', '), names.last].reject(&:empty?).join(' or ')
    end

    def source
      rows = @kinds.values.map { |value|
        "    [#{@kinds.constant(value)}] = #{row(value)},
"
      }
      <<~CODE
        #{C.file('Traits of each command.', FROM).chomp}
        #include "command.h"

        #include "workphase_list.h"

        #include <stdbool.h>
        #include <stdint.h>

        #define IN(workphase) ((uint32_t)1U << (uint32_t)(workphase))
        #define IN_ALL UINT32_MAX
        #define BY(source) ((uint32_t)1U << (uint32_t)(source))

        const command_traits_t command_traits[COMMAND_KIND_COUNT] = {
        #{rows.join}};

        #{Payloads::CLEAR.chomp}
      CODE
    end

    # Apart: a program that takes none of them need not say what becomes of a broken contract.
    def access
      <<~CODE
        #{C.file('Data of a command, by its kind.', FROM).chomp}
        #include "command.h"

        #include "base/contract.h"

        #include <stdbool.h>

        static const char contract_module[] = "#{Payloads::MODULE}";

        #{payloads.functions.chomp}
      CODE
    end

    def row(value)
      "{.workphases = #{bits(@workphases[value.name])},
     .sources = #{senders(value)},
" \
        "     .form = (uint32_t)#{payloads.form(value)}, .bytes = #{size(value)}}"
    end

    def size(value)
      payloads.of(value) ? "(uint32_t)#{payloads.size(value)}" : payloads.size(value)
    end

    def senders(value)
      names = senders_of(value)
      names.empty? ? '0U' : names.map { |name| "BY(#{@sources.prefix}_#{name})" }.join(' | ')
    end

    # Each command with the function that carries it out.
    def dispatch
      by = @kinds.values.drop(1).group_by { |value| function(value) }
      cases = by.map do |name, values|
        "#{values.map { |value|
             "    case (uint32_t)#{@kinds.constant(value)}:
"
           }.join}" \
          "        status = #{name}(self, cycle, command, answer);
        break;
"
      end
      <<~CODE
        #{C.file('Which function carries out each command.', FROM).chomp}
        #include "controller/orders/controller_dispatch.h"

        status_t controller_dispatch(controller_t *self, const cycle_t *cycle, const command_t *command,
                                     answer_t *answer)
        {
            status_t status = STATUS_UNKNOWN_COMMAND;
            switch (command->kind) {
        #{cases.join.chomp}
            default:
                status = STATUS_UNKNOWN_COMMAND;
                break;
            }
            return status;
        }
      CODE
    end

    # `obeyed_by`, or what arms modes.
    def function(value)
      own = value.more['obeyed_by']
      is_mode = !mode(value).nil?
      value.node.refuse('has no obeyed_by and arms no mode') unless own || is_mode
      own&.refuse('stands with a command that arms a mode') if own && is_mode
      "controller_obey_#{own ? own.identifier : 'motion'}"
    end

    def bits(here)
      here ? here.map { |name| "IN(#{@prefix}_#{name})" }.join(" |\n        ") : 'IN_ALL'
    end
  end
end
