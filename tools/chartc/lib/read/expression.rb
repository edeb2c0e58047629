# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'strscan'

module Chart
  # Guards, properties and assigned values, as in ECMAScript. A parsed expression is nested arrays:
  # [:in, id], [:variable, name], [:number, n], [:boolean, b], [:not, a], [:and, a, b], [:or, a, b],
  # [:compare, op, a, b] with op one of == != < <= > >=, [:add, a, b], [:subtract, a, b].
  module Expression
    # What is wrong with an expression, in words.
    class Unsupported < StandardError; end

    # Deeper than DEEPEST.
    class TooDeep < StandardError; end

    # So many operators and parentheses inside each other.
    DEEPEST = 32
    COMPARISONS = { '===' => '==', '!==' => '!=' }.freeze

    module_function

    def parse(text)
      Reader.new(text).read
    end

    # The value of an expression; the block answers for [:in, id] and [:variable, name].
    def value(expression, &answer)
      kind, left, right, last = expression
      case kind
      when :in, :variable then answer.call(kind, left)
      when :number, :boolean then left
      when :not then !value(left, &answer)
      when :and then value(left, &answer) && value(right, &answer)
      when :or then value(left, &answer) || value(right, &answer)
      when :add then value(left, &answer) + value(right, &answer)
      when :subtract then value(left, &answer) - value(right, &answer)
      when :compare then value(right, &answer).public_send(left, value(last, &answer))
      end
    end

    # The leaves that need an answer, in order of first appearance.
    def atoms(expression)
      case expression.first
      when :in, :variable then [expression]
      else operands(expression).flat_map { |operand| atoms(operand) }.uniq
      end
    end

    def operands(expression)
      expression.drop(1).grep(Array)
    end

    def too_deep?(expression)
      (0..DEEPEST).reduce([expression]) { |level, _depth| level.flat_map { |one| operands(one) } }.any?
    end

    # Recursive descent; the precedence is that of ECMAScript.
    class Reader
      def initialize(text)
        @scanner = StringScanner.new(text)
        @depth = 0
      end

      def read
        expression = read_or
        fail_at unless @scanner.eos?
        raise TooDeep if Expression.too_deep?(expression)

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

      def inside
        raise TooDeep if (@depth += 1) > DEEPEST

        yield.tap { @depth -= 1 }
      end

      def read_or
        left = read_and
        left = [:or, left, read_and] while take(/\|\|/)
        left
      end

      def read_and
        left = read_equality
        left = [:and, left, read_equality] while take(/&&/)
        left
      end

      def read_equality
        left = read_relation
        while (operator = take(/[=!]==?/))
          left = [:compare, COMPARISONS.fetch(operator, operator), left, read_relation]
        end
        left
      end

      def read_relation
        left = read_sum
        while (operator = take(/[<>]=?(?![<>])/))
          left = [:compare, operator, left, read_sum]
        end
        left
      end

      def read_sum
        left = read_not
        while (operator = take(/\+(?!\+)|-(?!-)/))
          left = [operator == '+' ? :add : :subtract, left, read_not]
        end
        left
      end

      def read_not
        return [:not, inside { read_not }] if take(/!(?!=)/)
        return read_group if take(/\(/)

        read_atom
      end

      def read_group
        inner = inside { read_or }
        take(/\)/) || fail_at
        inner
      end

      def read_atom
        number = take(/-?(?:0|[1-9]\d*)(?![\w.])/)
        return [:number, number.to_i] if number
        return read_in if take(/In\(\s*'/)

        name = take(/[A-Za-z]\w*(?![\w(.\[])/) || fail_at
        %w[true false].include?(name) ? [:boolean, name == 'true'] : [:variable, name]
      end

      def read_in
        id = take(/[\w.-]+/) || fail_at
        take(/'\s*\)/) || fail_at
        [:in, id]
      end
    end
  end
end
