# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../model'

module Chart
  # What a walk has to decide about the chart.
  class PropertyReader
    KINDS = { 'bs:invariant' => :always, 'bs:response' => :response, 'bs:only' => :only,
              'bs:reachable' => :reachable }.freeze

    attr_reader :all

    def initialize(context, chart, alphabet, conditions)
      @context = context
      @alphabet = alphabet
      @conditions = conditions
      @all = chart.children.select { |element| KINDS.key?(element.name) }.map { |element| read(element) }
    end

    private

    def read(element)
      from = element.attributes['from']
      Property.new(id: id(element), kind: KINDS.fetch(element.name), req: req(element),
                   hazards: @context.claims(element, 'bs:hazard'), events: events(element),
                   from: from && @conditions.property(from, element.line),
                   expression: @conditions.property(element.attributes['expr'], element.line),
                   steps: steps(element), text: text(element), line: element.line)
    end

    def id(element)
      id = element.attributes.fetch('id') do
        @context.refuse(element.line, 8, 'the property has no id; add id="NAME-Inn"')
      end
      return id if id.match?(Profile::ID)

      @context.refuse(element.line, 8, "\"#{id}\" is no id; write NAME-Inn")
    end

    def req(element)
      found = @context.claims(element, 'bs:req')
      return found if found.any? || @context.lenient?

      @context.refuse(element.line, 9, "#{element.attributes['id']} names no requirement; add bs:req=\"SWR-...\"")
    end

    def events(element)
      element.attributes.fetch('on', '').split.each do |name|
        next if @alphabet.include?(name)

        @context.refuse(element.line, 7, "\"#{name}\" is no event; #{@context.choice(@alphabet.names)}")
      end
    end

    def steps(element)
      text = element.attributes['steps'] || return
      return text.to_i if text.match?(/\A[1-9]\d*\z/)

      @context.refuse(element.line, 3, "steps=\"#{text}\" is no number; write steps=\"1\" or more")
    end

    def text(element)
      from, expression, on, steps = element.attributes.values_at('from', 'expr', 'on', 'steps')
      where = from ? " from #{from}" : ''
      count = " in #{steps} step#{'s' unless steps == '1'}" if steps
      case KINDS.fetch(element.name)
      when :always then "always #{expression}"
      when :response then "after #{on}#{where}: #{expression}"
      when :only then "only by #{on}#{where} to #{expression}"
      when :reachable then "#{expression} can be reached#{where}#{count}"
      end
    end
  end
end
