# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../walk/interpreter'
require_relative 'c/names'

module Chart
  # A snapshot as the numbers that the compiled chart stores: regions, history memories, own data, armed flags.
  class Vector
    Field = Struct.new(:name, :kind, :type, :part)

    attr_reader :fields

    def initialize(document)
      @document = document
      @regions = Regions.new(document)
      @names = C::Names.new(document, @regions)
      @fields = region_fields + memory_fields + data_fields + timer_fields
    end

    def names
      fields.map(&:name)
    end

    def encode(snapshot)
      active = snapshot.leaves.map { |id| @document.state(id) }
      fields.map do |field|
        case field.kind
        when :region then number(field.part, leaf_of(field.part, active))
        when :memory then number(field.part.region, remembered(field.part, snapshot.history))
        when :data then to_integer(snapshot.data.fetch(field.part.name))
        else snapshot.armed.include?(field.part.id) ? 1 : 0
        end
      end
    end

    def decode(numbers)
      pairs = fields.zip(numbers)
      Snapshot.new(leaves(pairs).freeze, history(pairs).freeze, data(pairs).freeze, armed(pairs).freeze).freeze
    end

    private

    def region_fields
      @regions.map { |region| Field.new(@names.field(region.name), :region, @names.region_type(region), region) }
    end

    def memory_fields
      @regions.memories.map do |memory|
        Field.new(@names.memory(memory), :memory, @names.region_type(memory.region), memory)
      end
    end

    def data_fields
      @document.data.map { |one| Field.new(@names.field(one.name), :data, @names.variable_type(one), one) }
    end

    def timer_fields
      @document.timers.map { |timer| Field.new(@names.armed(timer), :timer, 'uint32_t', timer) }
    end

    def number(region, leaf)
      @names.values(region).index(leaf)
    end

    def leaf_of(region, active)
      region.leaves.find { |leaf| active.any? { |state| state == leaf || state.inside?(leaf) } }
    end

    def remembered(memory, history)
      ids = history[memory.history.id]
      return nil unless ids

      states = ids.map { |id| @document.state(id) }
      memory.region.leaves.find { |leaf| states.any? { |state| related?(leaf, state, memory.history) } }
    end

    # A shallow history records children: any leaf in one stands for it.
    def related?(leaf, state, history)
      leaf == state || (history.depth == :shallow ? leaf.inside?(state) : state.inside?(leaf))
    end

    def to_integer(value)
      case value
      when true then 1
      when false then 0
      else value
      end
    end

    def values(pairs, kind)
      pairs.select { |field, _number| field.kind == kind }
    end

    def leaves(pairs)
      active = values(pairs, :region).filter_map { |field, number| @names.values(field.part)[number] }
      active.select(&:leaf?).sort_by(&:order).map(&:id)
    end

    def history(pairs)
      memories = values(pairs, :memory).group_by { |field, _number| field.part.history }
      memories.each_with_object({}) do |(history, found), all|
        leaves = found.filter_map { |field, number| @names.values(field.part.region)[number] }
        all[history.id] = recorded(history, leaves) if leaves.any?
      end
    end

    def recorded(history, leaves)
      states = history.depth == :deep ? leaves.select(&:leaf?) : leaves.map { |leaf| child(history.parent, leaf) }
      states.sort_by(&:order).map(&:id).freeze
    end

    def child(parent, leaf)
      [leaf, *leaf.ancestors].find { |state| state.parent == parent }
    end

    def data(pairs)
      values(pairs, :data).to_h do |field, number|
        [field.part.name, field.part.kind == :boolean ? number == 1 : number]
      end
    end

    def armed(pairs)
      values(pairs, :timer).select { |_field, number| number == 1 }.map { |field, _number| field.part.id }
    end
  end
end
