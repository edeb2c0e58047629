# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'c'

module Interface
  # The headers of the core: enumerations and structures with their documentation.
  #
  # @satisfies SWR-TOOL-011
  class Headers
    def initialize(model)
      @model = model
    end

    def files
      @model.headers.to_h { |header| ["#{header.name}.h", text(header)] }
            .merge('event.c' => severities).merge(@model.modes&.files || {}, @model.commands&.files || {}, @model.answer_forms&.files || {}).compact
    end

    private

    def text(header)
      body = [includes(header), *header.enumerations.map { |one| enumeration(one) },
              *header.structures.map { |one| structure(one) }, prototypes(header)].compact.join("\n")
      "#{C.file(header.says, "core/interface/#{File.basename(header.file)}")}#{C.guard(header.name, body)}"
    end

    def includes(header)
      types = header.structures.flat_map(&:fields).map(&:type)
      own = types.filter_map(&:header).uniq - [header.name]
      own += counted(header)
      lines = own.sort.map { |name| "#include \"#{name}.h\"\n" }.join
      lines += "#{"\n" unless lines.empty?}#include <stdint.h>\n" if numbers?(header)
      lines += "#include <stdbool.h>\n#include <stdint.h>\n" if modes?(header)
      lines unless lines.empty?
    end

    def numbers?(header)
      !header.structures.empty? || header.enumerations.any? { |one| !one.sets.empty? }
    end

    # Where the lengths of its arrays stand.
    def counted(header)
      own = header.enumerations.map { |one| "#{one.name.upcase}_COUNT" }
      counts = header.structures.flat_map(&:fields).filter_map(&:count) - own
      counts.map { |count| count.start_with?('LIMIT_') ? 'limits/requirement_limits' : 'robot/robot' }.uniq
    end

    def enumeration(enumeration)
      values = enumeration.values.map do |value|
        "#{C.comment(value.says, '    ')}    #{enumeration.constant(value)} = #{value.code}"
      end
      count = "\n#define #{enumeration.name.upcase}_COUNT #{enumeration.values.size}U\n" if enumeration.counted?
      sets = enumeration.sets.map { |set| set(enumeration, set) }
      "#{C.comment(enumeration.says)}typedef enum {\n#{values.join(",\n")}\n} #{enumeration.c_type};\n#{count}#{sets.join}"
    end

    def set(enumeration, set)
      bits = set.values.map { |value| "((uint64_t)1U << (uint32_t)#{enumeration.constant(value)})" }
      "\n#{C.comment("Bit n, value n: #{set.says}")}" \
        "#define #{enumeration.name.upcase}S_#{set.name} \\\n    (#{bits.join(" | \\\n     ")})\n"
    end

    def structure(structure)
      fields = structure.fields.map do |field|
        about = field.comment
        "#{C.comment(about, '    ') unless about.empty?}    #{field.type.c} #{field.name}" \
          "#{"[#{field.count}]" if field.count};\n"
      end
      payloads = structure.fields.filter_map { |field| field.type.payloads }.first
      union = "#{payloads.union}\n" if payloads
      "#{union}#{C.comment(structure.says) if structure.says}typedef struct {\n#{fields.join}} #{structure.name}_t;\n"
    end

    def modes?(header)
      header.enumerations.any? { |one| one.name == 'mode_kind' }
    end

    def commands?(header)
      @model.commands && header.enumerations.any? { |one| one.name == 'command_kind' }
    end

    def answers?(header)
      @model.answer_forms && header.structures.any? { |one| one.name == 'answer' }
    end

    def prototypes(header)
      return Modes::DECLARATION if modes?(header)
      return @model.commands.prototypes if commands?(header)
      return @model.answer_forms.prototypes if answers?(header)
      return unless header.enumerations.any? { |one| one.name == 'event_id' }

      <<~CODE
        /** How much an event matters: CRITICAL when it is not known. */
        event_severity_t event_severity(event_id_t id);
      CODE
    end

    def severities
      return unless @model.events

      ids = @model.enumeration('event_id')
      rows = @model.events.events.sort_by { |event| event.value.code }.map do |event|
        "        EVENT_SEVERITY_#{event.severity.upcase}, /* #{ids.constant(event.value)} */\n"
      end
      <<~CODE
        #{C.file('How much events matter.', 'core/interface/events.yml').chomp}
        #include "event.h"

        #include <stdint.h>

        event_severity_t event_severity(event_id_t id)
        {
            static const event_severity_t severities[EVENT_ID_COUNT] = {
        #{rows.join}    };
            return ((uint32_t)id < EVENT_ID_COUNT) ? severities[id] : EVENT_SEVERITY_CRITICAL;
        }
      CODE
    end
  end
end
