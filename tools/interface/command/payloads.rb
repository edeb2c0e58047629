# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative '../c'
require_relative '../node'

module Interface
  # Data of commands: for each kind the structure command_PAYLOAD, all of them as a tagged union with checked accessors.
  #
  # @satisfies SWR-TOOL-080
  class Payloads
    PREFIX = 'command_'
    MODULE = 'command'
    Payload = Struct.new(:name, :structure, :values, keyword_init: true) do
      def form
        "COMMAND_FORM_#{name.upcase}"
      end
    end

    attr_reader :all

    def initialize(model, kinds)
      @kinds = kinds
      @all = payloads(model)
      unused(model)
    end

    # nil: it is said by its kind alone.
    def of(value)
      @all.find { |payload| payload.values.include?(value) }
    end

    def c_type
      'command_payload_t'
    end

    def bytes
      @all.map { |payload| payload.structure.bytes }.max
    end

    def union
      members = @all.map { |one| "    #{one.structure.name}_t #{one.name}; /**< #{names(one)}. */\n" }
      <<~CODE
        /** Data of a command, in the member of its kind. */
        typedef union {
        #{members.join}} command_payload_t;
      CODE
    end

    def prototypes
      forms = @all.each_with_index.map { |one, index| "    #{one.form} = #{index + 1}" }
      <<~CODE
        /** Which member of command_payload_t a kind has. */
        typedef enum {
            COMMAND_FORM_NONE = 0,
        #{forms.join(",\n")}
        } command_form_t;

        #{@all.map { |one| accessor(one) }.join("\n").chomp}

        /** Makes all bytes 0 that a command of its kind does not use; of an unknown kind all that it says. */
        void command_clear_unused(command_t *command);
      CODE
    end

    def form(value)
      of(value)&.form || 'COMMAND_FORM_NONE'
    end

    def size(value)
      payload = of(value)
      payload ? "sizeof(#{payload.structure.name}_t)" : '0U'
    end

    # @satisfies SWR-CMD-008
    def functions
      all = @all.each_with_index.map do |one, index|
        <<~CODE
          const #{one.structure.name}_t *command_as_#{one.name}(const command_t *command)
          {
              REQUIRE(#{index + 1}U, has_form(command, #{one.form}));
              return &command->as.#{one.name};
          }
        CODE
      end
      "#{HAS_FORM}\n#{all.join("\n")}"
    end

    HAS_FORM = <<~CODE
      static bool has_form(const command_t *command, command_form_t form)
      {
          return (command->kind < COMMAND_KIND_COUNT) &&
                 (command_traits[command->kind].form == (uint32_t)form);
      }
    CODE

    CLEAR = <<~CODE
      void command_clear_unused(command_t *command)
      {
          const bool is_known = command->kind < COMMAND_KIND_COUNT;
          const uint32_t used = is_known ? command_traits[command->kind].bytes : 0U;
          uint8_t *const bytes = (uint8_t *)&command->as;
          for (uint32_t i = used; i < (uint32_t)sizeof command->as; i++) {
              bytes[i] = 0U;
          }
      }
    CODE

    private

    def payloads(model)
      named = @kinds.values.select { |value| value.more.key?('payload') }
      named.group_by { |value| value.more['payload'].identifier }.map do |name, values|
        structure = model.structure("#{PREFIX}#{name}")
        values.first.more['payload'].refuse("is #{name}; expected a structure #{PREFIX}NAME") unless structure
        Payload.new(name: name, structure: structure, values: values)
      end
    end

    def unused(model)
      model.structures.select { |one| one.header == @kinds.header && one.name.start_with?(PREFIX) }.each do |structure|
        next if @all.any? { |payload| payload.structure == structure }

        raise Refused.new('core/interface', structure.name, 'is the payload of no command')
      end
    end

    def accessor(payload)
      "/** Of #{names(payload)} (contract #{@all.index(payload) + 1}). */\n" \
        "const #{payload.structure.name}_t *command_as_#{payload.name}(const command_t *command);\n"
    end

    def names(payload)
      payload.values.map(&:name).join(', ')
    end
  end
end
