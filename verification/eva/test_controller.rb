# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: for any inputs in any cycle Eva finds no run-time error of the controller that is not listed with a reason or
# as open, and no function falls out of proof. `make eva ROBOT=name` follows another robot, `make eva-list` writes the lists.

require 'minitest/autorun'
require_relative '../../tools/eva/alarm_list'
require_relative '../../tools/eva/analysis'
require_relative '../../tools/eva/reasons'
require_relative '../../tools/proof/coverage'
require_relative '../../tools/proof/proved_list'

class TestController < Minitest::Test
  ROOT = File.expand_path('../..', __dir__)
  ROBOT = Proof::ProvedList::ROBOT
  # Of the statements; it may only rise.
  LEAST_REACHED = 0.97

  def self.controller
    @controller ||= Dir.chdir(ROOT) { Eva::Analysis.of_controller(ROBOT).run }
  end

  def test_SWR_TOOL_230_every_alarm_of_the_controller_is_listed_and_every_listed_one_is_there
    alarms = self.class.controller.alarms
    puts "eva: #{ROBOT}: #{self.class.controller.figures}"
    assert_empty Eva::AlarmList.read(File.join(ROOT, Eva::AlarmList::FILE)).problems(ROBOT, alarms)
  end

  def test_SWR_TOOL_500_every_line_that_a_reason_rests_on_is_there
    list = Eva::AlarmList.read(File.join(ROOT, Eva::AlarmList::FILE))
    assert_empty Eva::Reasons.new(ROOT).problems(list.reasons(ROBOT))
  end

  def test_SWR_TOOL_280_the_functions_that_are_proved_are_those_of_their_list
    with_open = Eva::AlarmList.read(File.join(ROOT, Eva::AlarmList::FILE)).open_functions(ROBOT)
    analysis = self.class.controller
    Dir.chdir(ROOT) do
      states = Proof::Coverage.new(reached: analysis.functions, with_open: with_open).states
      assert_empty Proof::ProvedList.read.problems(states)
    end
  end

  def test_SWR_TOOL_230_nearly_every_statement_of_the_controller_is_reached
    reached, all = self.class.controller.reached[:statements]
    assert_operator reached, :>=, LEAST_REACHED * all
  end
end
