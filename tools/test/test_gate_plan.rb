# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: a gate starts when what it needs has passed and a core is free, the longest first; one that must
# be alone runs after all others; and from that follows how long it all takes.

require 'minitest/autorun'
require_relative '../gates/plan'

class TestGatePlan < Minitest::Test
  def test_SWR_GATE_002_waits_for_what_it_needs
    assert_equal %w[build], startable(passed: [], waiting: %w[build long short])
    assert_equal %w[long], startable(passed: %w[build], waiting: %w[long later])
    assert_equal %w[later], startable(passed: %w[build long], waiting: %w[later])
  end

  def test_SWR_GATE_002_the_longest_go_first_as_long_as_a_core_is_free
    assert_equal %w[long middle], startable(passed: %w[build], waiting: %w[short middle long])
    assert_equal %w[middle], startable(passed: %w[build], running: %w[long], waiting: %w[short middle])
    assert_empty startable(passed: %w[build], running: %w[long middle], waiting: %w[short])
  end

  def test_SWR_GATE_002_one_gate_that_waits_runs_beside_those_that_keep_the_cores_busy
    assert_equal %w[idle], startable(passed: %w[build], running: %w[wide], waiting: %w[idle rest short])
    assert_equal %w[idle long middle], startable(passed: %w[build], waiting: %w[idle rest long middle short])
    assert_equal %w[middle], startable(passed: %w[build], running: %w[idle long], waiting: %w[rest middle short])
    assert_empty startable(passed: %w[build], running: %w[idle], waiting: %w[rest])
    assert_equal 20, left(waiting: %w[idle short])
    assert_equal 2 + 1, left(waiting: %w[idle rest])
  end

  def test_SWR_GATE_002_a_wide_gate_shares_a_core
    assert_equal %w[wide], startable(passed: %w[build], running: %w[long], waiting: %w[wide short])
    assert_equal %w[wide], startable(passed: %w[build], waiting: %w[wide], cores: 1)
  end

  def test_SWR_GATE_002_those_that_must_be_alone_come_last_one_by_one_in_their_order
    assert_empty startable(passed: %w[build], running: %w[long middle], waiting: %w[short alone last])
    assert_empty startable(passed: %w[build], running: %w[short], waiting: %w[alone last])
    assert_equal %w[alone], startable(passed: %w[build], waiting: %w[alone last])
    assert_empty startable(passed: %w[build], running: %w[alone], waiting: %w[last])
    assert_equal %w[last], startable(passed: %w[build], waiting: %w[last])
  end

  def test_SWR_GATE_003_reports_how_long_is_left
    assert_equal 0, left(waiting: [])
    assert_equal 60, left(passed: [], waiting: %w[build short long])
    # long beside middle and then short; then alone.
    assert_equal 50 + 7, left(waiting: %w[short long middle alone])
    # long runs for 5 s more, then later beside short.
    assert_equal 5 + 20, left(running: { 'long' => 5, 'middle' => 5 }, waiting: %w[later short])
  end

  private

  SECONDS = { 'build' => 10, 'long' => 50, 'middle' => 30, 'short' => 20, 'later' => 5, 'wide' => 40, 'idle' => 2,
              'rest' => 1, 'alone' => 7, 'last' => 90 }.freeze
  GATES = SECONDS.keys.to_h do |name|
    needs = { 'build' => [], 'later' => %w[build long] }.fetch(name, %w[build])
    [name, Gates::Gate.new(name: name, needs: needs, cores: { 'wide' => 2 }.fetch(name, 1),
                           waits: %w[idle rest].include?(name), alone: %w[alone last].include?(name))]
  end.freeze

  def gates(names)
    GATES.values_at(*names)
  end

  def startable(passed:, waiting:, running: [], cores: 2)
    Gates::Plan.new(cores, SECONDS).startable(gates(passed), gates(running), gates(waiting)).map(&:name)
  end

  def left(waiting:, passed: %w[build], running: {})
    running = running.transform_keys { |name| GATES[name] }
    Gates::Plan.new(2, SECONDS).seconds_left(gates(passed), running, gates(waiting))
  end
end
