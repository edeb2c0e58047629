# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../../flatten/regions'

module Chart
  module C
    # The names of one place in C. Each thing has one; where another has it already, a number makes it different.
    class Scope
      def initialize(taken)
        @taken = taken
        @names = {}
        @given = {}
      end

      # The name of a thing, the first time made from what is wanted.
      def name(thing, wanted)
        @names[thing] ||= free(wanted).tap { |found| @given[found] = true }
      end

      def all
        @given.keys
      end

      private

      def free(wanted)
        return wanted if free?(wanted)

        number = (2..).find { |one| free?("#{wanted}_#{one}") }
        "#{wanted}_#{number}"
      end

      def free?(name)
        !@given.key?(name) && !@taken.match?(name)
      end
    end

    # How the parts of a chart are called in C: every name of the generated code comes from here, so that no two of one
    # place are the same, whatever the chart calls its parts. Ids of the product are C names already; others are made so.
    # @satisfies SWR-CHART-016
    class Names
      # Words of C, later C and the dialects of compilers, macros of its headers that are plain words, and names that the
      # code gives to other things.
      MEMBERS = /\A(?:auto|break|case|char|const|continue|default|do|double|else|enum|extern|float|for|goto|if|inline|int|
                 long|register|restrict|return|short|signed|sizeof|static|struct|switch|typedef|union|unsigned|void|
                 volatile|while|bool|true|false|self|trace|now|now_us|
                 alignas|alignof|asm|constexpr|fortran|noreturn|nullptr|static_assert|thread_local|typeof|typeof_unqual|
                 and|and_eq|bitand|bitor|compl|not|not_eq|or|or_eq|xor|xor_eq|complex|imaginary|errno|stdin|stdout|stderr|
                 linux|unix|i386|sun|sparc|mips|vax|hpux|near|far|cdecl|pascal)\z/x.freeze
      FILE = /\A(?:chart_(?:step_t|trace_t|trace_add|queue_slot|require_settled)|CHART_TRACE_LENGTH|contract_broken|
              u?int(?:_fast|_least)?\d+_t|u?int(?:max|ptr)_t|(?:U?INT|SIG_ATOMIC)\w*_(?:MAX|MIN|C))\z/x.freeze

      attr_reader :prefix, :regions

      def initialize(document, regions = Regions.new(document))
        @document = document
        @regions = regions
        @prefix = plain(document.name)
        @macro = @prefix.upcase
        @stems = Scope.new(/\A(?!)/)
        (document.states.map(&:id) + document.events + document.timers.map(&:id) + document.variables.map(&:name) +
         regions.map(&:name)).uniq.each { |id| stem(id) }
        claim_members
        claim_public
      end

      # An id as a part of a longer name.
      def stem(id)
        @stems.name(id, plain(id))
      end

      # A transition's id as a part of a longer name.
      def stem_of(id)
        plain(id)
      end

      # The field of a region or of a variable.
      def field(name)
        @members.name(name, stem(name))
      end

      # The second copy of a region.
      def inverse(region)
        @members.name([:inverse, region.name], "#{field(region.name)}_inverse")
      end

      def memory(memory)
        suffix = @regions.memories_of(memory.history).length > 1 ? "_#{field(memory.region.name)}" : ''
        @members.name([:memory, memory.history.id, memory.region.name], "#{stem(memory.history.id)}_memory#{suffix}")
      end

      # How long a timer has run, and whether it does.
      def time(timer)
        @members.name([:time, timer.id], "#{stem(timer.id)}_us")
      end

      def armed(timer)
        @members.name([:armed, timer.id], "#{stem(timer.id)}_is_armed")
      end

      def chart_type
        public_name(:chart_type, 'chart_t')
      end

      def bytes
        public_macro(:bytes, 'chart_bytes')
      end

      def event_type
        public_name(:event_type, 'event_t')
      end

      def inputs_type
        public_name(:inputs_type, 'inputs_t')
      end

      def region_type(region)
        public_name([:type, region.name], "#{field(region.name)}_t")
      end

      def header_guard
        "BORESIGHT_#{@macro}_CHART_H"
      end

      def event(name)
        public_macro([:event, name], "EVENT_#{stem(name)}")
      end

      def no_event
        public_macro(:no_event, 'EVENT_NONE')
      end

      def action(name)
        public_macro([:action, name], "ACTION_#{plain(name)}")
      end

      def leaf(state)
        value(@regions.of(state), state)
      end

      # The enumerator of a leaf, or of "no leaf" for nil.
      def value(region, leaf)
        public_macro([:value, region.name, leaf&.id], "#{stem(region.name)}_#{leaf ? stem(leaf.id) : 'none'}")
      end

      # All values of a region's enum, in order.
      def values(region)
        @regions.none?(region) ? region.leaves + [nil] : region.leaves
      end

      # Those that it has between two steps: one that is always active is never "none", which a history may say of it.
      # @satisfies SWR-CHART-039
      def resting_values(region)
        @regions.always_active?(region) ? region.leaves : values(region)
      end

      def last_value(region)
        value(region, resting_values(region).last)
      end

      def delay(timer)
        public_macro([:delay, timer.id], "#{stem(timer.id)}_DELAY_US")
      end

      # The length of the queue of raised events.
      def raised_max
        public_macro(:raised_max, 'RAISED_MAX')
      end

      # A function or type of the generated file alone. The parts of its name stand between dots, which no id keeps, so
      # that different parts are different things. Those of transitions carry the chart in the transition's id.
      def function(parts)
        name = parts.split('.').map { |part| plain(part) }.join('_')
        @file.name([:function, parts], parts.start_with?('take.') ? name : "#{@prefix}_#{name}")
      end

      # A variable inside a function: none hides a function.
      def local(verb, region)
        @file.name([:local, verb, region.name], "#{verb}_in_#{field(region.name)}")
      end

      def chart_function(name)
        public_name([:public, name], "chart_#{name}")
      end

      # True while the chart is in the state.
      def in_function(state)
        public_name([:in, state.id], "chart_in_#{stem(state.id)}")
      end

      # True where the event enters a state.
      def enters_function(event)
        public_name([:enters, event], "chart_enters_by_#{stem(event)}")
      end

      # What whoever includes the header sees.
      def of_header
        @public
      end

      def variable_type(variable)
        variable.kind == :integer ? 'int32_t' : 'bool'
      end

      # The parameters of the public functions that run the chart.
      def public_parameters(last)
        inputs = @document.inputs.empty? ? [] : ["const #{inputs_type} *inputs"]
        ["#{chart_type} *self", *inputs, last].join(', ')
      end

      # A chart without timers reads nothing when time passes.
      def advance_parameters
        @document.timers.empty? ? "#{chart_type} *self, uint32_t elapsed_us" : public_parameters('uint32_t elapsed_us')
      end

      private

      # The chart's own words come first, then what is made of them.
      def claim_members
        @members = Scope.new(MEMBERS)
        (@regions.map(&:name) + @document.variables.map(&:name)).each { |name| field(name) }
        @regions.each { |region| inverse(region) }
        @regions.memories.each { |memory| memory(memory) }
        @document.timers.each { |timer| [time(timer), armed(timer)] }
      end

      def claim_public
        @file = Scope.new(FILE)
        [chart_type, bytes, event_type, inputs_type]
        %w[init dispatch advance is_sound check].each { |name| chart_function(name) }
        @regions.each { |region| [region_type(region), values(region).each { |leaf| value(region, leaf) }] }
        @document.events.each { |name| event(name) }
        @document.actions.each { |name| action(name) }
        @document.states.each { |state| in_function(state) }
        @document.entering.each { |event| enters_function(event) }
        @public = @file.all
      end

      def public_name(thing, rest)
        @file.name(thing, "#{@prefix}_#{rest}")
      end

      def public_macro(thing, rest)
        @file.name(thing, "#{@macro}_#{rest.upcase}")
      end

      def plain(name)
        (@plain ||= {})[name] ||= made_plain(name)
      end

      def made_plain(name)
        found = name.downcase.gsub(/[^a-z0-9]+/, '_').gsub(/\A_+|_+\z/, '')
        found.match?(/\A[a-z]/) ? found : "x#{found}"
      end
    end
  end
end
