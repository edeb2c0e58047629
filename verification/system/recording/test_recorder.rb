# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: every cycle that control published is in a file, or its loss is.

require_relative '../support/system_test'

class TestRecorder < SystemTest
  BUILD = (16...80)
  ROBOT = (80...96)
  ROBOT_CRC = (96...100)

  # Runs until `cycles` cycles are published; returns the recordings, kept after the end.
  def record(cycles)
    boresight.wait_until("#{cycles} cycles have run") { boresight.status['cycle'] >= cycles }
    yield if block_given?
    last = boresight.status['cycle']
    Process.kill('TERM', boresight.pid)
    boresight.wait_for_end
    last
  end

  # The cycles replayed, all equal, and what the replay said; 3 is the exit code of a recording cut short.
  def replayed(file, *codes)
    text, code = replay(file)
    assert_includes codes, code, text
    [text[/^(\d+) of (?:at least )?\d+ cycles replayed, (?:every output|their outputs) equal/, 1].to_i, text]
  end

  def test_SWR_REC_001_every_cycle_from_the_first_to_the_last_is_recorded
    boresight(arguments: Boresight::FAST)
    last = record(3000)
    cycles, text = replayed(boresight.recording_files.fetch(0), 0)
    assert_equal 1, boresight.recording_files.size
    assert_operator cycles, :>, last
    assert_includes text, "#{cycles} of #{cycles} cycles replayed, every output equal"
    refute_match(/follow no checkpoint|lost/, text + boresight.output)
  end

  def test_SWR_REC_001_every_event_is_a_line_of_the_log
    expected = []
    record(2000) do
      boresight.simctl('pedal', 'press')
      boresight.wait_until('the pedal is seen pressed') { boresight.status['pedal'] == 'pressed' }
      boresight.simctl('pedal', 'release')
      boresight.wait_until('the pedal is in the log') do
        (expected = boresight.log).any? { |event| event['name'] == 'PEDAL_RELEASED' }
      end
    end
    lines = boresight.event_lines
    assert_equal (0...lines.size).to_a, lines.map { |line| line.split[1].to_i }
    expected.each do |event|
      assert_match(/ #{event['number']} cycle=#{event['cycle']} #{event['severity']} #{event['name']} /,
                   lines[event['number']])
    end
  end

  def test_SWR_REC_023_after_a_kill_every_cycle_is_in_the_first_file_or_the_second
    last = record(2000) do
      boresight.kill('recorder', 'KILL')
      boresight.wait_until('there is a second recording') { boresight.recording_files.size == 2 }
      first = boresight.status['cycle']
      boresight.wait_until('a second has passed') { boresight.status['cycle'] > first + 1500 }
      assert_equal 0, boresight.status['counts']['cycles_lost']
    end
    texts = boresight.recording_files.map { |file| replayed(file, 0, 3).last }
    assert_match(/Cut short/, texts[0])
    refute_match(/Cut short/, texts[1])
    refute_match(/lost/, texts.join + boresight.output)
    cycles, text = replayed(boresight.recordings, 0)
    assert_match(/^#{cycles} of #{cycles} cycles replayed, every output equal$/, text)
    assert_operator cycles, :>, last
  end

  def test_SWR_REC_030_SWR_REC_031_a_recorder_that_is_started_again_goes_on_with_the_run_to_its_end
    last = record(1000) do
      boresight.kill('recorder', 'KILL')
      boresight.wait_until('there is a second recording') { boresight.recording_files.size == 2 }
    end
    text, code = replay(boresight.recordings)
    run, final = text.match(/^Run (\S+): cycles 0 to (\d+), its last, in 2 recordings\.$/)&.captures
    assert_operator final.to_i, :>=, last, text
    boresight.recording_files.each { |file| assert_includes replay(file).first, "Run #{run}: " }
    assert_includes text, 'every output equal'
    assert_equal 0, code, text
  end

  def test_SWR_REC_031_a_run_whose_control_was_killed_has_no_end
    boresight.wait_until('1000 cycles have run') { boresight.status['cycle'] >= 1000 }
    boresight.kill('control', 'KILL')
    boresight.wait_for_end
    text, code = replay(boresight.recordings)
    assert_match(/^The end of the run is missing/, text)
    refute_match(/every output equal/, text)
    assert_equal 3, code, text
  end

  # It is held while cycles come, and asked to end before it has written them.
  def test_SWR_SUP_013_a_recorder_that_is_behind_writes_the_whole_run_before_it_ends
    record(1000) do
      boresight.kill('recorder', 'STOP')
      behind = boresight.status['cycle'] + 4000
      boresight.wait_until('4000 cycles wait for the recorder') { boresight.status['cycle'] > behind }
    end
    text, code = replay(boresight.recordings)
    assert_match(/^(\d+) of \1 cycles replayed, every output equal$/, text)
    assert_equal 0, code, text
  end

  def test_SWR_SUP_013_what_waits_for_a_recorder_at_the_end_is_recorded
    last = record(500) do
      boresight.kill('recorder', 'STOP')
      first = boresight.status['cycle']
      boresight.wait_until('cycles wait for it') { boresight.status['cycle'] > first + 2500 }
    end
    cycles, text = replayed(boresight.recording_files.fetch(0), 0)
    assert_operator cycles, :>, last
    refute_match(/follow no checkpoint|lost|cut short/i, text + boresight.output)
  end

  # It is held again each time that the supervisor lets it go on, for a second after control has ended.
  def hold_at_the_end(pid)
    ended = nil
    until ended && Boresight.now > ended + 1
      Process.kill('STOP', pid)
      ended ||= Boresight.now unless boresight.pids.key?('control')
    end
  end

  def test_SWR_SUP_013_a_recorder_that_stands_still_for_a_second_writes_the_whole_run_before_it_ends
    boresight(arguments: Boresight::FAST)
    pid = boresight.pid_of('recorder')
    boresight.wait_until('1000 cycles have passed') { boresight.status['cycle'] > 1000 }
    Process.kill('TERM', boresight.pid)
    hold_at_the_end(pid)
    boresight.let_go(pid)
    boresight.wait_for_end
    assert_match(/^(\d+) of \1 cycles replayed, every output equal$/, replay(boresight.recordings).first)
  end

  # No file of the recorder may become larger, as on a full disk.
  def limit_files(bytes)
    skip 'prlimit is missing' unless system('command -v prlimit > /dev/null')
    assert system('prlimit', '--pid', boresight.pid_of('recorder').to_s, "--fsize=#{bytes}:unlimited")
  end

  def expect_failing
    boresight.wait_until('control knows it') { boresight.status['is_recorder_failing'] }
    boresight.wait_until('cycles are counted') { boresight.status['counts']['unrecorded'].positive? }
    assert_equal 'NO_BLACK_BOX', boresight.status['next_step']['name']
    boresight.wait_until('it is in the status line') { boresight.output.include?('NOT RECORDED, recorder CANNOT WRITE') }
  end

  # The length of the gap, as the log has it.
  def expect_recording_again
    boresight.wait_until('recording goes on') { boresight.status['counts']['unrecorded'].zero? }
    refute boresight.status['is_recorder_failing']
    events = boresight.log.select { |event| event['name'].start_with?('RECORDING_') }
    assert_equal %w[RECORDING_STOPPED RECORDING_RESUMED], events.map { |event| event['name'] }
    assert_includes events[0]['text'], 'is not writing them'
    lost = events[1]['value']
    boresight.wait_until('the figures have it') { boresight.status['counts']['cycles_lost'] == lost }
    first = boresight.status['cycle']
    boresight.wait_until('a second has passed') { boresight.status['cycle'] > first + 1000 }
    lost
  end

  # All of the run but one gap of that length.
  def expect_one_gap(lost)
    text, code = replay(boresight.recordings)
    assert_equal 3, code, text
    first, last = text[/cycles? (\d+ to \d+) are missing/i, 1].to_s.split(' to ').map(&:to_i)
    assert_equal lost, last.to_i - first.to_i + 1, text
  end

  def test_SWR_REC_032_SWR_REC_033_SWR_NEXT_028_a_full_disk_is_reported_at_once_and_costs_what_is_reported_alone
    lost = 0
    record(500) do
      limit_files(File.size(boresight.recording_files.last) + 1000)
      expect_failing
      limit_files('unlimited')
      lost = expect_recording_again
    end
    assert_equal 1, boresight.output.scan('nothing can be recorded').size
    expect_one_gap(lost)
    texts = boresight.recording_files.map { |file| replay(file) }
    # One that was begun on the full disk goes on with the cycles of the one before, and may end before its first checkpoint.
    bare, others = texts.partition { |text, _| text.include?('There is nothing to replay: no cycle follows a checkpoint.') }
    assert_operator bare.size, :<=, 1, texts.join
    others.each { |text, code| assert_includes [0, 3], code, text }
  end

  # SWR-LINK-040: they are counted by their reason.
  def test_SWR_REC_053_what_control_discards_of_a_card_stands_in_the_log
    record(1000) do
      boresight.simctl('card', '3', 'corrupt')
      boresight.wait_until('the card is lost') { boresight.event_lines.any? { |line| line.include?(' CARD_LOST subject=3') } }
    end
    counts = boresight.log_lines.grep(/ CARD_COUNTS value=3 /)
    assert_match(/ Frames of card 3: [1-9]\d* damaged, \d+ out of order, \d+ missed\. Commands to it: /, counts.last)
  end

  def test_SWR_REC_054_a_healthy_start_writes_no_counts_of_commands_to_cards
    record(500) { nil }
    assert_empty boresight.log_lines.grep(/ CARD_COUNTS .* 0 damaged, 0 out of order, 0 missed\./)
  end

  def test_SWR_SUP_300_no_status_line_calls_a_recorder_ok_that_cannot_write
    record(500) do
      limit_files(File.size(boresight.recording_files.last) + 1000)
      expect_failing
    end
    lines = boresight.output.lines.grep(/recorder CANNOT WRITE/)
    refute_empty lines
    lines.each { |line| refute_match(/recorder.* ok$/, line.split(' | ').last) }
  end

  def test_SWR_REC_040_a_run_that_ends_on_a_full_disk_says_how_many_cycles_are_in_no_recording
    last = record(500) do
      # The log has room for what it says of that.
      limit_files([boresight.recording_files.last, boresight.log_files.last].map { |file| File.size(file) }.max + 8000)
      expect_failing
    end
    lost = boresight.output[/^recorder: the last (\d+) cycles of the run are in no recording\.$/, 1].to_i
    assert_includes boresight.event_lines.last, "CYCLES_UNRECORDED value=#{lost} "
    cycles, text = replayed(boresight.recordings, 3)
    assert_match(/^The end of the run is missing/, text)
    assert_operator lost, :>, 500
    assert_operator cycles + lost, :>=, last
  end

  def test_SWR_REC_032_SWR_REC_033_a_folder_that_a_file_has_replaced_is_reported_with_all_that_was_in_it
    lost = 0
    record(500) do
      File.rename(boresight.recordings, "#{boresight.recordings}.old")
      File.write(boresight.recordings, '')
      FileUtils.rm_r("#{boresight.recordings}.old")
      expect_failing
      File.delete(boresight.recordings)
      lost = expect_recording_again
    end
    texts = boresight.recording_files.map { |file| replayed(file, 0, 3).last }
    assert_equal lost, texts.sum { |text| text[/^(\d+) cycles before this file were lost\.$/, 1].to_i }, texts.join
  end

  def test_SWR_REC_007_a_recorder_that_is_started_again_goes_on_with_the_next_number
    record(500) do
      boresight.kill('recorder', 'KILL')
      boresight.wait_until('there is a second recording') { boresight.recording_files.size == 2 }
    end
    numbers = boresight.recording_files.map { |file| File.basename(file)[/\Ablackbox-(\d{6})-\d{8}T\d{6}Z\.bsr\z/, 1] }
    assert_equal %w[000001 000002], numbers
  end

  def test_SWR_REC_003_the_recording_names_the_build_and_the_robot
    build = boresight.status['build_id']
    record(500)
    header = File.binread(boresight.recording_files.first, 256)
    robot = File.binread(File.expand_path('../../../core/robot/neuro/robot.yml', __dir__))
    assert_equal build, header[BUILD].delete("\0")
    assert_equal 'neuro', header[ROBOT].delete("\0")
    assert_equal crc32c(robot), header[ROBOT_CRC].unpack1('V')
  end
end
