# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

module Chart
  # What the generated tests of a chart have in common. Expects @document and @names, and @proves for test_name.
  module TestShared
    private

    # With the requirement that the project proves by tests of this kind, if it has one.
    def test_name(kind, words)
      ['test', @proves[kind]&.tr('-', '_'), @document.name, words].compact.join('_')
    end

    def timers?
      @document.timers.any?
    end

    def inputs?
      @document.inputs.any?
    end

    def inputs_function
      return [] unless inputs?

      rows = @document.inputs.each_with_index.map do |input, bit|
        "    inputs.#{@names.field(input.name)} = ((bits >> #{bit}U) & 1U) != 0U;"
      end
      ["static #{@names.inputs_type} inputs_from(uint32_t bits)", '{', "    #{@names.inputs_type} inputs;", '', rows,
       '    return inputs;', '}', '']
    end

    def timer_functions
      return [] unless timers?

      bits = @document.timers.each_with_index.map do |timer, bit|
        "((chart->#{@names.armed(timer)} != 0U) ? #{1 << bit}U : 0U)"
      end
      ["static uint32_t armed_of(const #{@names.chart_type} *chart)", '{',
       "    return #{bits.join(" |\n           ")};", '}', '']
    end

    def timer_mask(ids)
      @document.timers.each_with_index.sum { |timer, bit| ids.include?(timer.id) ? 1 << bit : 0 }
    end

    def actions_cell(actions)
      actions.empty? ? '0U' : actions.map { |action| @names.action(action) }.join(' | ')
    end
  end
end
