# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'strscan'

module Robot
  # A formula of kinematics.yml: numbers, names, + - * / and brackets; sqrt(a), square(a), and atan(a, b), the angle in
  # degrees of a point that is b ahead and a aside.
  class Formula
    TOKEN = %r{\s*(\d+(?:\.\d+)?|[a-z]\w*|[-+*/(),])\s*}
    FUNCTIONS = { 'sqrt' => ->(a) { Math.sqrt(a) }, 'square' => ->(a) { a * a },
                  'atan' => ->(a, b) { Math.atan2(a, b) * 180 / Math::PI } }.freeze

    def initialize(text)
      @text = text
    end

    # `values`: numbers by name. Raises ArgumentError when it is no formula of them, or has no value.
    def value(values)
      @values = values
      @tokens = tokens
      result = sum
      @tokens.empty? ? result : stray(@tokens.first)
    rescue Math::DomainError
      raise ArgumentError, "#{@text} has no value"
    end

    # The same as TypeScript, with functions of these names; the block says each other name there.
    def script
      tokens.map { |token| token.match?(/\A[a-z]/) && !FUNCTIONS.key?(token) ? yield(token) : token }.join(' ')
    end

    private

    def stray(token)
      raise ArgumentError, "#{@text} is not a formula: #{token || 'its end'}"
    end

    def tokens
      scanner = StringScanner.new(@text)
      found = []
      found << (scanner.scan(TOKEN) ? scanner[1] : stray(scanner.rest)) until scanner.eos?
      found
    end

    def sum
      chain(%w[+ -]) { product }
    end

    def product
      chain(%w[* /]) { factor }
    end

    def chain(operators)
      result = yield
      while operators.include?(@tokens.first)
        operator = @tokens.shift
        result = result.public_send(operator, yield)
      end
      result
    end

    def factor
      token = @tokens.shift
      case token
      when '-' then -factor
      when '(' then closed(sum)
      when /\A\d/ then Rational(token)
      else FUNCTIONS.key?(token) ? call(token) : @values.fetch(token) { stray(token) }
      end
    end

    def call(name)
      take('(')
      arguments = Array.new(FUNCTIONS.fetch(name).arity) do |i|
        take(',') if i.positive?
        sum
      end
      closed(FUNCTIONS.fetch(name).call(*arguments))
    end

    def closed(result)
      take(')')
      result
    end

    def take(token)
      found = @tokens.shift
      stray(found) unless found == token
    end
  end
end
