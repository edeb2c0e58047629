# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'layout'
require_relative 'names'

module Chart
  module C
    # The file-local functions of a chart. Five names are kept for parameters: a function has those that are free in its
    # body, and no statement of this folder gives one of them to anything else.
    class Code
      include Layout

      PARAMETERS = %w[self before inputs event run].freeze
      # Comments and members (->event, .event) are passed over; what is left and caught is an identifier.
      IDENTIFIER = %r{/\*.*?\*/|(?:->|\.)\w+|([A-Za-z_]\w*)}m

      def initialize(names)
        @names = names
        @parameters = {}
        @functions = []
      end

      # Adds `static type name(...)`; body is a list of lines without the outer indent. constant: self is only read.
      # also: further parameters.
      def define(type, name, body, comment: [], constant: false, also: [])
        lines = body.flatten
        @parameters[name] = PARAMETERS & lines.join("\n").scan(IDENTIFIER).flatten
        declared = declare(@parameters[name], constant) + also
        head = "static #{type} #{@names.function(name)}"
        add(name, [comment, call(head, declared.empty? ? ['void'] : declared, ''), '{',
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
