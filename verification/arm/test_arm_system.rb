# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: all of Boresight does on a Cortex-A9 with a real-time kernel what it does elsewhere: it homes under the
# pedal, stops, and is off when control dies; what was recorded there is computed again on both processors. Judged by
# events, never by a clock: emulation is slow and stutters.

require 'minitest/autorun'
require 'open3'
require 'tmpdir'
require_relative 'arm_system'

Minitest.after_run { Machine.running.dup.each(&:stop) }

class TestArmSystem < Minitest::Test
  ROOT = Machine::ROOT
  # Far slower than any host plays it, so that nothing is late.
  SLOWNESS = 4
  CONTROL_LOST = 4
  WHOLE = /^(?<cycles>\d+) cycles replayed, every output equal/

  def self.machine
    @machine ||= begin
      text, status = Open3.capture2e('make', '--no-print-directory', '-C', ROOT, 'arm-programs')
      raise text unless status.success?

      Machine.start
    end
  end

  def machine
    self.class.machine
  end

  def test_SWR_ARM_005_SWR_ARM_006_the_whole_system_homes_stops_is_off_without_control_and_is_replayed
    assert_equal %w[1 1], machine.run!('cat /sys/kernel/realtime /sys/devices/system/cpu/isolated').split
    system = ArmSystem.new(machine, robot: 'bench2', slowness: SLOWNESS).start
    home_one_axis(system)
    assert_equal({ 'fifo' => true, 'core' => true, 'memory' => true }, system.status.dig('loop', 'rights'))
    pull_estop_while_driven(system)
    kill_control_while_driven(system)
    assert_replayed(system)
  end

  private

  def home_one_axis(system)
    system.command('START_UP')
    wait(system, 'homing is armed') { system.count('ORDER_ARMED') == 1 }
    assert_empty system.driven
    system.simctl('pedal', 'press')
    wait(system, 'an axis is homed') { system.count('AXIS_HOMED') == 1 }
  end

  def pull_estop_while_driven(system)
    wait(system, 'the next one is driven') { system.driven.any? }
    system.simctl('estop', 'pull')
    wait(system, 'the e-stop is seen') { system.count('ESTOP_PULLED') == 1 }
    assert_empty system.driven
  end

  # It begins anew: released, reset, armed, pressed.
  def kill_control_while_driven(system)
    system.simctl('estop', 'reset')
    system.release_pedal
    system.command('START_UP')
    wait(system, 'homing is armed again') { system.status['order'] != 'none' }
    system.simctl('pedal', 'press')
    wait(system, 'an axis is driven') { system.driven.any? }
    system.kill_control
    wait(system, 'the cards have switched off by themselves') { system.driven.empty? }
    assert_equal CONTROL_LOST, system.wait_for_end
  end

  # Whoever computes it.
  def assert_replayed(system)
    Dir.mktmpdir do |folder|
      file = system.fetch_recording(folder)
      cycles = [['build/bin/boresight-replay'], %w[qemu-arm -cpu cortex-a9 build/arm/bin/boresight-replay]].map do |words|
        text, status = Open3.capture2e(*words, file, chdir: ROOT)
        assert_predicate status, :success?, text
        text[WHOLE, :cycles].to_i
      end
      assert_equal 1, cycles.uniq.size
      assert_operator cycles.first, :>, 1000
    end
  end

  def wait(system, reason, &)
    self.assertions += 1
    system.wait_until(reason, &)
  end
end
