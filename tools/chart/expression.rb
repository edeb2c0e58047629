# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'strscan'

module Chart
  # Guards and invariants: In('state'), inputs, ! && || and parentheses, as in ECMAScript.
  # A parsed expression is nested arrays: [:in, id], [:input, name], [:not, a], [:and, a, b], [:or, a, b].
  module Expression
    # What is wrong with an expression, in words.
    class Unsupported < StandardError; end

    module_function

    def parse(text)
      Reader.new(text).read
    end

    # The truth of an expression; the block answers for its atoms.
    def true?(expression, &answer)
      operator, left, right = expression
      case operator
      when :not then !true?(left, &answer)
      when :and then true?(left, &answer) && true?(right, &answer)
      when :or then true?(left, &answer) || true?(right, &answer)
      else answer.call(expression)
      end
    end

    # [:in, id] and [:input, name] in order of first appearance.
    def atoms(expression)
      operator, left, right = expression
      case operator
      when :not then atoms(left)
      when :and, :or then atoms(left) | atoms(right)
      else [expression]
      end
    end

    # Recursive descent over the five forms.
    class Reader
      def initialize(text)
        @scanner = StringScanner.new(text)
      end

      def read
        expression = read_or
        fail_at unless @scanner.eos?
        expression
      end

      private

      def fail_at
        rest = @scanner.rest
        raise Unsupported, rest.empty? ? 'it ends too early' : "cannot read \"#{rest}\""
      end

      def take(pattern)
        @scanner.skip(/\s*/)
        found = @scanner.scan(pattern)
        @scanner.skip(/\s*/)
        found
      end

      def read_or
        left = read_and
        left = [:or, left, read_and] while take(/\|\|/)
        left
      end

      def read_and
        left = read_not
        left = [:and, left, read_not] while take(/&&/)
        left
      end

      def read_not
        return [:not, read_not] if take(/!(?!=)/)
        return read_group if take(/\(/)

        read_atom
      end

      def read_group
        inner = read_or
        take(/\)/) || fail_at
        inner
      end

      def read_atom
        if take(/In\(\s*'/)
          id = take(/\w+/) || fail_at
          take(/'\s*\)/) || fail_at
          [:in, id]
        else
          [:input, take(/[a-z][a-z0-9_]*(?!\w|\()/) || fail_at]
        end
      end
    end
  end
end
