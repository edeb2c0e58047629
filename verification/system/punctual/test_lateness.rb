# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: in real time a control that comes late three times in a row stops all motion until START_UP, and one
# that does not come at all is noticed by the cards. The box runs in slow motion, so that being held is late and a pause
# of the machine is not.

require_relative '../support/system_test'

class TestLateness < SystemTest
  SLOWNESS = 20
  HELD_SECONDS = 0.05 # 2.5 cycles of the slow box; from 1.5 on a cycle is late.
  FREE_SECONDS = 0.004

  def setup
    boresight(arguments: ['--real-time', '--slow', SLOWNESS.to_s])
  end

  # Holds control before each of its next cycles. These times are the disturbance, no wait.
  def hold_control
    control = boresight.pid_of('control')
    10.times do
      Process.kill('STOP', control)
      sleep HELD_SECONDS
      Process.kill('CONT', control)
      sleep FREE_SECONDS
    end
  end

  def test_SWR_LOOP_002_a_late_loop_stops_motion_until_start_up
    boresight.press_and_command('START_UP')
    names = wait_until('the loop is stopped') do
      hold_control
      boresight.log.map { |event| event['name'] }.then { |all| all if all.include?('LOOP_STOPPED') }
    end
    assert_operator names.count('OVERRUN'), :>=, 3
    wait_until('every drive is off') { boresight.driven_axes.empty? }
    assert_equal %w[stopped none], [boresight.status['loop']['state'], boresight.status['order']]
    reasons = boresight.motors['axes'].map { |axis| axis['permit']['reasons'].map { |reason| reason['name'] } }
    reasons.each { |all| assert_includes all, 'LOOP_STOPPED' }
    boresight.press_and_command('START_UP')
    assert_equal 'on_time', boresight.status['loop']['state']
  end
end
