# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../../tools/chartc/chart'

# The text of a guard, as mutants change it.
module Guard
  JOINED = { and: '&&', or: '||' }.freeze

  module_function

  # The questions of a guard, as text.
  def atoms(guard)
    guard ? Chart::Expression.atoms(Chart::Expression.parse(guard)).uniq.map { |atom| text(atom) } : []
  end

  # Without each part of the outermost && or ||: what is left out => what remains.
  def weakened(guard)
    expression = Chart::Expression.parse(guard)
    parts = operands(expression, expression.first)
    return {} if parts.length < 2

    parts.to_h do |part|
      [text(part), (parts - [part]).map { |one| text(one) }.join(" #{JOINED.fetch(expression.first)} ")]
    end
  end

  # The guard when the answer to one question is known: text, true or false.
  def assuming(guard, atom, answer)
    known = simplified(Chart::Expression.parse(guard), Chart::Expression.parse(atom), answer)
    known.first == :boolean ? known.last : text(known)
  end

  def operands(expression, kind)
    return [expression] unless JOINED.key?(kind) && expression.first == kind

    expression.drop(1).flat_map { |one| operands(one, kind) }
  end

  def simplified(expression, atom, answer)
    return [:boolean, answer] if expression == atom

    kind, *parts = expression
    return expression unless JOINED.key?(kind) || kind == :not

    parts = parts.map { |one| simplified(one, atom, answer) }
    return negated(parts.first) if kind == :not

    joined(kind, parts)
  end

  def negated(part)
    part.first == :boolean ? [:boolean, !part.last] : [:not, part]
  end

  def joined(kind, parts)
    decisive = [:boolean, kind == :or]
    return decisive if parts.include?(decisive)

    parts.reject { |one| one.first == :boolean }.reduce { |one, other| [kind, one, other] } || [:boolean, kind == :and]
  end

  def text(expression)
    kind, one, other = expression
    case kind
    when :in then "In('#{one}')"
    when :variable then one
    when :not then "!#{text(one)}"
    else "(#{text(one)} #{JOINED.fetch(kind)} #{text(other)})"
    end
  end
end
