# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'text'

module Chart
  class Promela
    # What the taken transitions leave: everything active inside their domains.
    class Leaving
      def initialize(document, names, tree, content)
        @document = document
        @names = names
        @tree = tree
        @content = content
      end

      def inline
        Text.inline('leave_states()', 'Histories first, while everything is active; then from the inside out.',
                    [marks, histories, states])
      end

      def marks_used
        @tree.domains.map { |domain| @names.leave(domain) }
      end

      private

      def marks
        @tree.domains.map do |domain|
          members = @document.transitions.select { |transition| @tree.domain(transition) == domain }
          "#{@names.leave(domain)} = #{Text.taken(members)}"
        end
      end

      def histories
        @document.histories.flat_map do |history|
          left = left(history.parent) or next []
          @tree.remembered(history).map do |state|
            memory = @names.memory(history, state)
            "#{memory} = (#{@names.active(history.parent)} && #{left} -> #{@names.active(state)} : #{memory})"
          end
        end
      end

      # In reverse document order.
      def states
        @tree.states.reverse.map do |state|
          left = left(state) or next []
          active = @names.active(state)
          content = @content.statements(state.exit)
          [content.empty? ? [] : Text.choose([["#{active} && #{left}", content]]), "#{active} = #{active} && !#{left}"]
        end
      end

      # The condition under which a state is left if it is active, nil if it never is.
      def left(state)
        domains = state.ancestors & @tree.domains
        Text.any(domains.map { |domain| @names.leave(domain) }) if domains.any?
      end
    end
  end
end
