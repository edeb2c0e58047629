# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: whatever happens to the programs around it, control goes on; when control itself ends, the cards
# stop the motors.
#
# These runs share the machine with everything else on it, and control may run without real-time rights: so the box
# runs in slow motion, in which a pause of the machine is SLOWNESS times shorter. Who waits for a program that is
# stopped for a second is late in slow motion, too. The disturbed homing may last MORE_CYCLES more or less than the
# quiet one. A pause that is long even so gives an overrun: MORE_OVERRUNS is what a busy machine may differ by between
# two runs, and less than the number of disturbances of either kind.

require_relative 'support/system_test'

class TestIsolation < SystemTest
  CLIENTS = %w[igtl http recorder].freeze
  CARD_WATCHDOG_SECONDS = 0.010 # card_watchdog_us
  SLOWNESS = 5
  HOMING_SECONDS = 30 * SLOWNESS # Measured: 13.
  MORE_CYCLES = 100
  ROUNDS = 4
  MORE_OVERRUNS = (ROUNDS * CLIENTS.size) - 1
  STOPPED = %w[ORDER_DISCARDED LOOP_STOPPED AXIS_STALLED AXIS_FOLLOWING_ERROR CARD_LOST].freeze

  # Homes a new instance and yields while that moves; returns what its log says and how long it took, in cycles.
  def run_homing
    restart
    boresight.press_and_command('START_UP')
    yield if block_given?
    boresight.patiently(HOMING_SECONDS) { ended?(boresight.status) && !boresight.moving? }
    events = boresight.log
    pressed, done = %w[PEDAL_PRESSED ORDER_DONE].map { |name| events.find { |event| event['name'] == name } }
    { events: events.map { |event| event['name'] }, cycles: done && (done['cycle'] - pressed['cycle']),
      overruns: boresight.status['counts']['overruns'], loop: boresight.status['loop'] }
  end

  def ended?(status)
    status['is_homed'] || status['order'] == 'none'
  end

  def restart
    @boresight&.kill_all
    @boresight = nil
    boresight(arguments: ['--slow', SLOWNESS.to_s])
  end

  def report(title, run)
    puts format('SWR-CTRL-001: %<title>s: %<cycles>d cycles, %<overruns>d overruns, wake p99 %<p99>d us, ' \
                'worst %<worst>d us', title:, cycles: run[:cycles].to_i, overruns: run[:overruns],
                                      p99: run[:loop]['wake_p99_us'], worst: run[:loop]['wake_worst_us'])
  end

  def stop_and_continue(name)
    boresight.kill(name, 'STOP')
    sleep 1 # The time it is held, not a wait for something.
    boresight.kill(name, 'CONT')
  end

  # Killed, and stopped as soon as the supervisor has started it again.
  def disturb(name)
    killed = boresight.pid_of(name)
    boresight.kill(name, 'KILL')
    boresight.wait_until(10, "#{name} runs again") { ![nil, killed].include?(boresight.pid_of(name)) }
    stop_and_continue(name)
  end

  # The motion with the disturbances takes as long as the one without and ends as asked; the box' noise has the same
  # seed each time.
  def test_SWR_CTRL_001_killing_and_stopping_every_other_program_does_not_disturb_a_motion
    quiet = run_homing
    report('undisturbed', quiet)
    disturbed = run_homing do
      ROUNDS.times { CLIENTS.each { |name| disturb(name) } }
      assert boresight.patiently { boresight.moving? }, 'the disturbances were not over before the motion'
    end
    report('every other program killed, and stopped', disturbed)
    assert_not_disturbed(quiet, disturbed)
  end

  def assert_not_disturbed(quiet, disturbed)
    refute_nil quiet[:cycles], "the undisturbed motion did not end as asked: #{quiet[:events]}"
    refute_nil disturbed[:cycles], "the motion did not end as asked: #{disturbed[:events]}"
    assert_in_delta quiet[:cycles], disturbed[:cycles], MORE_CYCLES
    assert_empty disturbed[:events] & STOPPED
    assert_operator disturbed[:overruns], :<=, quiet[:overruns] + MORE_OVERRUNS
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

  # Rows of "simctl show": slot, axis, ..., drive and the number of watchdog trips.
  def axes
    boresight.simctl('show').lines.map(&:split).select { |words| words.first.to_s.match?(/\A\d+\z/) }
  end

  def driven(rows)
    rows.reject { |words| words.include?('off') }
  end

  def test_SWR_CTRL_003_the_cards_stop_the_motors_when_control_is_killed
    boresight.press_and_command('START_UP')
    refute_empty driven(axes)
    control = boresight.pid_of('control')
    Process.kill('STOP', boresight.pid) # Otherwise the supervisor would end the box, too.
    Process.kill('KILL', control)
    rows = wait_until(CARD_WATCHDOG_SECONDS + 0.2, 'every drive is off') do
      axes.then { |all| driven(all).empty? && all }
    end
    assert_equal 7, rows.size
    rows.each { |words| assert_operator words.last.to_i, :>=, 1, "no watchdog trip: #{words.join(' ')}" }
  ensure
    Process.kill('CONT', boresight.pid)
  end
end
