# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../model'
require_relative 'promela/content'
require_relative 'promela/entering'
require_relative 'promela/environment'
require_relative 'promela/leaving'
require_relative 'promela/names'
require_relative 'promela/properties'
require_relative 'promela/selection'
require_relative 'promela/steps'
require_relative 'promela/text'
require_relative 'promela/tree'
require_relative 'promela/vector'

module Chart
  # A chart as a Promela model: a second reading of SCXML for the model checker SPIN, made from the parsed chart only.
  # Between two steps the model keeps one bit per state, history memories, the chart's data and which timers run; a
  # step is one macrostep for one event, or for timers that expire together, and is one transition of the model.
  # With PRINTF defined for the compiler of the verifier every step prints its line (see Steps).
  class Promela
    # Events that one step may raise; more is an error of the chart.
    QUEUE = 1000

    def initialize(document)
      @document = document
      @names = Names.new(document)
      @tree = Tree.new(document)
      @vector = Vector.new(document, @names, @tree)
      @content = Content.new(document, @names)
      @leaving = Leaving.new(document, @names, @tree, @content)
      @entering = Entering.new(document, @names, @tree, @content)
      @steps = Steps.new(document, @names, @vector)
      @properties = Properties.new(document, @names, @steps)
      @environment = Environment.new(document, @names, @steps, @properties)
    end

    def emit
      [head, constants, state, scratch, selection, step, @environment.text].join("\n")
    end

    private

    def head
      "/* SPDX-License-Identifier: Apache-2.0 */\n" \
        "/* Generated from #{@document.name}. Of several guards that hold a d_step takes the first. */\n"
    end

    def constants
      stimuli = ['NOTHING', *@document.events.map { |event| @names.event(event) }, 'START', 'EXPIRY']
      "/* Stimuli, the transition that starts the chart, and what becomes of a transition in a microstep. */\n" \
        "#{define(stimuli)}#define INITIAL #{initial}\n#{define(%w[UNASKED TAKEN DROPPED])}"
    end

    def define(names)
      names.each_with_index.map { |name, number| "#define #{name} #{number}\n" }.join
    end

    # Transitions are numbered from 1.
    def initial
      @document.transitions.length + 1
    end

    def state
      fields = @vector.fields.map { |field| "#{field.type} #{field.name} = #{field.initial}".delete_suffix(' = 0') }
      "/* What stays between two steps. */\n#{lines(["bit #{@names.active(@document.root)}", *fields])}\n" \
        "/* What the environment chose, and how far the step is: 0 between two steps. */\n" \
        "#{lines(@environment.variables)}"
    end

    def scratch
      marks = [@leaving, @entering, @properties].flat_map(&:marks_used)
      lists = ["short queue[#{QUEUE}]", "short chosen[#{initial + 1}]", "byte fate[#{initial + 1}]",
               "int actions[#{@steps.gathered('actions', @document.actions).length}]",
               "int started[#{@steps.gathered('started', @document.timers).length}]"]
      counters = %w[event next one place first last fresh moves value].map { |name| "int #{name}" }
      all = marks.map { |mark| "byte #{mark}" } + lists + counters
      "/* Used inside a step only. */\n#{lines(all.map { |one| "hidden #{one}" })}"
    end

    def lines(declarations)
      declarations.map { |declaration| "#{declaration};\n" }.join
    end

    def selection
      add = ['chosen[asked] = next', 'asked++', 'fate[next] = TAKEN']
      drop = Text.choose([['fate[number] == TAKEN', ['fate[number] = DROPPED']]])
      [Text.inline('add()', 'The transition `next` is chosen.', add),
       Text.inline('drop(number)', 'A rival has won.', [drop]),
       Text.inline('put(number)', 'Raise an event.', ["assert(last < #{QUEUE})", 'queue[last] = number', 'last++']),
       Selection.new(@document, @names, @tree).inline(@properties.heard)].join("\n")
    end

    def step
      [@leaving.inline, *@entering.inlines,
       Text.inline('end_microstep()', 'Eventless transitions come next.', end_microstep),
       Text.inline('next_event()', 'Raised events in their order, then timers that expire.', [next_event])].join("\n")
    end

    def end_microstep
      [*@properties.noted, 'event = NOTHING', Text.each_place('asked', ['fate[chosen[place]] = UNASKED'])]
    end

    def next_event
      expiries = @document.timers.map do |timer|
        [@names.expiring(timer), ["#{@names.expiring(timer)} = 0", "#{@names.armed(timer)} = 0",
                                  "event = #{@names.event(timer.event)}"]]
      end
      Text.choose([['first < last', ['event = queue[first]', 'first++']], *expiries], ['settled = 1'])
    end
  end
end
