# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: whatever happens to the programs around it, control goes on, and so does a motion whose commander is
# still there; when control itself ends, the cards stop the motors.
#
# In elastic time, where a pause of the machine is none, a disturbed motion is the same as an undisturbed one. In real
# time no cycle is late for a disturbance. There the box runs in slow motion: who waits for a program that is stopped for
# a second is late, and a pause of the machine can be the cause of an overrun only if it is longer than what a cycle may
# be late by. So many overruns the pauses of the same seconds excuse, beside fewer than there are disturbances; whether
# the loop guard then stops the motion is the machine's affair.

require_relative '../support/pauses'
require_relative '../support/system_test'

class TestIsolation < SystemTest
  CLIENTS = %w[igtl http recorder].freeze
  BYSTANDERS = %w[http recorder].freeze # The commander comes by igtl.
  SLOWNESS = 5
  LATE_SECONDS = 0.0005 * SLOWNESS # overrun_us less cycle_us
  MORE_CYCLES = 100
  ROUNDS = 2
  MORE_OVERRUNS = (ROUNDS * CLIENTS.size) - 1
  STOPPED = %w[ORDER_DISCARDED LOOP_STOPPED AXIS_STALLED AXIS_FOLLOWING_ERROR CARD_LOST].freeze

  # Homes a new instance and yields while that moves; returns what its log says and how long it took, in cycles.
  def run_homing
    @boresight&.kill_all
    @boresight = Boresight.start
    boresight.press_and_command('START_UP')
    yield if block_given?
    boresight.wait_for_homing
    events = boresight.log
    pressed, done = %w[PEDAL_PRESSED ORDER_DONE].map { |name| events.find { |event| event['name'] == name } }
    { events: events.map { |event| event['name'] }, cycles: done && (done['cycle'] - pressed['cycle']) }
  end

  def stop_and_continue(name)
    boresight.while_stopped(name) { sleep 1 } # The time it is held, not a wait for something.
  end

  # Killed, and stopped as soon as the supervisor has started it again.
  def disturb(name)
    killed = boresight.pid_of(name)
    boresight.kill(name, 'KILL')
    boresight.wait_until("#{name} runs again") { ![nil, killed].include?(boresight.pid_of(name)) }
    stop_and_continue(name)
  end

  def disturb_all(names)
    ROUNDS.times { names.each { |name| disturb(name) } }
  end

  # The box' noise has the same seed each time.
  def test_SWR_CTRL_001_killing_and_stopping_who_does_not_command_does_not_disturb_a_motion
    quiet = run_homing
    disturbed = run_homing do
      disturb_all(BYSTANDERS)
      order = boresight.patiently { boresight.status['order'] }
      refute_equal 'none', order, 'the disturbances were not over before the motion'
    end
    puts format('SWR-CTRL-001: %d cycles undisturbed, %d disturbed', quiet[:cycles].to_i, disturbed[:cycles].to_i)
    [quiet, disturbed].each { |run| refute_nil run[:cycles], "the motion did not end as asked: #{run[:events]}" }
    assert_in_delta quiet[:cycles], disturbed[:cycles], MORE_CYCLES
    assert_empty disturbed[:events] & STOPPED
  end

  def test_SWR_CTRL_001_killing_and_stopping_every_other_program_makes_no_cycle_late
    boresight(arguments: ['--real-time', '--slow', SLOWNESS.to_s])
    boresight.press_and_command('START_UP')
    pauses = Pauses.new(boresight.pids.values_at('control', 'box'))
    before = boresight.status['counts']['overruns']
    disturb_all(CLIENTS)
    overruns = boresight.patiently { boresight.status['counts']['overruns'] } - before
    paused = pauses.seconds
    puts format('SWR-CTRL-001: %d overruns, %.3f s of pauses', overruns, paused)
    assert_operator overruns, :<=, MORE_OVERRUNS + (paused / LATE_SECONDS)
  end

  def test_SWR_CTRL_002_control_says_which_rights_it_did_not_get
    setpriv = %w[setpriv --bounding-set=-sys_nice,-ipc_lock]
    prefix = Process.uid.zero? ? ['prlimit', '--rtprio=0', '--memlock=65536', *setpriv] : []
    boresight(prefix:)
    rights = boresight.status['loop']['rights']
    assert_equal rights['fifo'], !boresight.output.include?('no real-time priority')
    assert_equal rights['memory'], !boresight.output.include?('memory is not locked')
    assert_equal rights['core'], !boresight.output.include?('no core of its own')
    refute rights['fifo'], 'the test took the right away' if Process.uid.zero?
  end

  def test_SWR_CTRL_003_the_cards_stop_the_motors_when_control_is_killed
    boresight(arguments: ['--real-time'])
    boresight.despite_pauses do
      boresight.press_and_command('START_UP')
      wait_until('an axis is driven') { boresight.driven_axes.any? }
    end
    control = boresight.pid_of('control')
    Process.kill('STOP', boresight.pid) # Otherwise the supervisor would end the box, too.
    Process.kill('KILL', control)
    assert_equal 7, boresight.box_axes.size
    wait_until('every watchdog has tripped') { boresight.box_axes.all? { |words| words.last.to_i >= 1 } }
    assert_empty boresight.driven_axes
  ensure
    Process.kill('CONT', boresight.pid)
  end
end
