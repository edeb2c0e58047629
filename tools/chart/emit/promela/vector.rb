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
        active = snapshot.leaves.flat_map { |id| [id, *@document.state(id).ancestors.map(&:id)] }
        values = @fields.to_h { |field| [field, value(field.key, snapshot, active)] }
        numbers = words.map { |word| word.each_with_index.sum { |field, bit| values.fetch(field) << bit }.to_s(16) }
        (numbers + integers.map { |field| values.fetch(field).to_s }).join(' ')
      end

      # The names of the bits that are set, and the integers: what a person reads in a difference.
      def describe(text)
        parts = text.split
        set = words.zip(parts).flat_map { |word, part| word.select.with_index { |_, bit| part.hex[bit] == 1 } }
        (set.map(&:name) + integers.zip(parts.drop(words.length)).map { |field, part| "#{field.name}=#{part}" }).join(' ')
      end

      def self.packed(terms)
        return '0' if terms.empty?

        terms.each_with_index.map { |term, bit| bit.zero? ? term : "#{term} << #{bit}" }.join(' | ')
      end

      private

      def bits
        @fields.select { |field| field.type == 'bit' }
      end

      def integers
        @fields - bits
      end

      def words
        bits.each_slice(WORD_BITS).to_a
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
          boolean = variable.kind == :boolean
          initial = boolean ? number(variable.initial) : variable.initial
          Field.new(@names.data(variable), boolean ? 'bit' : width(variable), initial, [:data, variable.name])
        end
      end

      def width(variable)
        return 'byte' if variable.minimum >= 0 && variable.maximum <= 255

        variable.minimum >= -32_768 && variable.maximum <= 32_767 ? 'short' : 'int'
      end

      def value(key, snapshot, active)
        kind, id, inner = key
        case kind
        when :state then number(active.include?(id))
        when :memory then number(snapshot.history.fetch(id, []).include?(inner))
        when :armed then number(snapshot.armed.include?(id))
        when :data then number(snapshot.data.fetch(id))
        end
      end

      def number(value)
        { true => 1, false => 0 }.fetch(value, value)
      end
    end
  end
end
