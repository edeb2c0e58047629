# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../../flatten/decisions'

module Chart
  module C
    # Expressions in C. holder is the structure that states and data are read from.
    class Expressions
      ARITHMETIC = { add: '+', subtract: '-' }.freeze

      def initialize(document, regions, names)
        @document = document
        @regions = regions
        @names = names
      end

      # Compound expressions come with parentheses around them.
      def text(expression, holder = 'self')
        kind, left, right, last = expression
        case kind
        when :in then place(@document.state(left), holder)
        when :variable then variable(left, holder)
        when :number then left.negative? ? "(#{left})" : left.to_s
        when :boolean then left.to_s
        when :not then "!#{text(left, holder)}"
        when :compare then "(#{text(right, holder)} #{left} #{text(last, holder)})"
        when :and then "(#{text(left, holder)} && #{text(right, holder)})"
        when :or then "(#{text(left, holder)} || #{text(right, holder)})"
        else "(#{text(left, holder)} #{ARITHMETIC.fetch(kind)} #{text(right, holder)})"
        end
      end

      # The same without parentheses around a lone comparison.
      def bare(text)
        inner = text[1..-2]
        text.start_with?('(') && !inner.match?(/[()]/) && text.end_with?(')') ? inner : text
      end

      # [condition, decision if true, decision if false] of a choice; the first decision is never nil. A chain of
      # choices with two outcomes is one condition with &&, so that each operand is seen both true and false.
      def flatten(choice, holder)
        literal, node, otherwise = first_literal(choice, holder)
        literals = [literal]
        while (literal, following = next_literal(node, otherwise, holder))
          literals << literal
          node = following
        end
        [literals.length == 1 ? bare(literals.first) : literals.join(' && '), node, otherwise]
      end

      # In('state') as a condition on the field of its region.
      def place(state, holder)
        region = @regions.of(state)
        return 'true' unless region

        leaves = region.leaves.select { |leaf| leaf == state || leaf.inside?(state) }
        tests = leaves.map { |leaf| "(#{holder}->#{@names.field(region.name)} == #{@names.leaf(leaf)})" }
        return tests.first if tests.length == 1
        return others(region, leaves, holder) if tests.length > region.leaves.length / 2

        "(#{tests.join(' || ')})"
      end

      private

      # Fewer comparisons: in none of the others.
      def others(region, leaves, holder)
        rest = @names.values(region) - leaves
        return 'true' if rest.empty?

        tests = rest.map { |leaf| "(#{holder}->#{@names.field(region.name)} != #{@names.value(region, leaf)})" }
        tests.length == 1 ? tests.first : "(#{tests.join(' && ')})"
      end

      def variable(name, holder)
        found = @document.variables.find { |variable| variable.name == name }
        found.kind == :input ? "inputs->#{@names.field(name)}" : "#{holder}->#{@names.field(name)}"
      end

      # One literal, what follows when it holds, what follows when it does not.
      def first_literal(choice, holder)
        atom = text(choice.atom, holder)
        return ["!#{atom}", choice.no, choice.yes] if choice.yes.nil? || next_literal(choice.no, choice.yes, holder)

        [atom, choice.yes, choice.no]
      end

      # A further literal with the same way out, or nil.
      def next_literal(node, otherwise, holder)
        return nil if !node.is_a?(Decisions::Choice) || otherwise.is_a?(Decisions::Choice)

        atom = text(node.atom, holder)
        return [atom, node.yes] if node.no.equal?(otherwise) && node.yes
        return ["!#{atom}", node.no] if node.yes.equal?(otherwise) && node.no

        nil
      end
    end
  end
end
