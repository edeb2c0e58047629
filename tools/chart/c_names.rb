# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

module Chart
  # How the parts of a chart are called in C.
  class CNames
    attr_reader :prefix, :macro

    def initialize(document)
      @document = document
      @prefix = document.name
      @macro = document.name.upcase
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

    def raised_type
      "#{prefix}_raised_t"
    end

    def region_type(region)
      "#{prefix}_#{region.name}_t"
    end

    def event(name)
      "#{macro}_EVENT_#{name.upcase}"
    end

    def action(name)
      "#{macro}_ACTION_#{name.upcase}"
    end

    def leaf(state)
      "#{macro}_#{@document.region_of(state).name.upcase}_#{state.id.upcase}"
    end

    def last_leaf(region)
      leaf(region.leaves.last)
    end

    def delay(timer)
      "#{macro}_#{timer.id.upcase}_DELAY_US"
    end

    def function(name)
      "#{prefix}_#{name}"
    end

    def chart_function(name)
      "#{prefix}_chart_#{name}"
    end

    def take(transition)
      "take_#{transition.id.downcase.tr('-', '_')}"
    end

    # The parameters of the public functions that run the chart.
    def public_parameters(last)
      inputs = @document.inputs.empty? ? [] : ["const #{inputs_type} *inputs"]
      ["#{chart_type} *self", *inputs, last].join(', ')
    end
  end
end
