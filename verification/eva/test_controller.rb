# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: for any inputs in any cycle Eva finds no run-time error of the controller that is not listed with a reason or
# as open. `make eva ROBOT=name` follows another robot, `make eva-list` writes the list.

require 'minitest/autorun'
require_relative '../../tools/eva/alarm_list'
require_relative '../../tools/eva/analysis'

class TestController < Minitest::Test
  ROOT = File.expand_path('../..', __dir__)
  ROBOT = 'neuro'
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

  def test_SWR_TOOL_230_nearly_every_statement_of_the_controller_is_reached
    reached, all = self.class.controller.reached[:statements]
    assert_operator reached, :>=, LEAST_REACHED * all
  end
end
