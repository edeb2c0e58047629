# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

module WorstCase
  # The calls that a product makes of a chart, as the C of a program: each reachable pair with each valuation of the
  # inputs, then the check in each configuration. The first call stands in line 1 of "calls", the next in line 2.
  class Calls
    # witness: in words. place: number of the chart's state before it. actions, taken: what the walk says of it.
    Call = Struct.new(:witness, :place, :code, :actions, :taken)

    attr_reader :pairs, :checks

    def initialize(chart)
      @document = chart.document
      @walk = chart.walk
      @names = chart.names
      @vector = chart.vector
      @bits = @document.actions.each_with_index.to_h { |action, bit| [action, 1 << bit] }
      @places = {}
      @pairs = @walk.reachable_pairs.flat_map { |pair| calls_of(pair) }
      @checks = @walk.reached.keys.map { |before| Call.new(words(before), place(before), call('check', []), 0, 0) }
    end

    def all
      pairs + checks
    end

    # Called functions; a chart without timers advances in the header.
    def functions
      verbs = @document.timers.any? ? %w[dispatch advance check] : %w[dispatch check]
      verbs.map { |verb| @names.chart_function(verb) }
    end

    def emit
      [head, table(@names.chart_type, 'places', @places.keys), inputs, contract, helpers,
       'int main(void)', '{', '#line 1 "calls"', *all.map { |call| line(call) }, '    return 0;', '}', ''].join("\n")
    end

    private

    def calls_of(pair)
      place = place(pair.before, pair.stimulus)
      pair.outcomes.each_with_index.map do |outcome, index|
        words = "#{@walk.words([[pair.stimulus, @walk.valuations[index]]])} in #{words(pair.before)}"
        actions = outcome.actions.sum { |action| @bits.fetch(action) }
        Call.new(words, place, code(pair.stimulus, index), actions, outcome.taken.length)
      end
    end

    def words(snapshot)
      snapshot.leaves.join(' + ')
    end

    def code(stimulus, index)
      kind, event = stimulus
      return call('dispatch', inputs_of(index), @names.event(event)) if kind == :event

      call('advance', inputs_of(index), "#{@document.tick_us}U")
    end

    def call(verb, inputs, *last)
      "#{@names.chart_function(verb)}(#{['&chart', *inputs, *last].join(', ')})"
    end

    def inputs_of(index)
      @document.inputs.any? ? ["&inputs[#{index}]"] : []
    end

    # In an expiry the timers of the stimulus reach their delay with the next tick.
    def place(before, stimulus = [:event])
      expiring = stimulus.first == :expire ? stimulus.last : []
      values = @vector.fields.zip(@vector.encode(before)).flat_map { |field, value| members(field, value, expiring) }
      @places[values.join(', ')] ||= @places.length
    end

    def members(field, value, expiring)
      case field.kind
      when :region then [".#{field.name} = (#{field.type})#{value}", ".#{@names.inverse(field.part)} = ~(uint32_t)#{value}"]
      when :timer then [".#{field.name} = #{value == 1}", elapsed(field.part, expiring)]
      else [".#{field.name} = (#{field.type})#{value}"]
      end
    end

    def elapsed(timer, expiring)
      time = expiring.include?(timer.id) ? timer.threshold_us - @document.tick_us : 0
      ".#{@names.time(timer)} = #{time}U"
    end

    def head
      ["#include \"#{@document.name}_chart.h\"", '', '#include <stdlib.h>', '', "static #{@names.chart_type} chart;"]
    end

    def inputs
      return [] if @document.inputs.empty?

      rows = @walk.valuations.map do |valuation|
        valuation.map { |name, value| ".#{@names.field(name)} = #{value}" }.join(', ')
      end
      table(@names.inputs_type, 'inputs', rows)
    end

    def table(type, name, rows)
      ["static const #{type} #{name}[] = {", *rows.map { |row| "    {#{row}}," }, '};']
    end

    def contract
      ['void contract_broken(const char *module, uint32_t id)', '{', '    (void)module;', '    exit((int)id);', '}']
    end

    # A call that was prepared wrongly would be counted in vain.
    def helpers
      ['static void put(uint32_t place)', '{', '    chart = places[place];', '}',
       'static void expect(uint32_t found, uint32_t actions, uint32_t taken)', '{',
       '    if ((found != actions) || (chart.trace.count != taken)) {', '        exit(3);', '    }', '}']
    end

    def line(call)
      "    put(#{call.place}U); expect(#{call.code}, #{call.actions}U, #{call.taken}U);"
    end
  end
end
