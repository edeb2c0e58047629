# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../model'

module Chart
  # What a walk has to decide about the chart.
  class PropertyReader
    KINDS = { 'bs:invariant' => :always, 'bs:response' => :response, 'bs:only' => :only,
              'bs:reachable' => :reachable, 'bs:start' => :start, 'bs:damaged' => :damaged }.freeze

    # Those that speak of steps.
    STEPS = %i[response only].freeze
    # What a response may demand.
    DEMANDS = %w[expr does starts stays].freeze

    attr_reader :all

    # timers, actions: what the chart has of them.
    def initialize(context, chart, alphabet, conditions, timers, actions)
      @context = context
      @alphabet = alphabet
      @timers = timers
      @actions = actions
      @conditions = conditions
      @all = chart.children.select { |element| KINDS.key?(element.name) }.map { |element| read(element) }
    end

    private

    def read(element)
      Property.new(id: id(element), kind: KINDS.fetch(element.name), req: req(element),
                   hazards: @context.claims(element, 'bs:hazard'), events: events(element), from: from(element),
                   expression: expression(element), does: does(element), starts: starts(element),
                   stays: element.attributes.key?('stays'), steps: steps(element), text: text(element),
                   line: element.line)
    end

    # Of a step, inputs too.
    def from(element)
      text = element.attributes['from'] || return
      reader = STEPS.include?(KINDS.fetch(element.name)) ? :guard : :property
      @conditions.public_send(reader, text, element.line)
    end

    def expression(element)
      if (element.attributes.keys & DEMANDS).empty?
        @context.refuse(element.line, 4, "the property demands nothing; add one of: #{DEMANDS.join(', ')}")
      end
      text = element.attributes['expr']
      return [:boolean, true] unless text

      @conditions.public_send(KINDS.fetch(element.name) == :damaged ? :place : :property, text, element.line)
    end

    # nil: whatever they are.
    def does(element)
      element.attributes['does']&.split&.each { |name| check_known(element, name, @actions, 'action') }
    end

    def starts(element)
      element.attributes.fetch('starts', '').split.map do |name|
        check_known(element, name, @timers.all.map(&:id), 'timer')
        @timers.find(name)
      end
    end

    def check_known(element, name, known, what)
      return if known.include?(name)

      @context.refuse(element.line, 7, "\"#{name}\" is no #{what}; #{@context.choice(known)}")
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
      demands = [expression, *effects(element)].compact.join(', ')
      where = from ? " from #{from}" : ''
      count = " in #{steps} step#{'s' unless steps == '1'}" if steps
      case KINDS.fetch(element.name)
      when :always then "always #{expression}"
      when :response then "after #{on}#{where}: #{demands}"
      when :only then "only by #{on}#{where} to #{expression}"
      when :reachable then "#{expression} can be reached#{where}#{count}"
      when :start then "at the start: #{demands}"
      when :damaged then "damaged: #{expression}"
      end
    end

    def effects(element)
      does, starts, stays = element.attributes.values_at('does', 'starts', 'stays')
      [does && "does #{does.empty? ? 'nothing' : does}", starts && "starts #{starts}", stays && 'stays']
    end
  end
end
