# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'message'
require_relative 'routes'

module Interface
  # Messages and requests as JSON Schema 2020-12, the schemas of OpenAPI 3.1.
  #
  # @satisfies SWR-TOOL-020
  class Schema
    UINT32 = { 'type' => 'integer', 'minimum' => 0, 'maximum' => (2**32) - 1 }.freeze
    INT32 = { 'type' => 'integer', 'minimum' => -(2**31), 'maximum' => (2**31) - 1 }.freeze
    PLAIN = {
      'uint32' => UINT32, 'int32' => INT32, 'uint64' => { 'type' => 'integer', 'minimum' => 0 },
      'number' => { 'type' => 'number' }, 'flag' => { 'type' => 'boolean' }, 'text' => { 'type' => 'string' }
    }.freeze
    NUMBERS = { 'point' => 3, 'matrix' => 16 }.freeze

    def self.ref(name)
      { '$ref' => "#/components/schemas/#{name}" }
    end

    def initialize(model)
      @model = model
      @unions = {}
    end

    # All, by their names.
    def all
      schemas = @model.messages.to_h { |message| [message.typescript, answer(message)] }
      schemas.merge!(@model.routes.requests.to_h { |request| [request.typescript, request(request)] })
      schemas.merge!(@unions.sort.to_h)
      schemas.sort.to_h
    end

    # Schema of a parameter or a member of a request.
    def member(member)
      schema = single(member)
      return schema unless member.list?

      { 'type' => 'array', 'items' => schema, 'minItems' => member.list.first, 'maxItems' => member.list.last }
    end

    def header(header)
      PLAIN.fetch(header.type)
    end

    private

    def object(properties, required, says)
      { 'type' => 'object', 'description' => says, 'properties' => properties, 'required' => required }
        .reject { |key, value| key == 'required' && value.empty? }
    end

    def answer(message)
      shown = @model.sources(message).values.flatten(1)
      properties = shown.to_h { |field, one| [one.key, described(field.says, shown(field, one))] }
      required = properties.keys + message.members.reject(&:optional?).map(&:name)
      message.members.each { |member| properties[member.name] = described(member.says, added(member)) }
      object(properties, required, message.says)
    end

    # Any other member is refused.
    def request(request)
      properties = request.members.to_h { |one| [one.name, described(one.says, member(one))] }
      object(properties, request.members.reject(&:optional?).map(&:name), request.says)
        .merge('additionalProperties' => false).merge(choices(request))
    end

    def choices(request)
      request.choices.empty? ? {} : { 'oneOf' => request.choices.map { |names| { 'required' => names } } }
    end

    def described(says, schema)
      says ? schema.merge('description' => says) : schema
    end

    def or_null(schema)
      return { 'anyOf' => [schema, { 'type' => 'null' }] } if schema.key?('$ref')

      words = schema['enum'] && { 'enum' => [*schema['enum'], nil] }
      schema.merge('type' => [schema['type'], 'null']).merge(words.to_h)
    end

    def shown(field, shown)
      schema = form(field, shown.form)
      shown.conditions.empty? ? schema : or_null(schema)
    end

    def form(field, form)
      case form
      when 'named' then named(field.type)
      when 'set' then { 'type' => 'array', 'items' => named(field.type) }
      when 'name', 'state' then union(field.type)
      when 'flag', 'is_zero', 'bit' then PLAIN['flag']
      when 'number' then PLAIN.fetch(field.type.name, PLAIN['uint32'])
      when *NUMBERS.keys then numbers(NUMBERS[form])
      else PLAIN['number']
      end
    end

    def numbers(count)
      { 'type' => 'array', 'items' => PLAIN['number'], 'minItems' => count, 'maxItems' => count }
    end

    def named(type)
      { 'type' => 'object', 'properties' => { 'name' => union(type), 'text' => PLAIN['text'] },
        'required' => %w[name text] }
    end

    def union(type)
      return words(type.chart_name, type.leaves) if type.leaves

      enumeration(type.enumeration)
    end

    def enumeration(enumeration)
      words(enumeration.name, enumeration.values.map(&:name), enumeration.says)
    end

    def words(name, words, says = nil)
      name = @model.union_name(name)
      @unions[name] ||= described(says, { 'type' => 'string', 'enum' => words })
      Schema.ref(name)
    end

    def added(member)
      schema = one_added(member)
      schema = { 'type' => 'array', 'items' => schema } if member.list?
      member.null? ? or_null(schema) : schema
    end

    def one_added(member)
      return { 'type' => 'string', 'enum' => member.words } if member.words
      return words(Member::CODES, @model.problem_codes) if member.codes?
      return enumeration(member.enumeration) if member.enumeration

      return Schema.ref(member.message.typescript) if member.message

      schema = PLAIN.fetch(member.type)
      member.bounds ? schema.merge(%w[minimum maximum].zip(member.bounds).to_h) : schema
    end

    def single(member)
      return Schema.ref(member.message.typescript) if member.message
      return { 'type' => 'string', 'enum' => member.choices.map(&:first) } if member.words || member.some
      return enumeration(member.enumeration) if member.enumeration
      return { 'type' => 'string', 'maxLength' => member.size } if member.size

      bounded(member)
    end

    def bounded(member)
      return PLAIN['flag'] unless member.minimum

      ends = [member.minimum, member.maximum].map { |bound| member.whole? ? bound : bound.to_f }
      { 'type' => member.whole? ? 'integer' : 'number', 'minimum' => ends.first, 'maximum' => ends.last }
    end
  end
end
