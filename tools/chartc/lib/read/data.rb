# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../model'

module Chart
  # The declared data: inputs of a product chart; also own booleans and integers of a conformance chart.
  class Data
    INTEGERS = (-32_768..32_767).freeze
    INTEGER = /\A-?(?:0|[1-9]\d*)\z/.freeze

    attr_reader :all

    def initialize(context, chart)
      @context = context
      @all = chart.all.select { |element| element.name == 'data' }.map { |element| read(element) }
    end

    def find(name)
      @all.find { |variable| variable.name == name }
    end

    def names
      @all.map(&:name)
    end

    private

    def read(element)
      name = @context.name(element.attributes['id'], element.line)
      variable = Variable.new(name: name, kind: kind(element), comment: element.comment, line: element.line)
      variable.initial = first_value(element, variable.kind)
      bound(element, variable) if variable.kind == :integer
      variable
    end

    def first_value(element, kind)
      text = element.attributes['expr']
      kind == :integer ? text.to_i : text == 'true'
    end

    def kind(element)
      value = element.attributes['expr']
      return read_input(element, value) if !@context.engine? || element.attributes['bs:input']
      return :boolean if %w[true false].include?(value)
      return :integer if value.match?(INTEGER)

      @context.refuse(element.line, 14, "\"#{value}\" is no value here; write true, false or a whole number")
    end

    def read_input(element, value)
      return :input if value == 'false'

      @context.refuse(element.line, 14, 'an input is a boolean that the caller hands in; write expr="false"')
    end

    def bound(element, variable)
      variable.minimum = limit(element, 'bs:min', INTEGERS.min)
      variable.maximum = limit(element, 'bs:max', INTEGERS.max)
      return if variable.initial.between?(variable.minimum, variable.maximum)

      @context.refuse(element.line, 34, "#{variable.name} begins with #{variable.initial}; " \
                                        "write #{variable.minimum} to #{variable.maximum}, or other bounds")
    end

    def limit(element, attribute, default)
      text = element.attributes.fetch(attribute, default.to_s)
      return text.to_i if text.match?(INTEGER) && INTEGERS.cover?(text.to_i)

      @context.refuse(element.line, 14, "#{attribute}=\"#{text}\" is no bound; " \
                                        "write #{INTEGERS.min} to #{INTEGERS.max}")
    end
  end
end
