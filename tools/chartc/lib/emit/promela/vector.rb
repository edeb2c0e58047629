# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'names'
require_relative 'tree'

module Chart
  class Promela
    # What the model keeps between two steps, in fields and as one text: bits in hexadecimal words, then integers.
    class Vector
      # key: [:state, id], [:memory, history id, state id], [:armed, timer id] or [:data, name].
      Field = Struct.new(:name, :type, :initial, :key)
      # printf takes an int.
      WORD_BITS = 28

      attr_reader :fields

      def initialize(document, names = Names.new(document), tree = Tree.new(document))
        @document = document
        @names = names
        @tree = tree
        @fields = states + memories + timers + data
        @texts = {}
      end

      # Conversions of printf and their arguments.
      def format
        (['%x'] * words.length + ['%d'] * integers.length).join(' ')
      end

      def arguments
        words.map { |word| Vector.packed(word.map(&:name)) } + integers.map(&:name)
      end

      # The text that the model prints for a snapshot of the walk.
      def text(snapshot)
        @texts[snapshot] ||= begin
          set = set_bits(snapshot)
          numbers = words.each_index.map { |word| (set >> (word * WORD_BITS) & ((1 << WORD_BITS) - 1)).to_s(16) }
          (numbers + integers.map { |field| snapshot.data.fetch(field.key.last) }).join(' ')
        end
      end

      # The names of the bits that are set, and the integers: what a person reads in a difference.
      def describe(text)
        parts = text.split
        set = words.zip(parts).flat_map { |word, part| word.select.with_index { |_, bit| part.hex[bit] == 1 } }
        numbers = integers.zip(parts.drop(words.length)).map { |field, part| "#{field.name}=#{part}" }
        (set.map(&:name) + numbers).join(' ')
      end

      def self.packed(terms)
        return '0' if terms.empty?

        terms.each_with_index.map { |term, bit| bit.zero? ? term : "#{term} << #{bit}" }.join(' | ')
      end

      private

      def bits
        @bits ||= @fields.select { |field| field.type == 'bit' }
      end

      def integers
        @integers ||= @fields - bits
      end

      def words
        @words ||= bits.each_slice(WORD_BITS).to_a
      end

      def set_bits(snapshot)
        keys = snapshot.history.flat_map { |history, states| states.map { |state| [:memory, history, state] } }
        keys += snapshot.armed.map { |timer| [:armed, timer] }
        keys += snapshot.data.filter_map { |name, value| [:data, name] if value == true }
        (snapshot.leaves.map { |leaf| active.fetch(leaf) } + keys.map { |key| places.fetch(key) }).reduce(0, :|)
      end

      # key of a bit => its place, as a number with that bit
      def places
        @places ||= bits.each_with_index.to_h { |field, bit| [field.key, 1 << bit] }
      end

      # id of a leaf => its bit with those of its ancestors
      def active
        @active ||= @document.leaves.to_h do |leaf|
          [leaf.id, @tree.path(leaf, @document.root).sum { |state| places.fetch([:state, state.id]) }]
        end
      end

      def states
        (@tree.states - [@document.root]).map do |state|
          Field.new(@names.active(state), 'bit', 0, [:state, state.id])
        end
      end

      def memories
        @document.histories.flat_map do |history|
          @tree.remembered(history).map do |state|
            Field.new(@names.memory(history, state), 'bit', 0, [:memory, history.id, state.id])
          end
        end
      end

      def timers
        @document.timers.map { |timer| Field.new(@names.armed(timer), 'bit', 0, [:armed, timer.id]) }
      end

      def data
        @document.data.map do |variable|
          initial = { true => 1, false => 0 }.fetch(variable.initial, variable.initial)
          Field.new(@names.data(variable), width(variable), initial, [:data, variable.name])
        end
      end

      def width(variable)
        return 'bit' if variable.kind == :boolean
        return 'byte' if variable.minimum >= 0 && variable.maximum <= 255

        variable.minimum >= -32_768 && variable.maximum <= 32_767 ? 'short' : 'int'
      end
    end
  end
end
