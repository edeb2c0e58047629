# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../lib/check/walk_checks'
require_relative '../lib/read/parser'
require_relative '../lib/walk/walk'

# Charts for the tests of the interpreter and of the walk: conformance charts by their body, run step by step, and
# the lamp, a product chart that passes every rule, with changes.
module OwnCharts
  LIMITS = { 'cycle_us' => 1000, 'warm_up_us' => 3000 }.freeze
  FILE = File.join(__dir__, 'charts', 'lamp.scxml')
  CHART = File.read(FILE)

  def engine(body)
    text = '<scxml xmlns="http://www.w3.org/2005/07/scxml" xmlns:bs="urn:boresight:chart" version="1.0" ' \
           "datamodel=\"ecmascript\">#{body}</scxml>"
    Chart::Parser.parse('own.scxml', text, {}, mode: :engine)
  end

  def start(body)
    @interpreter = Chart::Interpreter.new(engine(body))
    @outcome = @interpreter.start
  end

  def event(name, inputs = {})
    @outcome = @interpreter.dispatch(@outcome.after, name, inputs)
  end

  def expire(*timers)
    @outcome = @interpreter.expire(@outcome.after, timers, {})
  end

  def leaves
    @outcome.after.leaves
  end

  def parse(text)
    Chart::Parser.parse(FILE, text, LIMITS)
  end

  def walk_of(text)
    Chart::Walk.new(parse(text)).run
  end

  # Each change must find its place.
  def changed(*changes)
    changes.reduce(CHART) do |text, (pattern, replacement)|
      assert_match pattern, text
      text.sub(pattern, replacement)
    end
  end

  def refusal_of(*changes)
    text = changed(*changes)
    assert_raises(Chart::Refusal) { Chart::WalkChecks.run(parse(text), walk_of(text)) }
  end

  def assert_sound(*changes)
    text = changed(*changes)
    Chart::WalkChecks.run(parse(text), walk_of(text))
    pass
  end

  # One more, without target.
  def transition(attributes)
    "<transition bs:id=\"LAMP-T10\" #{attributes} bs:req=\"SWR-CHART-001\"/>"
  end

  def line_of(words)
    CHART.lines.index { |line| line.include?(words) } + 1
  end
end
