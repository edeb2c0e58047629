# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../emit/c/layout'
require_relative '../emit/c/names'

module Chart
  # The shortest way to break a property or a rule: in words, and as a Unity test of the compiled chart that fails as
  # long as the way is open.
  # @satisfies SWR-CHART-013
  class Counterexample
    include C::Layout

    BINARY = { and: '&&', or: '||', add: '+', subtract: '-' }.freeze

    # What is broken. demand: an expression that must hold when the steps are done.
    # at: :end; :before for guards, which read what stands before the last step; or :taken, when that step must take a
    # transition, and there is no demand. effects: the property whose `does`, `starts` and `stays` the last step
    # must fulfil, if any.
    Claim = Struct.new(:id, :req, :line, :says, :demand, :at, :effects, keyword_init: true)
    # What a timer has run before the last step: more than one that was started in it.
    RUN_US = 1

    # The refused chart, and the list of events in words.
    attr_reader :document, :walk, :words

    # steps: [stimulus, inputs] from the start on.
    def initialize(document, walk, claim, steps)
      @document = document
      @walk = walk
      @claim = claim
      @steps = steps
      @words = walk.words(steps)
      @regions = Regions.new(document)
      @names = C::Names.new(document, @regions)
    end

    def file_name
      "test_#{@names.stem_of(@claim.id)}_counterexample.c"
    end

    def test
      text([about, '', '#include "unity.h"', '', "#include \"#{@document.name}_chart.h\"", '',
            'void setUp(void)', '{', '}', '', 'void tearDown(void)', '{', '}', '',
            "void #{test_name}(void)", '{', body.map { |line| line.empty? ? line : "    #{line}" }, '}'])
    end

    private

    def about
      ['/* SPDX-License-Identifier: Apache-2.0 */',
       *comment("The shortest way to break #{[@claim.id, *requirements].join(' ')} of #{@document.name}.scxml line " \
                "#{@claim.line}, found by chartc: #{@words}."),
       *comment("The rule under test: #{@claim.says}".gsub('*/', '* /'))]
    end

    def requirements
      @claim.req.empty? ? [] : ["(#{@claim.req.join(' ')})"]
    end

    def test_name
      ['test', *@claim.req.first&.tr('-', '_'), @names.stem_of(@claim.id), 'holds'].join('_')
    end

    def body
      inputs = @document.inputs.empty? ? [] : ["#{@names.inputs_type} inputs;"]
      ["#{@names.chart_type} chart;", *inputs, '', "#{@names.chart_function('init')}(&chart);", '',
       *@steps[0..-2].flat_map { |stimulus, values| [*input_lines(values), *step_lines(stimulus), ''] }, *ending]
    end

    def ending
      return assertion(condition(@claim.demand)) if @steps.empty?

      stimulus, values = @steps.last
      inputs = input_lines(values)
      case @claim.at
      when :end then [*inputs, *last_step(stimulus), '', *demanded, *effects]
      when :before then [*inputs, *assertion(condition(@claim.demand))]
      when :taken
        [*inputs, 'const uint32_t before = chart.trace.count;', *step_lines(stimulus), '',
         *assertion('(chart.trace.count != before)')]
      end
    end

    def demanded
      @claim.demand == [:boolean, true] ? [] : assertion(condition(@claim.demand))
    end

    # The actions are kept where it depends on them.
    def last_step(stimulus)
      lines = step_lines(stimulus)
      timers = stimulus.first == :event && @claim.effects ? @claim.effects.starts : []
      before = @claim.effects&.stays ? ['const uint32_t before = chart.trace.count;'] : []
      last = @claim.effects&.does ? lines.last.sub('(void)', 'const uint32_t actions = ') : lines.last
      before + timers.map { |timer| "chart.#{@names.time(timer)} = #{RUN_US}U;" } + lines[0..-2] + [last]
    end

    def effects
      return [] unless @claim.effects

      @claim.effects.starts.flat_map { |timer| started(timer) } + did(@claim.effects.does) + stayed
    end

    def started(timer)
      assertion("((chart.#{@names.armed(timer)} != 0U) && (chart.#{@names.time(timer)} == 0U))")
    end

    # Where it may do something, what it takes has no target.
    def stayed
      return [] unless @claim.effects.stays

      targetless = @document.transitions.select(&:targetless?)
      last = 'chart.trace.steps[(chart.trace.count - 1U) % CHART_TRACE_LENGTH].transition'
      taken = targetless.map { |one| "(#{last} == #{one.number}U)" }
      assertion("(#{['(chart.trace.count == before)', *taken].join(' || ')})")
    end

    def did(actions)
      return [] unless actions

      assertion("(actions == #{actions.empty? ? '0U' : "(#{actions.map { |one| @names.action(one) }.join(' | ')})"})")
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
      "chart.#{@names.time(timer)} = #{expires ? [timer.threshold_us - 1, 0].max : 0}U;"
    end

    def run(function, last)
      inputs = @document.inputs.empty? ? [] : ['&inputs']
      "(void)#{@names.chart_function(function)}(#{['&chart', *inputs, last].join(', ')});"
    end

    def assertion(condition)
      [*at_operators("TEST_ASSERT_TRUE_MESSAGE(#{condition},", 90), "    \"#{@claim.id}\");"]
    end

    def condition(expression)
      kind, left, right, last = expression
      case kind
      when :in then place(@document.state(left))
      when :variable then variable(left)
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
      tests = leaves.map { |leaf| "(chart.#{@names.field(region.name)} == #{@names.leaf(leaf)})" }
      tests.one? ? tests.first : "(#{tests.join(' || ')})"
    end

    def variable(name)
      holder = @document.inputs.any? { |input| input.name == name } ? 'inputs' : 'chart'
      "#{holder}.#{@names.field(name)}"
    end
  end
end
