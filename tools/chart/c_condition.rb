# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'flat'

module Chart
  # Guards in C. A chain of choices that ends in two outcomes becomes one condition with &&, so that each
  # side of each operator can be seen both true and false.
  class CCondition
    def initialize(document, names)
      @document = document
      @names = names
    end

    # [condition, decision if true, decision if false] of a choice; the first decision is never nil.
    def flatten(choice)
      literal, node, otherwise = first_literal(choice)
      literals = [literal]
      while (literal, following = next_literal(node, otherwise))
        literals << literal
        node = following
      end
      [bare(literals.join(' && '), literals.length), node, otherwise]
    end

    private

    # A lone comparison needs no parentheses of its own.
    def bare(condition, count)
      count == 1 ? condition.delete_prefix('(').delete_suffix(condition.start_with?('(') ? ')' : '') : condition
    end

    # One literal, what follows when it holds, what follows when it does not.
    def first_literal(choice)
      atom = truth(choice.atom)
      return ["!#{atom}", choice.no, choice.yes] if choice.yes.nil? || next_literal(choice.no, choice.yes)

      [atom, choice.yes, choice.no]
    end

    # A further literal with the same way out, or nil.
    def next_literal(node, otherwise)
      return nil if !node.is_a?(Flat::Choice) || otherwise.is_a?(Flat::Choice)

      atom = truth(node.atom)
      return [atom, node.yes] if node.no.equal?(otherwise) && node.yes
      return ["!#{atom}", node.no] if node.yes.equal?(otherwise) && node.no

      nil
    end

    def truth(atom)
      kind, name = atom
      return "inputs->#{name}" if kind == :input

      state = @document.state(name)
      return "#{@names.chart_function("in_#{name}")}(before)" unless state.leaf?

      "(before->#{@document.region_of(state).name} == #{@names.leaf(state)})"
    end
  end
end
