# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../model'
require_relative 'alphabet'
require_relative 'conditions'
require_relative 'contents'
require_relative 'context'
require_relative 'data'
require_relative 'defaults'
require_relative 'grammar'
require_relative 'property_reader'
require_relative 'states'
require_relative 'timers'
require_relative 'transitions'
require_relative 'xml_reader'

module Chart
  # Turns a file into a Document: names resolved, ids unique, nothing outside the profile.
  class Parser
    # limits: name => value. mode: :product, :engine for conformance charts, or :difference for versions that are
    # compared. extra_events: events that a scenario sends and the chart may not name.
    def self.parse(file, text, limits, mode: :product, extra_events: [])
      new(Context.new(file, mode, limits), extra_events).parse(XmlReader.read(file, text))
    end

    def initialize(context, extra_events)
      @context = context
      @extra_events = extra_events
    end

    def parse(chart)
      Grammar.new(@context).check(chart)
      @chart = chart
      read_names
      read_behaviour
      document
    end

    private

    # Everything that has a name, before what speaks of it.
    def read_names
      @name = name
      @states = States.new(@context, @chart)
      @data = Data.new(@context, @chart)
      @timers = Timers.new(@context, @chart)
      @alphabet = Alphabet.new(@context, @chart, @states, @extra_events)
      @conditions = Conditions.new(@context, @states, @data)
      named = @states.all + @timers.all
      @context.unique(named.map { |one| [one.id, one.line] } + @data.all.map { |one| [one.name, one.line] }, 5)
    end

    def read_behaviour
      contents = Contents.new(@context, @timers, @data, @conditions)
      @transitions = Transitions.new(@context, @chart, @states, @alphabet, contents, @conditions)
      @defaults = Defaults.new(@context, @states, contents)
      @states.by_element.each do |element, state|
        state.initial = @defaults.of(element, state)
        state.entry = blocks(element, 'onentry', contents)
        state.exit = blocks(element, 'onexit', contents)
      end
      @properties = PropertyReader.new(@context, @chart, @alphabet, @conditions, @timers, actions)
      @context.unique((@transitions.all + @properties.all).map { |one| [one.id, one.line] }, 8)
    end

    def actions
      @chart.all.flat_map { |element| element.attributes.fetch('bs:do', '').split }.uniq
    end

    def blocks(element, name, contents)
      element.children.select { |child| child.name == name }.flat_map { |block| contents.read(block) }
    end

    def document
      Document.new(name: @name, file: @context.file, comment: @chart.comment, root: @states.root,
                   states: @states.all, transitions: @transitions.all, timers: @timers.all, variables: @data.all,
                   properties: @properties.all, safe: safe, events: @alphabet.names,
                   internal_events: @alphabet.internal(declared_internal, @timers.all), entering: entering, tick_us: @timers.tick_us,
                   mode: @context.mode)
    end

    def name
      expected = File.basename(@context.file, '.scxml')
      return expected.downcase.gsub(/[^a-z0-9]+/, '_').gsub(/\A(?=\d)/, 'chart_') if @context.engine?

      found = @context.name(@chart.attributes.fetch('name', expected), @chart.line)
      return found if found == expected || @context.lenient?

      @context.refuse(@chart.line, 6, "the chart is named #{found}; write name=\"#{expected}\"")
    end

    def safe
      ids = @chart.attributes.fetch('bs:safe') { return @defaults.leaves(@states.root) }.split.uniq
      ids.map do |id|
        @states.all.find { |state| state.leaf? && state.id == id } ||
          @context.refuse(@chart.line, 18, "bs:safe names \"#{id}\", which is no leaf; write one leaf of every region")
      end.sort_by(&:order)
    end

    # Of which events the header says from where they enter a state.
    def entering
      outside = @alphabet.names - @alphabet.internal(declared_internal, @timers.all)
      @chart.attributes.fetch('bs:enters', '').split.uniq.each do |word|
        next if outside.include?(word)

        @context.refuse(@chart.line, 7, "bs:enters names \"#{word}\", which is no event from outside; #{@context.choice(outside)}")
      end
    end

    def declared_internal
      raised = @chart.all.select { |element| element.name == 'raise' }.map { |element| element.attributes['event'] }
      @chart.attributes.fetch('bs:internal', '').split.each do |word|
        next if raised.include?(word)

        @context.refuse(@chart.line, 7, "bs:internal names \"#{word}\", which nothing raises; " \
                                        "#{@context.choice(raised)}")
      end
    end
  end
end
