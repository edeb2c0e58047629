# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: a control cycle of either clinical robot needs no more instructions than its requirement allows, and no
# more than verification/bench/cost.yml approves; a force sensor and a hand add no more than their requirement allows. The
# measured figures are in build/bench/cost.yml.

require 'minitest/autorun'
require_relative 'cost'

class TestCost < Minitest::Test
  LIMITS = JSON.parse(File.read(File.join(ROOT, 'build/gen/limits/limits.json')))
               .to_h { |limit| [limit['name'], limit['value']] }

  def self.measured
    @measured ||= Cost.measured.tap(&:write)
  end

  Cost::ROBOTS.each do |robot|
    define_method("test_SWR_CTRL_020_median_and_worst_cycle_are_within_their_limits_#{robot}") do
      all = self.class.measured.rows.fetch(robot).fetch('all')
      limit = ->(name) { LIMITS.fetch(robot == 'neuro' ? name : "#{robot}_#{name}") }
      assert_operator all['median'], :<=, limit.call('cycle_median_instructions')
      assert_operator all['worst'], :<=, limit.call('cycle_worst_instructions')
    end
  end

  def test_SWR_CTRL_020_no_figure_is_above_the_approved_one
    assert_empty self.class.measured.complaints(Cost.approved)
  end

  def test_SWR_FORCE_760_a_force_sensor_costs_little_at_rest_and_an_insertion_by_hand_little_more_than_one_without
    with = Cost.medians_by_mode('prostate', 'hand')
    without = Cost.medians_by_mode('prostate', 'sensorless')
    assert_operator with.fetch('NONE'), :>, without.fetch('NONE'), 'the robot without a sensor has one'
    assert_operator with.fetch('NONE') - without.fetch('NONE'), :<=, LIMITS.fetch('force_rest_instructions')
    assert_operator with.fetch('COOPERATE') - with.fetch('MOVE'), :<=, LIMITS.fetch('hand_instructions')
  end

  def test_SWR_CTRL_020_a_figure_that_grew_is_named_with_its_cycle_and_the_command
    now = Cost.approved
    Cost::GATED.each do |key|
      stages = now.rows['prostate']
      less = stages.merge('drive' => stages['drive'].merge(key => stages['drive'][key] - 1))
      before = Cost.new(now.rows.merge('prostate' => less))
      assert_match(/\Aprostate, drive: #{key} grew from \d+ to \d+ .*: make cost-approve\z/, now.complaints(before).join)
    end
  end
end
