# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'c'
require_relative 'message'

module Interface
  # The writer of what the HTTP server sends.
  #
  # @satisfies SWR-TOOL-011
  class Json
    FROM = 'core/interface'
    SAYS = 'What the HTTP server sends, as JSON.'
    # For the names, for the forms, and for the constants of the form bit.
    INCLUDES = %w[assets/chart_names card/card_frame exchange/exchange http/view/json_forms http/view/telemetry_units
                  interface/app/names].freeze

    def initialize(model)
      @model = model
    end

    def files
      { 'messages.h' => header, 'messages.c' => source }
    end

    private

    def messages
      @model.messages.reject(&:by_hand?)
    end

    def header
      own = @model.structures.map { |one| "interface/#{one.header}" }.push('robot/robot').uniq.sort
      body = "#{includes(own)}\n#include <cjson/cJSON.h>\n#include <stdbool.h>\n#include <stdint.h>\n\n" \
             "#{messages.map { |message| declaration(message) }.join("\n")}"
      C.file("#{SAYS} The caller owns each result and gives away the objects that it puts into another; " \
             'NULL without memory.', FROM) + C.guard('messages', body)
    end

    def includes(names)
      names.map { |name| "#include \"#{name}.h\"\n" }.join
    end

    def declaration(message)
      members = message.members.map do |member|
        "#{C.comment(member.says, '    ') if member.says}    #{member.c}#{' ' unless member.c.end_with?('*')}" \
          "#{member.name};\n"
      end
      struct = "/** Members that the server adds to it. */\ntypedef struct {\n#{members.join}} json_#{message.name}_t;\n\n"
      "#{struct unless members.empty?}#{C.comment(message.says)}#{prototype(message)};\n"
    end

    def prototype(message)
      parameters = @model.sources(message).keys.map { |structure| "const #{structure.name}_t *#{structure.name}" }
      parameters << 'const axis_config_t *axis' if message.axis?
      parameters << "const json_#{message.name}_t *also" unless message.members.empty?
      "cJSON *json_#{message.name}(#{parameters.join(', ')})"
    end

    def source
      functions = messages.map { |message| function(message) }
      "#{C.file(SAYS, FROM)}#include \"messages.h\"\n\n#{includes(INCLUDES)}\n#{functions.join("\n")}"
    end

    def function(message)
      fields = @model.sources(message).flat_map do |structure, shown|
        shown.map { |field, one| field_line(structure, field, one) }
      end
      members = message.members.map { |member| member_line(member) }
      "#{prototype(message)}\n{\n    cJSON *const object = cJSON_CreateObject();\n#{(fields + members).join}" \
        "    return object;\n}\n"
    end

    def field_line(structure, field, shown)
      of = shown.argument || (field.type.leaves ? field.type.chart_name : field.type.enumeration&.name)
      add = format(Forms::ALL.fetch(shown.form).c, key: C.string(shown.key), value: "#{structure.name}->#{field.name}",
                                                   of: of, count: field.type.enumeration&.values.to_a.size)
      return "    #{add};\n" if shown.conditions.empty?

      optional(shown.conditions.map { |name| structure.condition(name, shown.node) }.join(' && '), shown.key, add)
    end

    def member_line(member)
      value = "also->#{member.name}"
      return "    #{member.add(value)};\n" unless member.null?

      optional("#{value} != NULL", member.name, member.add(value))
    end

    def optional(condition, key, add)
      "    if (#{condition}) {\n        #{add};\n    } else {\n" \
        "        json_add_null(object, #{C.string(key)});\n    }\n"
    end
  end
end
