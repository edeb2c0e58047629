# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'c'

module Interface
  # Where the fields of each structure stand, for who speaks of a byte of one.
  #
  # @satisfies SWR-TOOL-011
  class Fields
    FROM = 'core/interface'
    SAYS = 'Where the fields of the structures stand.'

    def initialize(model)
      @structures = model.structures.sort_by(&:name)
    end

    def files
      @structures.empty? ? {} : { 'fields.h' => header, 'fields.c' => source }
    end

    private

    def header
      tables = @structures.map { |one| "extern const field_t fields_#{one.name}[];\n" }.join
      C.file(SAYS, FROM) + C.guard('fields', <<~CODE)
        #include <stddef.h>

        /** A field; the last one of a structure is followed by one without a name. */
        typedef struct field {
            const char *name;
            size_t offset;             /**< Of the structure. */
            size_t size;               /**< All of it. */
            size_t element_size;       /**< Of an array; otherwise the size. */
            const struct field *inside; /**< Its own fields; NULL: none. */
        } field_t;

        /** The fields of each structure. */
        #{tables.chomp}
      CODE
    end

    def source
      <<~CODE
        #{C.file(SAYS, FROM).chomp}
        #include "fields.h"

        #{@structures.map { |one| "#include \"interface/#{one.header}.h\"\n" }.uniq.sort.join}
        #define SIZE(structure, name) sizeof(((structure *)0)->name)

        #{@structures.map { |one| table(one) }.join("\n").chomp}
      CODE
    end

    def table(structure)
      type = "#{structure.name}_t"
      rows = structure.fields.map do |field|
        inside = field.type.structure ? "fields_#{field.type.structure.name}" : 'NULL'
        "    {\"#{field.name}\", offsetof(#{type}, #{field.name}), SIZE(#{type}, #{field.name}),\n" \
          "     SIZE(#{type}, #{field.name}#{'[0]' if field.count}), #{inside}},\n"
      end
      "const field_t fields_#{structure.name}[] = {\n#{rows.join}    {NULL, 0U, 0U, 1U, NULL},\n};\n"
    end
  end
end
