# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'c'
require_relative 'routes'

module Interface
  # The structures that requests are read into, and the tables by which they are read.
  #
  # @satisfies SWR-TOOL-019
  class RequestTables
    FROM = 'core/interface/routes.yml'
    SAYS = 'What HTTP clients may send.'
    KINDS = { 'flag' => 'FLAG', 'uint32' => 'UINT32', 'int32' => 'INT32', 'number' => 'NUMBER', 'text' => 'TEXT' }.freeze

    def initialize(model)
      @routes = model.routes
      return unless @routes

      @messages = inner_first(@routes.requests) + @routes.routes.map(&:parameters).reject { |one| one.members.empty? }
    end

    def files
      @routes ? { 'requests.h' => header, 'requests.c' => source } : {}
    end

    private

    # A structure stands before those that hold it.
    def inner_first(requests)
      requests.flat_map { |request| inner_first(request.members.filter_map(&:message)) + [request] }.uniq
    end

    def header
      body = "#include \"request/request_fields.h\"\n\n/** Nothing. */\nextern const request_message_t request_nothing;\n\n" \
             "#{@messages.map { |message| declaration(message) }.join("\n")}\n#{rooms}"
      C.file(SAYS, FROM) + C.guard('requests', body)
    end

    # One room for whatever comes.
    def rooms
      queries = @routes.routes.map { |route| [route.name, route.parameters] }
      [['query', 'the parameters', queries], ['body', 'the body', bodies]].map do |name, what, all|
        members = all.reject { |_, message| message.members.empty? }
                     .map { |route, message| "    request_#{message.name}_t #{route};\n" }
        "/** Room for #{what} of any route, by its name, or by that of what several send. */\ntypedef union {\n    char nothing;\n" \
          "#{members.join}} request_#{name}_t;\n"
      end.join("\n")
    end

    def bodies
      @routes.routes.select(&:body).map { |route| [@routes.body_name(route), route.body] }.uniq
    end

    def declaration(message)
      "#{C.comment(message.says)}#{structure(message)}extern const request_message_t request_#{message.name};\n"
    end

    # There is no empty one in C.
    def structure(message)
      return if message.members.empty?

      fields = message.members.map { |member| "#{C.comment(member.says, '    ') if member.says}#{fields_of(member)}" }
      "typedef struct {\n#{fields.join}} request_#{message.name}_t;\n\n"
    end

    def fields_of(member)
      array = "[#{member.list.last}]" if member.list?
      array = "#{array}[#{member.size + 1}]" if member.size
      given = "    uint32_t #{member.name}_count;\n" if member.list?
      given ||= "    bool has_#{member.name};\n" if member.optional?
      "    #{member.c_type} #{member.name}#{array};\n#{given}"
    end

    def source
      "#{C.file(SAYS, FROM)}#include \"requests.h\"\n\nconst request_message_t request_nothing = {NULL, 0U};\n" \
        "#{@messages.map { |message| table(message) }.join}"
    end

    def table(message)
      count = message.members.size
      rows = message.members.map { |member| row(message, member) }
      fields = "\nstatic const request_field_t fields_#{message.name}[] = {\n#{rows.join(",\n")}};\n" unless count.zero?
      "#{message.members.map { |member| words(message, member) }.join}#{fields}\n" \
        "const request_message_t request_#{message.name} = {#{fields ? "fields_#{message.name}" : 'NULL'}, #{count}U};\n"
    end

    def words(message, member)
      return if member.choices.empty?

      rows = member.choices.map { |word, value| "    {#{C.string(word)}, #{value}U}" }
      "\nstatic const request_word_t #{words_name(message, member)}[] = {\n#{rows.join(",\n")}};\n"
    end

    def words_name(message, member)
      "words_#{message.name}_#{member.name}"
    end

    def row(message, member)
      structure = "request_#{message.name}_t"
      element = "((#{structure} *)0)->#{member.name}#{'[0]' if member.list?}"
      pairs = { 'name' => C.string(member.name), 'kind' => "REQUEST_#{kind(member)}",
                'offset' => "offsetof(#{structure}, #{member.name})", 'size' => "sizeof(#{element})" }
      pairs = pairs.merge(given(structure, member), bounds(message, member))
      "    {#{pairs.map { |key, value| ".#{key} = #{value}" }.join(",\n     ")}}"
    end

    def kind(member)
      return 'OBJECT' if member.message

      KINDS.fetch(member.type, 'WORD')
    end

    def given(structure, member)
      name = member.list? ? "#{member.name}_count" : "has_#{member.name}"
      pairs = {}
      pairs['given_offset'] = "offsetof(#{structure}, #{name})" if member.list? || member.optional?
      pairs['is_optional'] = 'true' if member.optional?
      pairs.merge!('least' => "#{member.list.first}U", 'most' => "#{member.list.last}U") if member.list?
      pairs
    end

    def bounds(message, member)
      return { 'message' => "&request_#{member.message.name}" } if member.message
      return number(member) if member.minimum
      return {} if member.choices.empty?

      { 'word_count' => "#{member.choices.size}U", 'words' => words_name(message, member) }
    end

    def number(member)
      unit = Units.written(member.name, member.unit&.text)
      pairs = { 'minimum' => decimal(member.minimum), 'maximum' => decimal(member.maximum) }
      unit ? pairs.merge('unit' => C.string(unit)) : pairs
    end

    def decimal(number)
      number.to_f.to_s
    end
  end
end
