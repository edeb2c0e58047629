# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

module Chart
  module C
    # Line breaking for generated C: 100 columns, continuation under the opening parenthesis.
    module Layout
      WIDTH = 100

      module_function

      def banner(document, what)
        ['/* SPDX-License-Identifier: Apache-2.0 */',
         *comment("#{what} of the statechart #{document.name}, generated from #{document.name}.scxml by chartc. Do not " \
                  'edit.')]
      end

      def comment(text, indent = '')
        lines = wrap(harmless(text), WIDTH - indent.length - 6)
        return ["#{indent}/* #{lines.first} */"] if lines.length == 1

        ["#{indent}/* #{lines.first}", *lines[1..-2].map { |line| "#{indent}   #{line}" },
         "#{indent}   #{lines.last} */"]
      end

      # A remark behind a line of code; none without words.
      def remark(text)
        text.empty? ? '' : " /* #{harmless(text)} */"
      end

      # Nothing in a comment ends it, begins another one, or is a trigraph.
      def harmless(text)
        text.gsub('*/', '* /').gsub('/*', '/ *').gsub('??', '? ?')
      end

      def wrap(text, width)
        text.split.each_with_object([+'']) do |word, lines|
          if lines.last.empty? then lines[-1] = word
          elsif lines.last.length + 1 + word.length <= width then lines[-1] += " #{word}"
          else lines << word
          end
        end
      end

      # "type name(" + parameters; broken at commas when it gets too long.
      def call(head, arguments, tail)
        line = "#{head}(#{arguments.join(', ')})#{tail}"
        return [line] if line.length <= WIDTH

        pad = ' ' * (head.length + 1)
        rows = wrap(arguments.map { |one| one.gsub(' ', "\u0001") }.join(', '), WIDTH - pad.length - tail.length - 1)
        rows = rows.map.with_index { |row, index| (index.zero? ? "#{head}(" : pad) + row.tr("\u0001", ' ') }
        rows[-1] = "#{rows[-1]})#{tail}"
        rows
      end

      # A long condition, continued at its operators.
      def at_operators(line, width = 80)
        return [line] if line.length <= width

        rows = line.split(/(?<= && )|(?<= \|\| )/).each_with_object([+'']) do |part, found|
          found.last.length + part.length > width && !found.last.empty? ? found << part : found.last << part
        end
        rows.map.with_index { |row, index| (index.zero? ? '' : '    ') + row.rstrip }
      end

      # The body of a function that returns whether its tests are true.
      def joined(tests, operator = '&&')
        return ["    return #{tests.first};"] if tests.length == 1

        short = "    return (#{tests.join(" #{operator} ")});"
        return [short] if short.length <= WIDTH

        rows = tests.map.with_index do |test, index|
          "#{index.zero? ? '    return (' : '            '}#{test}#{index == tests.length - 1 ? ');' : " #{operator}"}"
        end
        [rows]
      end

      def text(lines)
        "#{lines.flatten.join("\n")}\n"
      end
    end
  end
end
