# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'c'

module Interface
  # Names and sentences of enumerations, for the processes.
  #
  # @satisfies SWR-CMD-004
  class Names
    FROM = 'core/interface'

    WHERE = <<~CODE
      /** Where the command_kind `value` may be obeyed, as a sentence; "" without workphases. Lives for ever. */
      const char *command_kind_where(int32_t value);
    CODE

    def initialize(model)
      @commands = model.commands
      @enumerations = model.enumerations.sort_by(&:name)
    end

    def files
      { 'names.h' => header, 'names.c' => source }
    end

    private

    def header
      declarations = @enumerations.map do |one|
        <<~CODE
          /** Name of the #{one.name} `value`, or "UNKNOWN". Lives for ever. */
          const char *#{one.name}_name(int32_t value);

          /** Sentence for the #{one.name} `value`, or "Unknown.". Lives for ever. */
          const char *#{one.name}_text(int32_t value);
        CODE
      end
      declarations << WHERE if @commands
      C.file('Names and sentences of enumerations.', FROM) +
        C.guard('names', "#include <stdint.h>\n\n#{declarations.join("\n")}")
    end

    def source
      functions = @enumerations.flat_map do |one|
        [function(one, 'name', 'UNKNOWN', &:name), function(one, 'text', 'Unknown.', &:says)]
      end
      functions += @enumerations.select { |one| @commands && one.name == 'command_kind' }.map do |one|
        function(one, 'where', '') { |value| @commands.sentence(value) }
      end
      "#{C.file('Names and sentences of enumerations.', FROM)}#include \"names.h\"\n\n#{functions.join("\n")}"
    end

    def function(enumeration, suffix, unknown)
      cases = enumeration.values.map { |value| "    case #{value.code}:\n        return #{C.string(yield(value))};\n" }
      <<~CODE
        const char *#{enumeration.name}_#{suffix}(int32_t value)
        {
            switch (value) {
        #{cases.join.chomp}
            default:
                return "#{unknown}";
            }
        }
      CODE
    end
  end
end
