# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: in elastic time nothing is late because the machine paused, time never hurries, and a control that
# is stuck is noticed by the cards all the same. It waits for the recorder, once.

require_relative 'support/system_test'

class TestElasticTime < SystemTest
  TROUBLE = %w[OVERRUN LOOP_STOPPED CARD_LOST ORDER_DISCARDED ORDER_OVERDUE AXIS_STALLED AXIS_FOLLOWING_ERROR
               AXIS_WRONG_WAY AXIS_MOVED_OFF AXIS_NO_COUNTS AXIS_WRONG_SPEED AXIS_UNEVEN_COUNTS].freeze
  PAUSES = [*[0.003] * 20, *[0.03] * 10, 0.3, 1.0].freeze # Seconds.
  PROGRAMS = %w[control box].freeze

  def trouble
    boresight.log.map { |event| event['name'] } & TROUBLE
  end

  # Effect of a busy or paused machine on them: held together, at any moment; now one, now the other goes on first.
  def pause_machine(seconds, number)
    boresight.while_stopped(*PROGRAMS.rotate(number)) { sleep seconds }
  end

  def test_SWR_BOX_006_a_motion_outlives_the_pauses_of_the_machine
    boresight.press_and_command('START_UP')
    PAUSES.each_with_index { |seconds, number| pause_machine(seconds, number) }
    refute_equal 'none', boresight.status['order'], 'the pauses were not over before the motion'
    boresight.wait_for_homing
    assert boresight.status['is_homed']
    assert_empty trouble
    assert_equal 0, boresight.status['counts']['overruns']
  end

  def test_SWR_BOX_006_time_is_never_faster_than_it_should
    slowness = 4
    boresight(arguments: ['--slow', slowness.to_s])
    began = Boresight.now
    first = boresight.status['cycle']
    last = boresight.wait_until('some cycles have run') { boresight.status['cycle'].then { |now| now if now > first + 200 } }
    assert_operator (last - first) * 0.001 * slowness, :<=, Boresight.now - began + (0.002 * slowness)
  end

  # The fewest whose workflow is worth it; the machine decides whether it comes so far.
  SPEEDUP = 20

  def cycles_in(seconds)
    began = Boresight.now
    first = boresight.status['cycle']
    sleep seconds
    last = boresight.status['cycle']
    (last - first) / (Boresight.now - began)
  end

  # Other programs may hold it up for a while.
  def test_SWR_BOX_040_a_motion_in_fast_time_is_faster_and_is_recorded_without_a_gap
    boresight(arguments: ['--fast', SPEEDUP.to_s])
    boresight.home
    wait_until('time passes faster than that of the world') { cycles_in(0.5) > 1100 }
    assert_empty trouble
    assert_equal [0, 0], boresight.status['counts'].values_at('overruns', 'cycles_lost')
    Process.kill('TERM', boresight.pid)
    boresight.wait_for_end
    text, code = replay(boresight.recording_files.last)
    assert_equal 0, code, text
    assert_match(/^(\d+) of \1 cycles replayed, every output equal$/, text)
  end

  def test_SWR_BOX_040_fast_time_is_no_faster_than_requested
    boresight(arguments: %w[--fast 2])
    began = Boresight.now
    first = boresight.status['cycle']
    last = boresight.wait_until('some cycles have run') { boresight.status['cycle'].then { |now| now if now > first + 1000 } }
    assert_operator (last - first) * 0.001 / 2, :<=, Boresight.now - began + 0.001
  end

  def test_SWR_BOX_046_another_pace_is_given_and_none_beyond_the_speedup
    boresight(arguments: ['--fast', SPEEDUP.to_s])
    boresight.simctl('pace', '1')
    began = Boresight.now
    first = boresight.status['cycle']
    last = boresight.wait_until('some cycles have run') { boresight.status['cycle'].then { |now| now if now > first + 300 } }
    assert_operator (last - first) * 0.001, :<=, Boresight.now - began + 0.002
    text, status = Open3.capture2e(Boresight.program('boresight-simctl'), '--box', boresight.box, 'pace', (SPEEDUP + 1).to_s)
    assert_equal [2, "\"21\" is no pace of this box; give a number from 1 to 20, which --fast says\n"], [status.exitstatus, text]
  end

  # As the kernel reports it: 0 is SCHED_OTHER.
  def policy_of(program)
    File.read("/proc/#{boresight.pid_of(program)}/stat").split[40].to_i
  end

  def test_SWR_BOX_043_fast_time_leaves_other_programs_their_share
    boresight(arguments: ['--fast', SPEEDUP.to_s])
    assert_equal([0, 0], PROGRAMS.map { |program| policy_of(program) })
  end

  def test_SWR_BOX_044_the_speedup_is_reported
    boresight(arguments: ['--fast', SPEEDUP.to_s])
    assert_equal SPEEDUP, boresight.status.dig('time', 'speedup')
    wait_until('the status line says so') { boresight.output.match?(/\bfast time \d+ %/) }
    wait_until('it says how fast') { boresight.status.dig('time', 'speed_percent') > 110 }
  end

  def test_SWR_BOX_041_fast_time_with_another_pace_is_refused_with_the_reason
    [%w[--fast 2 --real-time], %w[--fast 2 --slow 2]].each do |words|
      refused = Boresight.new(arguments: words)
      refused.launch
      assert_equal 3, refused.wait_for_end
      assert_match(/--fast is of no use with --real-time, where .*, nor with --slow; give one of them\./, refused.output)
      refused.kill_all
    end
  end

  def test_SWR_BOX_007_the_cards_notice_a_control_that_is_stuck
    boresight.press_and_command('START_UP')
    wait_until('an axis is driven') { boresight.driven_axes.any? }
    boresight.while_stopped('control') do
      wait_until('every watchdog has tripped') { boresight.box_axes.all? { |words| words.last.to_i >= 1 } }
      assert_empty boresight.driven_axes
    end
    wait_until('control gives the motion up') { boresight.status['order'] == 'none' }
    assert_empty boresight.driven_axes
  end

  # Held until cycles are lost; the world stands still for a part of that, longer than the patience of the box.
  def lose_cycles
    boresight.while_stopped('recorder') do
      wait_until('cycles are lost') { boresight.status['counts']['unrecorded'].positive? }
      wait_until('it is in the status line') { boresight.output.match?(/\d+ cycles NOT RECORDED/) }
      first = boresight.status['cycle']
      wait_until('control waits no more') { boresight.status['cycle'] > first + 200 }
    end
    wait_until('recording goes on') { boresight.status['counts']['unrecorded'].zero? }
    boresight.status['cycle']
  end

  def gaps
    boresight.log.select { |event| event['name'] == 'RECORDING_RESUMED' }.map { |event| event['value'] }
  end

  # In fast time the lane is full long before a recorder that is held counts as hanging and is replaced.
  def test_SWR_REC_019_a_motion_outlives_a_recorder_that_is_held
    boresight(arguments: Boresight::FAST)
    boresight.press_and_command('START_UP')
    boresight.while_stopped('recorder') { sleep 1 }
    assert_equal 0, boresight.status['counts']['cycles_lost']
    resumed = lose_cycles
    boresight.wait_for_homing
    assert_empty trouble
    wait_until('a second has passed') { boresight.status['cycle'] > resumed + 1000 }
    wait_until('the figures have the gap') { [boresight.status['counts']['cycles_lost']] == gaps }
    expect_files_with_a_gap_of(*gaps)
  end

  def expect_files_with_a_gap_of(lost)
    Process.kill('TERM', boresight.pid)
    boresight.wait_for_end
    texts = boresight.recording_files.map { |file| replay(file) }
    assert_equal [0, 0], texts.map(&:last), texts.join
    assert_match(/^#{lost} cycles before this file were lost\.$/, texts[1].first)
    refute_match(/follow no checkpoint/, texts.join)
  end

  def test_SWR_BOX_006_the_recording_of_a_paused_motion_is_replayed
    boresight.press_and_command('START_UP')
    PAUSES.last(5).each_with_index { |seconds, number| pause_machine(seconds, number) }
    Process.kill('TERM', boresight.pid)
    boresight.wait_for_end
    text, code = replay(boresight.recording_files.last)
    assert_equal 0, code, text
  end
end
