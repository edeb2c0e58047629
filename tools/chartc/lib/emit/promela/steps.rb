# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'text'
require_relative 'vector'

module Chart
  class Promela
    # The line of one step, as the model prints it and as the walk would:
    #   STEP before;stimulus;expiring;inputs; 1 2; 3;after;actions;started
    # stimulus is the number of an event, of START or of EXPIRY; expiring, actions and started are bits in words;
    # 1 2 are the numbers of the taken transitions in their order, 3 is the number of a raised event.
    class Steps
      PREFIX = 'STEP '
      OUTCOME = %i[taken raised after actions started].freeze

      def initialize(document, names = Names.new(document), vector = Vector.new(document, names))
        @document = document
        @names = names
        @vector = vector
        @timers = document.timers.map(&:id)
        @actions = document.actions
        @timer_bits = Hash.new { |known, set| known[set] = bits(@timers, set) }
        @action_bits = Hash.new { |known, set| known[set] = bits(@actions, set) }
      end

      def print_before
        expiring = slices(@document.timers).map do |timers|
          Vector.packed(timers.map { |timer| @names.expiring(timer) })
        end
        form = [@vector.format, '%d', hex(expiring), '%d'].join(';')
        "printf(\"#{PREFIX}#{form};\", #{[*@vector.arguments, 'stimulus', *expiring, 'inputs'].join(', ')})"
      end

      def print_after
        actions = gathered('actions', @actions)
        started = gathered('started', @timers)
        form = [@vector.format, hex(actions), hex(started)].join(';')
        ['printf(";")', Text.each_place('last', ['printf(" %d", queue[place])']),
         "printf(\";#{form}\\n\", #{[*@vector.arguments, *actions, *started].join(', ')})"]
      end

      # The words in which actions and started timers are gathered.
      def gathered(name, list)
        Array.new(slices(list).length) { |word| "#{name}[#{word}]" }
      end

      # Whether one of the list is among those gathered.
      def holds(name, list, one)
        word, bit = list.index(one).divmod(Vector::WORD_BITS)
        "#{name}[#{word}] >> #{bit} & 1"
      end

      # The part of the line that states a stimulus of the walk; :start is that before all.
      def stimulus(stimulus)
        kind, what = stimulus
        last = @document.events.length
        case kind
        when :event then "#{@document.events.index(what) + 1};#{@timer_bits[[]]}"
        when :start then "#{last + 1};#{@timer_bits[[]]}"
        when :expire then "#{last + 2};#{@timer_bits[what]}"
        end
      end

      # The part of the line that states an outcome of the walk.
      def outcome(outcome)
        taken = outcome.taken.map { |transition| " #{transition.number}" }.join
        raised = outcome.raised.map { |event| " #{@document.events.index(event) + 1}" }.join
        [taken, raised, @vector.text(outcome.after), @action_bits[outcome.actions],
         @timer_bits[outcome.started]].join(';')
      end

      # The vector in that part.
      def after(text)
        text.split(';', 4)[2]
      end

      # What that part says, in names.
      def read_outcome(text)
        taken, raised, after, actions, started = text.split(';', -1)
        OUTCOME.zip([taken.split.map { |number| @document.transitions[number.to_i - 1].id },
                     raised.split.map { |number| @document.events[number.to_i - 1] }, @vector.describe(after),
                     names(@actions, actions), names(@timers, started)]).to_h
      end

      # What the environment did, in words.
      def read_stimulus(stimulus, expiring, inputs)
        timers = names(@timers, expiring)
        start = timers.empty? ? 'start' : "#{timers.join(' and ')} expired"
        what = @document.events.fetch(stimulus.to_i - 1, start)
        set = @document.inputs.select.with_index { |_, bit| inputs.to_i[bit] == 1 }.map(&:name)
        set.empty? ? what : "#{what} with #{set.join(' and ')}"
      end

      private

      def slices(list)
        list.empty? ? [[]] : list.each_slice(Vector::WORD_BITS).to_a
      end

      def hex(words)
        (['%x'] * words.length).join(' ')
      end

      def bits(all, set)
        slices(all).map do |slice|
          slice.each_with_index.sum { |id, bit| set.include?(id) ? 1 << bit : 0 }.to_s(16)
        end.join(' ')
      end

      def names(all, text)
        slices(all).zip(text.split).flat_map { |slice, word| slice.select.with_index { |_, bit| word.hex[bit] == 1 } }
      end
    end
  end
end
