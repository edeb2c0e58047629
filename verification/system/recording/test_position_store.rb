# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: within one power-on of the box the positions live over a restart of the programs, unless the counts
# speak against them.

require_relative '../support/lone_box'
require_relative '../support/system_test'

class TestPositionStore < SystemTest
  include LoneBox

  # The file of the position store, see app/positions/position_store.h.
  SLOT = 4096
  RECORD = 120
  NUMBER = (8...16)
  GRADES = 32
  AXIS = 12
  KNOWN = 2

  # The programs on that box, and what they say of themselves after the block.
  def programs
    @boresight = Boresight.start(box: @box, recordings: @directory, arguments: ['--robot', ROBOT])
    yield @boresight if block_given?
    @boresight
  end

  def home
    programs(&:home_fast)
    wait_until('every position is kept') { kept_grades.uniq == [KNOWN] }
    axes
  end

  # Kept grades of the newer one of the two records.
  def kept_grades
    bytes = File.binread(store)
    records = [0, SLOT].filter_map { |slot| bytes[slot, RECORD] }.select { |record| record.bytesize == RECORD }
    newest = records.max_by { |record| record[NUMBER].unpack1('Q<') }
    Array.new(axes.size) { |axis| newest[GRADES + (AXIS * axis), 4].unpack1('V') }
  end

  def home_and_stop
    shown = home
    assert_equal 0, @boresight.stop
    shown
  end

  def axes
    @boresight.motors['axes']
  end

  def references
    axes.map { |axis| axis['reference'] }.uniq
  end

  # Where the axes are shown to stand, to compare with where they were.
  def positions(axes)
    axes.map { |axis| axis.values_at('name', 'position_ticks') }
  end

  def events(name)
    @boresight.log.select { |event| event['name'] == name }
  end

  def store
    File.join(@directory, "positions-#{@box}")
  end

  def test_SWR_STORE_008_a_box_that_runs_already_is_used_and_left_running
    programs { |one| refute_includes one.pids.keys, 'box' }
    wait_until('the status is printed') { @boresight.output.include?('box not ours') }
    assert_equal 0, @boresight.stop
    answer, status = Open3.capture2e(Boresight.program('boresight-simctl'), '--box', @box, 'show')
    assert status.success?, answer
  end

  def test_SWR_STORE_008_wrong_boxes_are_refused
    { %w[--box a/b] => [2, %r{"a/b" is no name for --box}], %w[--box b --slow 2] => [2, /--slow is of no use with --box/],
      %w[--box b --real-time] => [2, /--real-time is of no use with --box/],
      %w[--box nobody] => [3, /start the simulated control box first: boresight-box --box nobody/] }.each do |words, end_|
      one = Boresight.new(arguments: words)
      one.launch
      assert_equal end_[0], one.wait_for_end, one.output
      assert_match end_[1], one.output
      one.kill_all
    end
  end

  def test_SWR_ROBOT_019_the_box_of_another_robot_is_refused
    other = Boresight.new(box: @box, arguments: %w[--robot neuro])
    other.launch
    assert_equal 3, other.wait_for_end
    assert_match(/the box "#{@box}" is not that of this robot neuro; start the box with --robot neuro/, other.output)
  end

  def test_SWR_STORE_008_a_box_in_use_is_refused_and_the_first_goes_on
    programs
    second = Boresight.new(box: @box, arguments: ['--robot', ROBOT])
    second.launch
    assert_equal 3, second.wait_for_end
    assert_match(/another process already uses the simulated control box/, second.output)
    assert @boresight.status
  end

  def test_SWR_STORE_005_positions_live_over_a_restart_as_unverified_until_the_operator_confirms_them
    before = home_and_stop
    programs
    wait_until('every axis is restored') { references == ['unverified'] }
    assert_equal positions(before), positions(axes)
    assert_equal before.size, events('AXIS_RESTORED').size
    refute @boresight.status['is_homed']
    @boresight.simctl('button', 'press')
    wait_until('every axis is verified') { references == ['verified'] }
  end

  def test_SWR_STORE_006_what_moved_after_control_was_killed_is_lost
    home
    @boresight.kill('control', 'KILL')
    assert_equal 4, @boresight.wait_for_end
    move('needle')
    programs
    wait_until('every axis is compared') { events('AXIS_RESTORED').size + events('AXIS_CONTRADICTED').size == axes.size }
    lost, kept = axes.partition { |axis| axis['reference'] == 'lost' }
    assert_equal(['needle'], lost.map { |axis| axis['name'] })
    assert_equal(['unverified'], kept.map { |axis| axis['reference'] }.uniq)
  end

  # A shorted driver, while no operator looks.
  def move(axis)
    simctl('motor', axis, 'runs')
    from = simctl('show')[/ #{axis} .*/]
    wait_until("#{axis} has moved") { (ticks(simctl('show'), axis) - ticks(from, axis)).abs > 1000 }
    simctl('motor', axis, 'normal')
  end

  def ticks(shown, axis)
    Integer(shown[/ #{axis} +\S+ \S+ +(\S+)/, 1].to_f)
  end

  def test_SWR_STORE_003_a_store_that_is_damaged_or_gone_is_said_and_every_axis_is_lost
    home_and_stop
    { 'damaged' => -> { File.write(store, 'rubbish') }, 'missing' => -> { File.delete(store) } }.each do |fault, happen|
      happen.call
      programs
      wait_until('every axis is lost') { references == ['lost'] }
      assert_match(/^control: the kept positions .* are #{fault}/, @boresight.output)
      @boresight.stop
    end
  end

  def test_SWR_STORE_004_after_another_power_on_of_the_box_every_axis_is_fresh
    home_and_stop
    switch_box_off
    switch_box_on
    programs
    assert_equal ['fresh'], references
    refute_match(/^control: the kept positions/, @boresight.output)
  end

  # A known limit, see requirements/known_limits.yml.
  def test_SWR_STORE_005_the_registration_is_not_kept_over_a_restart
    home
    @boresight.leave
    @boresight.client('phase CALIBRATION', 'registration 1 0 0 0  0 1 0 0  0 0 1 0', 'wait STATUS CALIBRATION')
    wait_until('a registration is accepted') { @boresight.targeting['registration'] }
    @boresight.stop
    programs
    wait_until('every axis is restored') { references == ['unverified'] }
    assert_nil @boresight.targeting['registration']
  end
end
