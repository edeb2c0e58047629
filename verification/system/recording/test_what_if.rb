# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: the replay says in words what the controller would have done if one of its inputs had been another.

require_relative '../support/stopped_homing'

class TestWhatIf < StoppedHoming
  # A cycle whose frames drive an axis, half a second after the first such; the pedal is pressed before and after.
  def driven
    @@driven ||= begin
      names, *rows = printed('--board').lines(chomp: true).map { |line| line.split(',', -1) }
      cycles = rows.map { |row| names.zip(row).to_h }.reject { |row| row['frames_drive'] == '0' }.map { |row| row['cycle'].to_i }
      cycles.find { |cycle| cycle >= cycles.first + 500 }
    end
  end

  def what_if(cycles, *changes)
    printed('--what-if', cycles.to_s, *changes).lines(chomp: true)
  end

  # Lines about one cycle.
  def of_cycle(lines, cycle)
    lines.filter_map { |line| line[/\ACycle #{cycle} \(\d+\.\d{3} s\): (.*)/, 1] }
  end

  def test_SWR_REPLAY_013_a_pedal_that_opens_is_said_with_state_reason_axis_event_and_what_leaves_to_the_cards
    lines = what_if(driven, 'pedal_a=0')
    assert_match(/\ACycle #{driven} /, lines.first)
    said = of_cycle(lines, driven)
    assert_includes said, 'state pedal is opening, was pressed.'
    %w[head feet lateral insertion rotation pitch yaw].each do |axis|
      assert_includes said, "axes/#{axis} permit_reasons is PEDAL_RELEASED, was none."
    end
    assert_includes said, 'event PEDAL_RELEASED: The pedal gate closed. By the pedal.'
    drives = said.grep(/\Ato card/)
    refute_empty drives
    assert(drives.all? { |line| line.match?(/\Ato card \d \(\w+\) leaves drive OFF \(word 0, direction 0\), was [A-Z]+/) })
    assert_match(/\A(\d+) of \1 cycles differ\. What the cards report is as it was recorded: nothing answered/, lines.last)
  end

  def test_SWR_REPLAY_013_an_input_is_another_in_the_named_cycles_only
    lines = what_if("#{driven}-#{driven + 2}", 'pedal_a=0', 'pedal_b=0')
    assert_includes of_cycle(lines, driven), 'state pedal is released, was pressed.'
    assert_includes of_cycle(lines, driven + 3), 'event PEDAL_PRESSED: The pedal gate opened. By the pedal.'
  end

  def test_SWR_REPLAY_013_an_emergency_is_said_by_its_workphase
    said = of_cycle(what_if("#{driven}-#{driven}", 'estop_open=1'), driven)
    assert_includes said, 'state workphase is EMERGENCY, was START_UP.'
    assert_includes said, 'event WORKPHASE: Workphase entered EMERGENCY. By the e-stop.'
  end

  def test_SWR_REPLAY_013_a_difference_in_nothing_but_numbers_is_said_by_them
    lines = what_if("#{driven}-#{driven}", 'elapsed_us=1001')
    now, was = of_cycle(lines, driven).first.match(/\Astate time_us is (\d+), was (\d+)\.\z/).captures.map(&:to_i)
    assert_equal was + 1, now
  end

  def test_SWR_REPLAY_013_what_was_so_anyway_makes_no_difference
    assert_equal ['Nothing differs in '], what_if("#{driven}-#{driven + 1}", 'pedal_a=1').map { |line| line[/\A\D+/] }
  end

  def test_SWR_REPLAY_013_cycles_that_are_not_there_are_refused
    text, code = in_file { |file| replay('--what-if', '4000000', 'pedal_a=0', file) }
    assert_equal [2, "No cycle of this recording is changed: it has none of them, or none before them has the state.\n"],
                 [code, text]
  end

  def test_SWR_REPLAY_014_an_input_that_is_none_is_refused_by_its_name_with_the_list_of_them
    text, code = replay('--what-if', '10', 'pedal_c=0', 'any')
    assert_equal 2, code
    assert_includes text, '"pedal_c=0" changes no input; give INPUT=VALUE, with one of elapsed_us, '
    assert_includes text, 'pedal_a, pedal_b, estop_open, scanner_active, '
  end

  {
    %w[10 pedal_a=2 any] => '"pedal_a=2" is no value of it; give a number from 0 to 1.',
    %w[10 pedal_a= any] => '"pedal_a=" is no value of it; give a number from 0 to 1.',
    %w[10 frames_received=0x400 any] => '"frames_received=0x400" is no value of it; give a number from 0 to 1023.',
    %w[10- pedal_a=0 any] => '"10-" is no CYCLE and no CYCLE-CYCLE.',
    %w[10-9 pedal_a=0 any] => '"10-9" is no CYCLE and no CYCLE-CYCLE.',
    %w[10 any] => '--what-if lacks INPUT=VALUE.',
    ['10', *['pedal_a=0'] * 16, 'any'] => 'any cannot be read'
  }.each do |words, sentence|
    define_method("test_SWR_REPLAY_014_#{words.first(2).join('_').gsub(/\W/, '_')}_of_#{words.size}_is_answered") do
      text, code = replay('--what-if', *words)
      assert_equal 2, code
      assert_includes text, sentence
    end
  end
end
