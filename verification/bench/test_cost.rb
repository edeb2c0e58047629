# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: a control cycle needs no more instructions than its requirement allows, and no more than
# verification/bench/cost.yml approves. What was measured is in build/bench/cost.yml.

require 'minitest/autorun'
require_relative 'cost'

class TestCost < Minitest::Test
  LIMITS = JSON.parse(File.read(File.join(ROOT, 'build/gen/limits/limits.json')))
               .to_h { |limit| [limit['name'], limit['value']] }

  def self.measured
    @measured ||= Cost.measured.tap(&:write)
  end

  def test_SWR_CTRL_020_median_and_worst_cycle_are_within_their_limits
    all = self.class.measured.rows['all']
    assert_operator all['median'], :<=, LIMITS.fetch('cycle_median_instructions')
    assert_operator all['worst'], :<=, LIMITS.fetch('cycle_worst_instructions')
  end

  def test_SWR_CTRL_020_no_figure_is_above_the_approved_one
    assert_empty self.class.measured.complaints(Cost.approved)
  end

  def test_SWR_CTRL_020_a_figure_that_grew_is_named_with_its_cycle_and_the_command
    now = Cost.approved
    Cost::GATED.each do |key|
      before = Cost.new(now.rows.merge('drive' => now.rows['drive'].merge(key => now.rows['drive'][key] - 1)))
      assert_match(/\Adrive: #{key} grew from \d+ to \d+ .*: make cost-approve\z/, now.complaints(before).join)
    end
  end
end
