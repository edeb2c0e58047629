# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../model'

module Chart
  # The transitions of all states, in document order, every name resolved.
  class Transitions
    attr_reader :all

    def initialize(context, chart, states, alphabet, contents, conditions)
      @context = context
      @states = states
      @alphabet = alphabet
      @contents = contents
      @conditions = conditions
      @all = []
      sources = find_sources
      chart.all.each { |element| add(element, sources[element]) if sources.key?(element) }
    end

    private

    # Each <transition> that an event or a guard takes, with its state: not those of defaults.
    def find_sources
      @states.by_element.each_with_object({}.compare_by_identity) do |(element, state), found|
        next if state.history?

        element.children.each { |child| found[child] = state if child.name == 'transition' }
      end
    end

    def add(element, source)
      transition = read(element, source)
      source.transitions << transition
      @all << transition
    end

    def read(element, source)
      text = element.attributes['cond']
      Transition.new(id: id(element), number: @all.length + 1, source: source, events: events(element),
                     guard_text: text, guard: text && @conditions.guard(text, element.line),
                     targets: targets(element), internal: element.attributes['type'] == 'internal',
                     content: @contents.read(element), req: req(element),
                     hazards: @context.claims(element, 'bs:hazard'), line: element.line,
                     words: element.attributes.fetch('bs:id', "the transition of line #{element.line}"))
    end

    def id(element)
      id = element.attributes.fetch('bs:id') { return missing_id(element) }
      return id if id.match?(Profile::ID)

      @context.refuse(element.line, 8, "\"#{id}\" is no id; write NAME-Tnn")
    end

    def missing_id(element)
      return "T#{@all.length + 1}" if @context.lenient?

      @context.refuse(element.line, 8, 'the transition has no id; add bs:id="NAME-Tnn"')
    end

    def req(element)
      found = @context.claims(element, 'bs:req')
      return found if found.any? || @context.lenient?

      @context.refuse(element.line, 9, "#{element.attributes['bs:id']} names no requirement; add bs:req=\"SWR-...\"")
    end

    def events(element)
      words = element.attributes.fetch('event') { return [] }.split
      if words.empty? || (words.length > 1 && !@context.lenient?)
        @context.refuse(element.line, 6, "\"#{words.join(' ')}\" is not one event; write one name, or no event=")
      end
      @alphabet.matching(words)
    end

    def targets(element)
      words = element.attributes.fetch('target') { return [] }.split
      @context.refuse(element.line, 7, 'target names no state; write one, or no target=') if words.empty?
      words.map do |id|
        @states.find(id) ||
          @context.refuse(element.line, 7, "target \"#{id}\" is no state; #{@context.choice(@states.ids)}")
      end
    end
  end
end
