# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../../flatten/regions'

module Chart
  module C
    # How the parts of a chart are called in C. Ids of the product are C names already; others are made so.
    class Names
      RESERVED = %w[auto break case char const continue default do double else enum extern float for goto if inline int
                    long register restrict return short signed sizeof static struct switch typedef union unsigned void
                    volatile while self trace now now_us].freeze

      attr_reader :prefix, :macro

      def initialize(document, regions = Regions.new(document))
        @document = document
        @regions = regions
        @prefix = plain(document.name)
        @macro = @prefix.upcase
        @plain = unique(document.states.map(&:id) + document.events + document.timers.map(&:id) +
                        document.variables.map(&:name) + regions.map(&:name))
      end

      # An id as a part of a longer name.
      def stem(id)
        @plain.fetch(id)
      end

      # A transition's id as a part of a longer name.
      def stem_of(id)
        plain(id)
      end

      # The field of a region, of a timer or of a variable.
      def field(name)
        found = stem(name)
        RESERVED.include?(found) ? "#{found}_" : found
      end

      def memory(memory)
        suffix = @regions.memories_of(memory.history).length > 1 ? "_#{field(memory.region.name)}" : ''
        "#{field(memory.history.id)}_memory#{suffix}"
      end

      def chart_type
        "#{prefix}_chart_t"
      end

      def event_type
        "#{prefix}_event_t"
      end

      def inputs_type
        "#{prefix}_inputs_t"
      end

      def region_type(region)
        "#{prefix}_#{field(region.name)}_t"
      end

      def event(name)
        "#{macro}_EVENT_#{stem(name).upcase}"
      end

      def action(name)
        "#{macro}_ACTION_#{plain(name).upcase}"
      end

      def leaf(state)
        value(@regions.of(state), state)
      end

      # The enumerator of a leaf, or of "no leaf" for nil.
      def value(region, leaf)
        "#{macro}_#{stem(region.name).upcase}_#{leaf ? stem(leaf.id).upcase : 'NONE'}"
      end

      # All values of a region's enum, in order.
      def values(region)
        @regions.none?(region) ? region.leaves + [nil] : region.leaves
      end

      def last_value(region)
        value(region, values(region).last)
      end

      def delay(timer)
        "#{macro}_#{field(timer.id).upcase}_DELAY_US"
      end

      # A function of the generated file alone; those of transitions carry the chart in the transition's id.
      def function(name)
        name.start_with?('take_') ? name : "#{prefix}_#{name}"
      end

      def chart_function(name)
        "#{prefix}_chart_#{name}"
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

      def plain(name)
        found = name.downcase.gsub(/[^a-z0-9]+/, '_').gsub(/\A_+|_+\z/, '')
        found.match?(/\A[a-z]/) ? found : "x#{found}"
      end

      # Different ids keep different names.
      def unique(ids)
        ids.uniq.each_with_object({}) do |id, names|
          stem = plain(id)
          number = 1
          number += 1 while names.value?(candidate(stem, number))
          names[id] = candidate(stem, number)
        end
      end

      def candidate(stem, number)
        number == 1 ? stem : "#{stem}_#{number}"
      end
    end
  end
end
