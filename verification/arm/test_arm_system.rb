# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: all of Boresight does on a Cortex-A9 with a real-time kernel what it does elsewhere: it homes under the
# pedal, stops, and is off when control dies; a recording made there is computed again on both processors. It does so on a
# simulated box as well as on the board sbrio with its SPI, GPIO and watchdog. Its package is installed there, gone back from
# and removed. Judged by events, never by a clock.

require 'minitest/autorun'
require 'open3'
require 'tmpdir'
require_relative 'arm_system'
require_relative 'installed_system'
require_relative 'wired_system'

Minitest.after_run { Machine.running.dup.each(&:stop) }

class TestArmSystem < Minitest::Test
  ROOT = Machine::ROOT
  # Far slower than any host plays it, so that nothing is late.
  SLOWNESS = 4
  CONTROL_LOST = 4
  OLD = InstalledSystem::OLD
  NEW = InstalledSystem::NEW
  HOST_PAUSE_SECONDS = 2
  EQUAL = /^(?<cycles>\d+) of (?:at least )?\d+ cycles replayed, (?:every output|their outputs) equal/

  def self.build
    @build ||= Open3.capture2e('make', '--no-print-directory', '-C', ROOT, 'arm-machine').tap do |text, status|
      raise text unless status.success?
    end
  end

  # With two cores and the packages; who leaves it without a failure leaves nothing running in it.
  def self.shared_machine
    build
    @shared_machine ||= Machine.start(packages: InstalledSystem.packages)
  end

  def self.drop_machine
    @shared_machine&.stop
    @shared_machine = nil
  end

  def start_paced_machine
    self.class.build
    @machine = Machine.start(paced: true)
  end

  def teardown
    @machine&.stop
    self.class.drop_machine unless passed?
  end

  def test_SWR_ARM_005_SWR_ARM_006_the_whole_system_homes_stops_is_off_without_control_and_is_replayed
    machine = self.class.shared_machine
    assert_equal %w[1 1], machine.run!('cat /sys/kernel/realtime /sys/devices/system/cpu/isolated').split
    system = ArmSystem.new(machine, robot: 'bench2', slowness: SLOWNESS).start
    home_one_axis(system)
    assert_equal({ 'fifo' => true, 'core' => true, 'memory' => true }, system.status.dig('loop', 'rights'))
    pull_estop_while_driven(system)
    kill_control_while_driven(system)
    assert_replayed(system, cycles: 1000)
    system.stop_box
  end

  def test_SWR_ARM_010_SWR_ARM_011_the_package_is_installed_checked_started_gone_back_from_and_removed
    system = InstalledSystem.new(self.class.shared_machine, robot: 'bench2', slowness: SLOWNESS)
    install_both(system)
    assert_checked(system)
    system.configure('bench2')
    system.start
    assert_equal ['Boresight runs.', 0], system.service('status')
    drive_installed(system)
    system.while_held { refuse_under_a_drive(system) }
    stop_installed(system)
    assert_done(system.rollback)
    assert_equal [NEW, OLD], [system.leads('current'), system.leads('previous')]
    remove(system)
    system.stop_box
  end

  def test_SWR_ARM_006_SWR_ARM_008_SWR_ARM_009_the_board_moves_stops_ends_and_is_off_without_control
    machine = start_paced_machine
    system = WiredSystem.new(machine, robot: 'bench2')
    refute_predicate system, :powered?
    system.start
    assert_equal [true, 'active'], [system.powered?, system.watchdog]
    move(system)
    pause_host_while_driven(system)
    pull_wired_estop(system)
    flick_wired_estop(system)
    interrupt(system)
    system.launch
    kill_wired_control(system)
    assert_replayed(system, cycles: 50)
  end

  private

  def move(system)
    before = system.positions
    system.drive_until('an axis has moved') { system.positions != before }
    self.assertions += 1
  end

  def drive(system)
    system.drive_until('an axis is driven') { system.driven.any? }
    self.assertions += 1
  end

  # A busy host in the extreme: it computes nothing for far longer than the cards' watchdogs wait.
  def pause_host_while_driven(system)
    drive(system)
    system.machine.pause(HOST_PAUSE_SECONDS)
    cycle = system.status['cycle']
    wait(system, 'the loop has reported its figures since') { system.status.dig('loop', 'cycles') > cycle }
    assert_equal [0, 0], [system.status.dig('loop', 'overruns'), system.trips]
  end

  def pull_wired_estop(system)
    drive(system)
    system.pull_estop
    wait(system, 'the e-stop is seen') { system.count('ESTOP_PULLED') == 1 }
    wait(system, 'every drive is off') { system.driven.empty? }
    system.reset_estop
  end

  # The kernel keeps the edges of what is over when control looks.
  def flick_wired_estop(system)
    drive(system)
    system.pull_estop
    system.reset_estop
    wait(system, 'the e-stop is seen again') { system.count('ESTOP_PULLED') == 2 }
    wait(system, 'every drive is off') { system.driven.empty? }
  end

  def interrupt(system)
    system.interrupt
    assert_equal 0, system.wait_for_end
    assert_equal [false, 'inactive'], [system.powered?, system.watchdog]
  end

  def kill_wired_control(system)
    trips = system.trips
    drive(system)
    assert_equal 'active', system.kill_control
    wait(system, 'the cards have switched off by themselves') { system.driven.empty? && system.trips > trips }
    assert_equal CONTROL_LOST, system.wait_for_end
  end

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

  def assert_done(result)
    assert_equal 0, result.last, result.first
    result.first
  end

  def install_both(system)
    assert_done(system.install(OLD))
    assert_done(system.install(NEW))
    assert_equal [NEW, OLD], [system.leads('current'), system.leads('previous')]
    assert_done(system.rollback)
    assert_equal [OLD, NEW], [system.leads('current'), system.leads('previous')]
  end

  # Checks of time depend on the emulation.
  def assert_checked(system)
    said = system.check.first.scan(/^(ok|no|!!) +([A-Z_]+) /).to_h(&:reverse)
    assert_equal 15, said.size
    assert_equal %w[ok] * 6, said.values_at('KERNEL', 'THROTTLING', 'RIGHTS', 'OWN_CORE', 'INTERRUPTS', 'WATCHDOG')
  end

  def drive_installed(system)
    system.command('START_UP')
    wait(system, 'homing is armed') { system.status['order'] != 'none' }
    system.simctl('pedal', 'press')
    wait(system, 'an axis is driven') { system.driven.any? }
  end

  # Each way to replace it.
  def refuse_under_a_drive(system)
    [system.rollback, system.install(NEW), system.dpkg('--remove', 'boresight')].each do |text, code|
      refute_equal 0, code, text
      assert_match(/nothing is replaced, .*(The drive of \w+ is on|A motion is armed)/, text)
    end
    assert_equal [OLD, NEW, ['Boresight runs.', 0]], [system.leads('current'), system.leads('previous'), system.service('status')]
  end

  def stop_installed(system)
    assert_done(system.service('stop'))
    assert_equal ['Boresight does not run.', 3], system.service('status')
    assert_empty system.driven
    assert_replayed(system, cycles: 10)
  end

  # Files of the engineer stay.
  def remove(system)
    assert_done(system.dpkg('--remove', 'boresight'))
    kept = system.machine.run!('ls /opt; cat /etc/boresight/boresight.conf; ls /var/lib/boresight')
    assert_match(/^robot bench2$.*^blackbox-/m, kept)
    refute_match(/^boresight$/, kept)
    assert_match(%r{Recordings stay in /var/lib/boresight}, assert_done(system.dpkg('--purge', 'boresight')))
    assert_match(/^0\nblackbox-/, system.machine.run!('ls /etc/boresight 2>/dev/null | wc -l; ls /var/lib/boresight'))
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

  # Each recording is replayed on either processor, with so many cycles at least.
  def assert_replayed(system, cycles:)
    Dir.mktmpdir do |folder|
      system.fetch_recordings(folder).each do |file|
        here, there = [['build/bin/boresight-replay'], %w[qemu-arm -cpu cortex-a9 build/arm/bin/boresight-replay]].map do |words|
          replay(words, file)
        end
        assert_equal here, there
        assert_operator here, :>, cycles
      end
    end
  end

  def replay(words, file)
    text, status = Open3.capture2e(*words, file, chdir: ROOT)
    assert_predicate status, :success?, text
    text[EQUAL, :cycles].to_i
  end

  def wait(system, reason, &)
    self.assertions += 1
    system.wait_until(reason, &)
  end
end
