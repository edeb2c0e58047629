# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../model'

module Chart
  # Parts of a chart as people read them: in drawings, on the page and in differences.
  module Words
    BINARY = { and: '&&', or: '||', add: '+', subtract: '-' }.freeze

    module_function

    # "100 ms", "60 s", "250 us": in the largest unit without a remainder.
    def duration(microseconds)
      return "#{microseconds / 1_000_000} s" if (microseconds % 1_000_000).zero?
      return "#{microseconds / 1000} ms" if (microseconds % 1000).zero?

      "#{microseconds} us"
    end

    # The pieces of content in the order of execution, raised events that follow each other in one piece.
    def content(items)
      items.chunk_while { |one, other| one.is_a?(Raise) && other.is_a?(Raise) }.flat_map do |run|
        run.first.is_a?(Raise) ? ["raise #{run.map(&:event).join(', ')}"] : [piece(run.first)]
      end
    end

    def piece(item)
      case item
      when Act then item.name
      when Raise then "raise #{item.event}"
      when Send then "start #{item.timer.id}"
      when Cancel then "stop #{item.timer.id}"
      when Assign then "#{item.variable.name} := #{expression(item.expression)}"
      end
    end

    def expression(tree)
      kind, left, right, last = tree
      case kind
      when :in then "In('#{left}')"
      when :variable, :number, :boolean then left.to_s
      when :not then "!#{operand(left)}"
      when :compare then "#{operand(right)} #{left} #{operand(last)}"
      else "#{operand(left, kind)} #{BINARY.fetch(kind)} #{operand(right)}"
      end
    end

    # In parentheses, but for atoms and for chains of the same operator.
    def operand(tree, chain = nil)
      plain = %i[in variable number boolean not].include?(tree.first) || tree.first == chain
      plain ? expression(tree) : "(#{expression(tree)})"
    end

    # The states whose entry starts the timer.
    def starters(document, timer)
      document.states.select { |state| state.entry.grep(Send).any? { |send| send.timer.equal?(timer) } }
    end
  end
end
