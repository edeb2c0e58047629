# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'layout'
require_relative 'names'

module Chart
  module C
    # The file-local functions of a chart. A function has the parameters that its body speaks of.
    class Code
      include Layout

      PARAMETERS = %w[self before inputs event run].freeze

      def initialize(names)
        @names = names
        @parameters = {}
        @functions = []
      end

      # Adds `static type name(...)`; body is a list of lines without the outer indent. constant: self is only read.
      # also: further parameters.
      def define(type, name, body, comment: [], constant: false, also: [])
        lines = body.flatten
        words = lines.join("\n").gsub(%r{/\*.*?\*/}m, '')
        @parameters[name] = PARAMETERS.select { |one| words.match?(/(?<![>.])\b#{one}\b/) }
        head = "static #{type} #{@names.function(name)}"
        add(name, [comment, call(head, declare(@parameters[name], constant) + also, ''), '{',
                   lines.map { |line| line.empty? ? line : "    #{line}" }, '}', ''])
      end

      # Adds a function as it is.
      def add(name, lines)
        @functions << [@names.function(name), lines.flatten]
      end

      # A call of a defined function; replace says which argument stands for a parameter, further ones follow.
      def invoke(name, replace = {}, *further)
        arguments = @parameters.fetch(name).map { |one| replace.fetch(one, one) } + further
        "#{@names.function(name)}(#{arguments.join(', ')})"
      end

      def defined?(name)
        @parameters.key?(name)
      end

      def needs?(name, parameter)
        @parameters.fetch(name).include?(parameter)
      end

      # The functions that the text after them, or the text given, calls.
      def lines(text)
        used = text.flatten.join("\n")
        @functions.reverse.each_with_object([]) do |(name, lines), kept|
          next unless used.match?(/\b#{name}\(/)

          used = lines.join("\n") + used
          kept.unshift(lines)
        end
      end

      private

      def declare(parameters, constant)
        types = { 'self' => "#{'const ' if constant}#{@names.chart_type} *self",
                  'before' => "const #{@names.function('before_t')} *before",
                  'inputs' => "const #{@names.inputs_type} *inputs", 'event' => "#{@names.event_type} event",
                  'run' => "#{@names.function('run_t')} *run" }
        parameters.map { |parameter| types.fetch(parameter) }
      end
    end
  end
end
