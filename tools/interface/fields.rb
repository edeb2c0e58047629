# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'c'

module Interface
  # Offsets and types of the fields of each structure, for programs that name a byte of one or list all of them.
  #
  # @satisfies SWR-TOOL-011
  class Fields
    FROM = 'core/interface'
    SAYS = 'Where the fields of the structures stand, and what they are.'
    PLAIN = { 'uint32' => 'UNSIGNED', 'int32' => 'SIGNED', 'uint64' => 'WIDE', 'flag' => 'FLAG', 'point' => 'POINT',
              'rigid' => 'RIGID' }.freeze

    OF_KIND = <<~CODE
      /** The fields of what a command of this command_kind says; NULL: nothing. */
      const field_t *fields_of_command(uint32_t kind);
    CODE

    OF_FORM = <<~CODE
      /** The fields of the data of an answer of this answer_form_t; NULL: it has none. */
      const field_t *fields_of_answer(uint32_t form);
    CODE

    def initialize(model)
      @forms = model.answer_forms
      @structures = model.structures.sort_by(&:name)
      @commands = model.commands
    end

    def files
      @structures.empty? ? {} : { 'fields.h' => header, 'fields.c' => source }
    end

    private

    def header
      tables = @structures.map { |one| "extern const field_t fields_#{one.name}[];\n" }.join
      C.file(SAYS, FROM) + C.guard('fields', <<~CODE)
        #include <stddef.h>

        #include <stdint.h>

        typedef enum {
            FIELD_UNSIGNED, /**< uint32_t. */
            FIELD_SIGNED,   /**< int32_t. */
            FIELD_WIDE,     /**< uint64_t. */
            FIELD_FLAG,     /**< uint32_t, 0 or 1. */
            FIELD_WORD,     /**< uint32_t, has a word. */
            FIELD_SET,      /**< uint32_t, each bit has a word. */
            FIELD_POSITION, /**< int32_t, where an axis is, in ticks. */
            FIELD_SPEED,    /**< int32_t, ticks/s with 8 bits of fraction; its name ends in _q8. */
            FIELD_POINT,    /**< point_t. */
            FIELD_RIGID,    /**< rigid_t. */
            FIELD_INSIDE    /**< Has fields of its own. */
        } field_kind_t;

        /** A field; the last one of a structure is followed by one without a name. */
        typedef struct field {
            const char *name;
            size_t offset;             /**< In the structure. */
            size_t size;               /**< All of it. */
            size_t element_size;       /**< Element of an array; otherwise the size. */
            const struct field *inside; /**< Its own fields; NULL: none. */
            field_kind_t kind;
            const char *(*word)(int32_t value); /**< Word of FIELD_WORD, and of a bit of FIELD_SET. */
            const char *says;
        } field_t;

        /** The fields of each structure; of a command and an answer without their data. */
        #{tables.chomp}
        #{"\n#{OF_KIND.chomp}" if @commands}
        #{"\n#{OF_FORM.chomp}" if @forms}
      CODE
    end

    def source
      <<~CODE
        #{C.file(SAYS, FROM).chomp}
        #include "fields.h"

        #include "names.h"

        #{@structures.map { |one| "#include \"interface/#{one.header}.h\"\n" }.uniq.sort.join}
        #define SIZE(structure, name) sizeof(((structure *)0)->name)

        #{(words + @structures.map { |one| table(one) } + of_kind + of_form).join("\n").chomp}
      CODE
    end

    # Names of the states of each chart that a field is of.
    def words
      @structures.flat_map(&:fields).map(&:type).select(&:leaves).uniq(&:chart_name).sort_by(&:chart_name).map do |type|
        <<~CODE
          static const char *#{type.chart_name}_word(int32_t value)
          {
              static const char *const words[] = {#{type.leaves.map { |leaf| C.string(leaf) }.join(', ')}};
              return ((value >= 0) && (value < #{type.leaves.size})) ? words[value] : "unknown";
          }
        CODE
      end
    end

    def of_kind
      return [] unless @commands

      cases = @commands.payloads.all.map do |payload|
        "#{payload.values.map { |value| "    case #{value.code}:\n" }.join}        return fields_#{payload.structure.name};\n"
      end
      ["const field_t *fields_of_command(uint32_t kind)\n{\n    switch (kind) {\n#{cases.join}    default:\n" \
       "        return NULL;\n    }\n}\n"]
    end

    def of_form
      return [] unless @forms

      cases = @forms.structures.map { |constant, one| "    case #{constant}:\n        return fields_#{one.name};\n" }
      ["const field_t *fields_of_answer(uint32_t form)\n{\n    switch (form) {\n#{cases.join}    default:\n" \
       "        return NULL;\n    }\n}\n"]
    end

    def table(structure)
      type = "#{structure.name}_t"
      rows = structure.fields.reject { |field| field.type.payload? }.map do |field|
        inside = field.type.structure ? "fields_#{field.type.structure.name}" : 'NULL'
        "    {\"#{field.name}\", offsetof(#{type}, #{field.name}), SIZE(#{type}, #{field.name}),\n" \
          "     SIZE(#{type}, #{field.name}#{'[0]' if field.count}), #{inside},\n" \
          "     FIELD_#{kind(field)}, #{word(field.type)}, #{C.string(field.says || field.type.name)}},\n"
      end
      "const field_t fields_#{structure.name}[] = {\n#{rows.join}    {.element_size = 1U},\n};\n"
    end

    def kind(field)
      type = field.type
      return 'SPEED' if field.name.end_with?('_ticks_per_s_q8')
      return 'POSITION' if field.shown.any? { |one| one.form == 'position' }
      return 'INSIDE' if type.structure
      return 'SET' if type.bits?

      word(type) == 'NULL' ? PLAIN.fetch(type.name, 'UNSIGNED') : 'WORD'
    end

    def word(type)
      return "#{type.enumeration.name}_name" if type.enumeration

      type.leaves ? "#{type.chart_name}_word" : 'NULL'
    end
  end
end
