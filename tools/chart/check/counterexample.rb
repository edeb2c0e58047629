# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../emit/c/layout'
require_relative '../emit/c/names'

module Chart
  # The shortest way to break a property: in words, and as a Ceedling test of the compiled chart that fails as long as
  # the way is open.
  class Counterexample
    include C::Layout

    BINARY = { and: '&&', or: '||', add: '+', subtract: '-' }.freeze

    attr_reader :property, :snapshot, :words

    # steps: [stimulus, inputs] from the start on; the last one leads to the snapshot.
    def initialize(document, property, steps, snapshot, words)
      @document = document
      @property = property
      @steps = steps
      @snapshot = snapshot
      @words = words
      @regions = Regions.new(document)
      @names = C::Names.new(document, @regions)
    end

    def file_name
      "test_#{@names.prefix}_#{@names.stem_of(@property.id)}.c"
    end

    def test
      text([about, '', '#include "unity.h"', '', "#include \"#{@document.name}_chart.h\"", '',
            'void setUp(void)', '{', '}', '', 'void tearDown(void)', '{', '}', '',
            "void #{test_name}(void)", '{', body.map { |line| line.empty? ? line : "    #{line}" }, '}'])
    end

    private

    def about
      ['/* SPDX-License-Identifier: Apache-2.0 */',
       *comment("The shortest way to break #{@property.id} (#{@property.req.join(' ')}) of #{@document.name}.scxml " \
                "line #{@property.line}, found by tools/chart_compiler.rb: #{@words}."),
       *comment("The rule under test: #{@property.text}".gsub('*/', '* /'))]
    end

    def test_name
      requirement = @property.req.first&.tr('-', '_')
      ['test', *requirement, @names.stem_of(@property.id), 'holds'].join('_')
    end

    def body
      inputs = @document.inputs.empty? ? [] : ["#{@names.inputs_type} inputs;"]
      ["#{@names.chart_type} chart;", *inputs, '', "#{@names.chart_function('init')}(&chart);", '',
       *@steps.flat_map { |stimulus, values| [*input_lines(values), *step_lines(stimulus), ''] }, *assertion]
    end

    def input_lines(values)
      @document.inputs.map { |input| "inputs.#{@names.field(input.name)} = #{values.fetch(input.name)};" }
    end

    def step_lines(stimulus)
      kind, what = stimulus
      return [run('dispatch', @names.event(what))] if kind == :event

      @document.timers.map { |timer| time_line(timer, what.include?(timer.id)) } + [run('advance', '1U')]
    end

    # One microsecond before the end, or at the beginning.
    def time_line(timer, expires)
      "chart.#{@names.field(timer.id)}_us = #{expires ? [timer.threshold_us - 1, 0].max : 0}U;"
    end

    def run(function, last)
      inputs = @document.inputs.empty? ? [] : ['&inputs']
      "(void)#{@names.chart_function(function)}(#{['&chart', *inputs, last].join(', ')});"
    end

    # What the property demands at the end; from a configuration that should lead on: that it is not entered.
    def assertion
      condition = case @property.kind
                  when :always, :response then condition(@property.expression)
                  when :only then "!#{condition(@property.expression)}"
                  when :reachable then "!#{all(@snapshot.leaves.map { |id| place(@document.state(id)) })}"
                  end
      [*at_operators("TEST_ASSERT_TRUE_MESSAGE(#{condition},", 90), "    \"#{@property.id}\");"]
    end

    def condition(expression)
      kind, left, right, last = expression
      case kind
      when :in then place(@document.state(left))
      when :variable then "chart.#{@names.field(left)}"
      when :number, :boolean then left.to_s
      when :not then "!#{condition(left)}"
      when :compare then "(#{condition(right)} #{left} #{condition(last)})"
      else "(#{condition(left)} #{BINARY.fetch(kind)} #{condition(right)})"
      end
    end

    def place(state)
      region = @regions.of(state)
      return 'true' unless region

      leaves = region.leaves.select { |leaf| leaf == state || leaf.inside?(state) }
      "(#{leaves.map { |leaf| "(chart.#{@names.field(region.name)} == #{@names.leaf(leaf)})" }.join(' || ')})"
    end

    def all(conditions)
      "(#{conditions.join(' && ')})"
    end
  end
end
