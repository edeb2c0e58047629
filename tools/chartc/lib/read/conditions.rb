# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'data'
require_relative 'expression'

module Chart
  # Reads expressions and gives every name in them its meaning. Booleans and integers do not mix: ECMAScript would
  # convert them silently, C would not.
  class Conditions
    OPERANDS = { not: :boolean, and: :boolean, or: :boolean, add: :integer, subtract: :integer }.freeze
    HINT = "write In('state'), declared data, whole numbers, ! && || comparisons + - and parentheses"

    def initialize(context, states, data)
      @context = context
      @states = states
      @data = data
    end

    def guard(text, line)
      typed(text, line, :boolean)
    end

    # A property speaks of what the chart remembers; inputs are gone after the step, and there before it.
    def property(text, line)
      without_inputs(guard(text, line), line, 'a property')
    end

    # What the data are where it is asked, nobody knows.
    def place(text, line)
      expression = guard(text, line)
      data = Expression.atoms(expression).find { |kind, _name| kind == :variable }
      @context.refuse(line, 14, "the data of a damaged chart may be anything; remove \"#{data[1]}\"") if data
      expression
    end

    def assigned(text, line, variable)
      expression = typed(text, line, variable.kind == :integer ? :integer : :boolean)
      place = Expression.atoms(expression).find { |kind, _name| kind == :in }
      @context.refuse(line, 14, "an assigned value reads data only; remove In('#{place[1]}')") if place
      without_inputs(expression, line, 'an assigned value')
    end

    private

    def without_inputs(expression, line, what)
      input = Expression.atoms(expression).find { |kind, name| kind == :variable && @data.find(name).kind == :input }
      return expression unless input

      @context.refuse(line, 14, "#{what} reads no input; remove \"#{input[1]}\"")
    end

    def typed(text, line, wanted)
      expression = resolve(Expression.parse(text), line)
      found = type(expression, line)
      return expression if found == wanted

      @context.refuse(line, 14, "\"#{text}\" is of type #{found}; write one of type #{wanted}")
    rescue Expression::Unsupported => e
      @context.refuse(line, 14, "\"#{text}\": #{e.message}; #{HINT}")
    rescue Expression::TooDeep
      @context.refuse(line, 19, "more than #{Expression::DEEPEST} operators and parentheses stand inside each other; " \
                                'split the expression')
    end

    # A history is never active; conformance charts ask nevertheless.
    def resolve(expression, line)
      kind, id = expression
      return expression.map { |part| part.is_a?(Array) ? resolve(part, line) : part } unless kind == :in

      state = @states.find(id)
      return [:boolean, false] if state&.history? && @context.engine?
      return expression if state && !state.history?

      @context.refuse(line, 13, "In('#{id}') names no state; #{@context.choice(@states.ids)}")
    end

    def type(expression, line)
      case expression.first
      when :in, :boolean then :boolean
      when :number then integer(expression[1], line)
      when :variable then variable(expression[1], line)
      when :compare then comparison(expression, line)
      else operation(expression, line)
      end
    end

    def integer(number, line)
      return :integer if Data::INTEGERS.cover?(number)

      @context.refuse(line, 14, "#{number} is too large; write #{Data::INTEGERS.min} to #{Data::INTEGERS.max}")
    end

    def variable(name, line)
      found = @data.find(name)
      return found.kind == :integer ? :integer : :boolean if found

      known = ["<data id=\"#{name}\" expr=\"false\"/>", *@data.names]
      @context.refuse(line, 14, "\"#{name}\" is not declared; #{@context.choice(known)}")
    end

    def comparison(expression, line)
      _compare, operator, left, right = expression
      types = [type(left, line), type(right, line)]
      return :boolean if types == %i[integer integer] || (types == %i[boolean boolean] && %w[== !=].include?(operator))

      @context.refuse(line, 14, "#{operator} compares #{types.join(' with ')}; write integers on both sides")
    end

    def operation(expression, line)
      wanted = OPERANDS.fetch(expression.first)
      stray = Expression.operands(expression).find { |operand| type(operand, line) != wanted }
      return wanted unless stray

      @context.refuse(line, 14, "an operand of \"#{expression.first}\" is no #{wanted}; write a comparison")
    end
  end
end
