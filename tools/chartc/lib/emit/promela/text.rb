# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

module Chart
  class Promela
    # The few forms of Promela that the emitter writes. A statement is a text without its semicolon.
    module Text
      module_function

      def indent(text)
        text.gsub(/^(?=.)/, '  ')
      end

      def block(statements)
        statements.flatten.join(";\n")
      end

      # options: [guard, statements], the first one that holds is taken, as a d_step does it; none is no step.
      def choose(options, otherwise = [])
        return [] if options.empty?

        rest = otherwise.empty? ? ":: else\n" : option('else', otherwise)
        "if\n#{options.map { |guard, statements| option(guard, statements) }.join}#{rest}fi"
      end

      def option(guard, statements)
        body = block(statements)
        ":: #{guard} ->\n#{indent(indent(body.empty? ? 'skip' : body))}\n"
      end

      def repeat(guard, statements)
        "do\n#{option(guard, statements)}:: else -> break\nod"
      end

      # For `place` from 0 to a limit; a d_step cannot end in a loop.
      def each_place(limit, statements)
        [repeat("place < #{limit}", [*statements, 'place++']), 'place = 0']
      end

      def inline(head, comment, statements)
        body = block(statements)
        "/* #{comment} */\ninline #{head} {\n#{indent(body.empty? ? 'skip' : body)}\n}\n"
      end

      # The value after the first condition that holds, else 0.
      def first(options)
        options.reverse.reduce('0') { |rest, (condition, value)| "(#{condition} -> #{value} :\n#{rest})" }
      end

      # One of the transitions is taken; nil is the start of the chart.
      def taken(transitions)
        any(transitions.map { |one| "fate[#{one ? one.number : 'INITIAL'}] == TAKEN" })
      end

      def any(terms)
        terms.length == 1 ? terms.first : "(#{terms.join(' || ')})"
      end
    end
  end
end
