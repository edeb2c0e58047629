# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: whatever happens to the programs around it, control goes on; when control itself ends, the cards
# stop the motors.

require_relative 'support/boresight'

class TestIsolation < SystemTest
  CLIENTS = %w[igtl http recorder].freeze
  CARD_WATCHDOG_SECONDS = 0.010 # card_watchdog_us

  # Homes again and yields while that moves; returns what the log says of it and how long it took, in cycles.
  def run_homing
    boresight.press_and_command('START_UP')
    first = boresight.status['counts']['events']
    overruns = boresight.status['counts']['overruns']
    began = boresight.status['cycle']
    yield if block_given?
    boresight.patiently(90) { boresight.status['is_homed'] && !boresight.moving? }
    boresight.simctl('pedal', 'release')
    events = boresight.log(first)
    done = events.find { |event| event['name'] == 'ORDER_DONE' }
    { events: events.map { |event| event['name'] }, cycles: done ? done['cycle'] - began : nil,
      overruns: boresight.status['counts']['overruns'] - overruns, loop: boresight.status['loop'] }
  end

  def report(title, run)
    puts format('SWR-CTRL-001: %<title>s: %<cycles>d cycles, %<overruns>d overruns, wake p99 %<p99>d us, ' \
                'worst %<worst>d us', title:, cycles: run[:cycles], overruns: run[:overruns],
                                      p99: run[:loop]['wake_p99_us'], worst: run[:loop]['wake_worst_us'])
  end

  def stop_and_continue(name)
    boresight.kill(name, 'STOP')
    sleep 1 # The time it is held, not a wait for something.
    boresight.kill(name, 'CONT')
  end

  def disturb(name, signal)
    signal == 'STOP' ? stop_and_continue(name) : boresight.kill(name, signal)
  end

  # The motion with the disturbance takes as long as the one without and ends as asked.
  def assert_undisturbed(name, signal)
    boresight.home
    quiet = run_homing
    disturbed = run_homing { disturb(name, signal) }
    report('undisturbed', quiet)
    report("#{signal} to #{name}", disturbed)
    refute_nil disturbed[:cycles], "the motion did not end as asked: #{disturbed[:events]}"
    assert_in_delta quiet[:cycles], disturbed[:cycles], 150 + (quiet[:cycles] / 50)
    assert_empty disturbed[:events] & %w[ORDER_DISCARDED LOOP_STOPPED AXIS_STALLED AXIS_FOLLOWING_ERROR CARD_LOST]
    assert_operator disturbed[:overruns], :<=, quiet[:overruns] + 2
  end

  CLIENTS.product(%w[KILL STOP]).each do |name, signal|
    verb = { 'KILL' => 'killing', 'STOP' => 'stopping' }.fetch(signal)
    define_method("test_SWR_CTRL_001_#{verb}_#{name}_does_not_disturb_a_motion") { assert_undisturbed(name, signal) }
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
    rows = wait_until(CARD_WATCHDOG_SECONDS + 0.2, 'every drive is off') { axes.then { |all| driven(all).empty? && all } }
    assert_equal 7, rows.size
    rows.each { |words| assert_operator words.last.to_i, :>=, 1, "no watchdog trip: #{words.join(' ')}" }
  ensure
    Process.kill('CONT', boresight.pid)
  end
end
