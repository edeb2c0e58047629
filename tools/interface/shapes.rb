# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'tsort'
require_relative 'message'
require_relative 'schema'

module Interface
  # The messages once more, as tables by which the console checks what it is sent. Each has the name of its type.
  #
  # @satisfies SWR-CON-039
  class Shapes
    include TSort

    HEAD = <<~CODE
      /** Demands on a value. A whole number has its least and its most, a list may have its length; of `named` are name and text, the name one of these words. */
      export type Kind =
        | "number"
        | readonly ["whole", number, number]
        | "string"
        | "boolean"
        | Shape<unknown>
        | readonly ["words", readonly string[]]
        | readonly ["named", Kind]
        | readonly ["list", Kind, number?]
        | readonly ["null", Kind]
        | readonly ["optional", Kind];

      /** Demands on a message. */
      export interface Shape<Message> {
        readonly members: Readonly<Record<string, Kind>>;
        /** Never there: only says what it is the shape of. */
        readonly of?: Message;
      }
    CODE

    # `unions`: the words of each, by name.
    def initialize(model, unions)
      @model = model
      @unions = unions
    end

    def text
      words = @unions.sort.map { |name, all| "export const #{name}: Kind = [\"words\", #{JSON.generate(all)}];\n" }
      [HEAD, words.join, *tsort.map { |message| table(message) }].join("\n")
    end

    private

    def tsort_each_node(&)
      @model.messages.each(&)
    end

    # A table stands behind those that it names.
    def tsort_each_child(message, &)
      message.members.filter_map(&:message).each(&)
    end

    def table(message)
      shown = @model.sources(message).values.flatten(1)
      members = shown.map { |field, one| [one.key, shown(field, one)] } +
                message.members.map { |one| [one.name, added(one)] }
      lines = members.map { |name, kind| "    #{name}: #{kind},\n" }
      "export const #{message.typescript}: Shape<#{message.typescript}> = {\n  members: {\n#{lines.join}  },\n};\n"
    end

    def shown(field, shown)
      kind = form(field.type, shown.form)
      shown.conditions.empty? ? kind : tagged('null', kind)
    end

    def form(type, form)
      case form
      when 'flag', 'is_zero', 'bit' then '"boolean"'
      when 'name', 'state' then union(type)
      when 'named' then tagged('named', union(type))
      when 'set' then tagged('list', tagged('named', union(type)))
      when *Schema::NUMBERS.keys then tagged('list', '"number"', Schema::NUMBERS[form])
      when 'number' then whole(Member::WHOLE.fetch(type.name, Member::WHOLE['uint32']))
      else '"number"'
      end
    end

    def whole(bounds)
      "[\"whole\", #{bounds.join(', ')}]"
    end

    def added(member)
      kind = one_added(member)
      kind = tagged('list', kind) if member.list?
      kind = tagged('null', kind) if member.null?
      member.optional? ? tagged('optional', kind) : kind
    end

    def one_added(member)
      return tagged('words', JSON.generate(member.words)) if member.words
      return @model.union_name(Member::CODES) if member.codes?
      return @model.union_name(member.enumeration.name) if member.enumeration

      return whole(member.bounds) if member.bounds

      member.message ? member.message.typescript : "\"#{Member::TYPES.dig(member.type, 1)}\""
    end

    def union(type)
      @model.union_name(type.leaves ? type.chart_name : type.enumeration.name)
    end

    def tagged(*parts)
      "[\"#{parts.first}\", #{parts.drop(1).join(', ')}]"
    end
  end
end
