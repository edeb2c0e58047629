# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: the controller executed again on recorded inputs says the same, bit for bit; a changed recording
# is refused with the place of the change.

require 'digest'
require_relative '../support/system_test'

class TestReplay < SystemTest
  PLACES = 50
  HEADER = 256
  PREFIX = 64
  CHUNK = 1024

  # Stops and returns the recording.
  def end_recording
    Process.kill('TERM', boresight.pid)
    boresight.wait_for_end
    boresight.recording_files.last
  end

  def flip(file, offset)
    File.open(file, 'r+b') do |io|
      io.seek(offset)
      byte = io.readbyte
      io.seek(offset)
      io.write((byte ^ 0x20).chr)
    end
  end

  # Changes the first block's number of records, with right checksum and hash, and cuts the file after it.
  def announce_one_record_more(file)
    bytes = File.binread(file)
    compressed = bytes[HEADER + 20, 4].unpack1('V')
    rest = bytes[HEADER + PREFIX, (compressed.fdiv(CHUNK).ceil * 4) + compressed]
    fields = bytes[HEADER, 28]
    fields[12, 4] = [fields[12, 4].unpack1('V') + 1].pack('V')
    File.binwrite(file, bytes[0, HEADER] + sealed(bytes[HEADER - 32, 32], fields, rest))
  end

  def assert_rigid(matrix)
    assert_equal 16, matrix.size
    assert_equal [0, 0, 0, 1], matrix[12, 4]
    matrix.each_slice(4).first(3).each { |row| assert_in_delta 1.0, row.first(3).sum { |entry| entry * entry }, 1e-6 }
  end

  def test_SWR_REPLAY_001_a_homing_is_replayed_and_every_output_is_equal
    boresight(arguments: Boresight::FAST).home
    assert_rigid boresight.targeting.fetch('zframe_treatment')
    text, code = replay(end_recording)
    assert_equal 0, code, text
    cycles = text[/^(\d+) of \1 cycles replayed, every output equal$/, 1].to_i
    assert_operator cycles, :>, 3000
    puts "SWR-REPLAY-001: #{cycles} cycles of a homing replayed"
  end

  # One hash for each row: column => value.
  def table_of(file)
    text, status = Open3.capture2e(Boresight.program('boresight-replay'), '--table', file)
    assert_equal 0, status.exitstatus, text
    names, *rows = text.lines(chomp: true).map { |line| line.split(',') }
    rows.map { |row| names.zip(row.map(&:to_f)).to_h }
  end

  # Data of the board, one hash for each cycle.
  def board_of(file)
    text, status = Open3.capture2e(Boresight.program('boresight-replay'), '--board', file)
    assert_equal 0, status.exitstatus, text
    names, *rows = text.lines(chomp: true).map { |line| line.split(',', -1) }
    rows.map { |row| names.zip(row).to_h }
  end

  # So many that in each cycle one of them is: a slow axis is driven by pulses.
  def wait_for_drive
    boresight.wait_until('three axes are driven') { boresight.motors['axes'].count { |axis| axis['is_driven'] } >= 3 }
  end

  # A homing that is stopped by the pedal, goes on, and is stopped by the e-stop.
  def stopped_twice
    boresight.press_and_command('START_UP')
    wait_for_drive
    boresight.simctl('pedal', 'release')
    boresight.wait_until('the pedal is seen released') { boresight.status['pedal'] == 'released' }
    boresight.simctl('pedal', 'press')
    wait_for_drive
    boresight.simctl('estop', 'pull')
    boresight.wait_until('the e-stop is seen pulled') { boresight.log.any? { |event| event['name'] == 'ESTOP_PULLED' } }
    board_of(end_recording)
  end

  # Elastic time stands still in a cycle: what begins at the time of its sample leaves in it.
  def assert_zero_in_the_cycle(rows, input)
    at = (1...rows.size).find { |i| rows[i - 1]['frames_drive'] != '0' && !rows[i]['high'].split.include?(input) }
    refute_nil at, "no cycle was driven just before #{input} opened"
    seen, following, after = rows[at, 3]
    assert_equal '0', seen['frames_drive']
    assert_equal seen['sampled_us'], following['started_us']
    refute_equal '0', following['cards_drive'], 'the cards say what they did before they heard it'
    assert_equal '0', after['cards_drive']
  end

  def test_SWR_CTRL_013_zero_words_leave_in_the_cycle_that_sees_pedal_or_e_stop_open
    rows = stopped_twice
    assert_zero_in_the_cycle(rows, 'pedal_a')
    assert_zero_in_the_cycle(rows, 'estop_chain')
  end

  def test_SWR_REPLAY_009_what_the_board_said_is_printed_for_each_cycle
    boresight.wait_until('cycles have passed') { boresight.status['cycle'] > 50 }
    boresight.simctl('card', 'yaw', 'silent')
    boresight.wait_until('the card is lost') { boresight.log.any? { |event| event['name'] == 'CARD_LOST' } }
    rows = board_of(end_recording)
    assert_equal (0...rows.size).to_a, rows.map { |row| row['cycle'].to_i }
    assert_equal '----------', rows.first['results'], 'nothing was begun before the first cycle'
    assert_match(/\A-o{7}-.\z/, rows[20]['results'])
    assert_match(/\A[-n]oooonoo[-n]{2}\z/, rows.last['results'], 'an empty slot is asked now and then')
    assert_equal ['', '0'], rows.last.values_at('not_read', 'error')
    rows.each_cons(2) { |before, row| assert_equal 1000, row['sampled_us'].to_i - before['sampled_us'].to_i }
  end

  def test_SWR_REPLAY_003_the_table_has_motion_control_output_and_reasons
    boresight.press_and_command('START_UP')
    boresight.wait_until('an axis is driven') { boresight.moving? }
    begun = boresight.status['cycle']
    boresight.wait_until('it has gone some way') { boresight.status['cycle'] > begun + 500 }
    boresight.simctl('pedal', 'release')
    boresight.wait_until('the pedal is seen released') { boresight.status['pedal'] == 'released' }
    rows = table_of(end_recording)
    %w[setpoint_ticks position_ticks setpoint_ticks_per_s ticks_per_s output_percent permit_reasons].each do |column|
      assert rows.first.key?("insertion_#{column}"), column
    end
    driven, still = rows.partition { |row| row['insertion_output_percent'] != 0.0 }
    assert(driven.any? && driven.all? { |row| row['insertion_permit_reasons'].zero? })
    assert(driven.all? { |row| row['insertion_output_percent'].between?(-100.0, 100.0) })
    assert(still.any? { |row| row['insertion_permit_reasons'].to_i[11] == 1 }, 'the pedal is a reason')
  end

  def test_SWR_CHECK_005_the_interval_of_each_cycle_is_reported
    boresight.wait_until('something is recorded') { boresight.status['cycle'] > 500 }
    text, code = replay('--loop', end_recording)
    assert_equal 0, code, text
    names, *rows = text.lines(chomp: true).map { |line| line.split(',') }
    assert_equal %w[time_s interval_us longest_stage], names
    assert_operator rows.size, :>, 500
    rows.each_cons(2) { |one, other| assert_in_delta 0.001, other[0].to_f - one[0].to_f, 1e-9 }
    assert(rows.all? { |row| row[1] == '1000' }, 'elastic time is even')
    assert_empty rows.map(&:last).uniq - %w[WAKE CARDS STEP PUBLISH]
  end

  def test_SWR_EVENT_007_the_events_of_a_recording_say_their_causes
    boresight.simctl('estop', 'pull')
    boresight.wait_until('the e-stop is seen') { boresight.status['estop'] == 'pulled' }
    text, code = replay('--events', end_recording)
    assert_equal 0, code, text
    assert_match(/ CRITICAL ESTOP_PULLED The e-stop was pulled\.$/, text)
    assert_match(/ INFORMATION WORKPHASE Workphase entered EMERGENCY\. By the e-stop\.$/, text)
  end

  def test_SWR_REPLAY_001_a_robot_that_this_build_does_not_have_is_refused_by_its_name
    boresight.wait_until('something is recorded') { boresight.status['cycle'] > 500 }
    file = end_recording
    change_header(file) { |header| header[80, 16] = 'scara'.ljust(16, "\0") }
    text, code = replay(file)
    assert_equal 2, code
    assert_match(/^Recorded with robot scara, this build has .*neuro.*; replay it with the build that recorded it, "/, text)
  end

  # Nothing but a header, changed, with a right hash.
  def change_header(file)
    header = File.binread(file, HEADER)
    yield header
    header[224, 32] = Digest::SHA256.digest(header[0, 224])
    File.binwrite(file, header)
  end

  def test_SWR_REPLAY_008_a_name_that_gives_orders_to_the_terminal_is_escaped
    boresight.wait_until('something is recorded') { boresight.status['cycle'] > 500 }
    file = end_recording
    change_header(file) do |header|
      header[80, 16] = "\e[2J\n".ljust(16, "\0")
      header[16, 64] = "\a\"x".ljust(64, "\0")
    end
    text, code = replay(file)
    assert_equal 2, code
    assert_includes text, 'Recorded with robot \x1B[2J\x0A, this build has '
    assert_includes text, 'recorded it, "\x07\x22x".'
    refute_match(/[^[:print:]\n]/, text)
  end

  def test_SWR_REPLAY_006_another_layout_of_the_same_sizes_is_refused_by_both_numbers
    boresight.wait_until('something is recorded') { boresight.status['cycle'] > 500 }
    file = end_recording
    own = nil
    change_header(file) do |header|
      own = header[120, 8].unpack1('Q<')
      header[120, 8] = [own ^ 1].pack('Q<')
    end
    text, code = replay(file)
    assert_equal 2, code
    assert_includes text, format('Recorded with layout %016X, ', own ^ 1)
    assert_includes text, format('this build has %016X, ', own)
  end

  def test_SWR_REPLAY_006_frames_of_another_layout_are_refused_by_both_numbers
    boresight.wait_until('something is recorded') { boresight.status['cycle'] > 500 }
    file = end_recording
    own = nil
    change_header(file) do |header|
      own = header[128, 4].unpack1('V')
      header[128, 4] = [own ^ 1].pack('V')
    end
    text, code = replay(file)
    assert_equal 2, code
    assert_includes text, format('frames of another layout, %08X, this build has %08X; ', own ^ 1, own)
  end

  def test_SWR_REPLAY_001_another_robot_is_refused_by_both_crcs
    boresight.wait_until('something is recorded') { boresight.status['cycle'] > 500 }
    file = end_recording
    header = File.binread(file, 256)
    header[96, 4] = [0x0BADF00D].pack('V')
    header[224, 32] = Digest::SHA256.digest(header[0, 224])
    File.binwrite(file, header, 0)
    text, code = replay(file)
    assert_equal 2, code
    # The changed hash of the header no longer fits the first block, which is found first.
    assert_match(/Block 0, bytes \d+\.\.\d+/, text)
    File.truncate(file, 256)
    text, code = replay(file)
    assert_equal 2, code
    assert_match(/robot neuro of CRC 0BADF00D, this build has neuro of CRC \h{8}/, text)
  end

  def test_SWR_REPLAY_002_a_byte_flipped_at_fifty_places_is_reported_with_its_place
    boresight.wait_until('something is recorded') { boresight.status['cycle'] > 2000 }
    file = end_recording
    size = File.size(file)
    Array.new(PLACES) { |i| (i * (size - 1)) / (PLACES - 1) }.each do |offset|
      flip(file, offset)
      text, code = replay(file)
      assert_equal 2, code, text
      first, last = text.match(/bytes (\d+)\.\.(\d+)/).captures.map(&:to_i)
      assert_includes (first..last), offset, text
      flip(file, offset)
    end
    assert_equal 0, replay(file).last
  end

  def test_SWR_REPLAY_001_a_recording_cut_short_is_replayed_and_said_to_be_cut
    boresight(arguments: Boresight::FAST)
    boresight.wait_until('something is recorded') { boresight.status['cycle'] > 3000 }
    file = end_recording
    File.truncate(file, File.size(file) - 100)
    text, code = replay(file)
    assert_equal 3, code, text
    cycles = text[/^(\d+) of at least \d+ cycles replayed, their outputs equal; this is not the whole run$/, 1].to_i
    assert_operator cycles, :>, 1000
    assert_includes text, "The recording is cut short: only the #{cycles} cycles before the cut were replayed."
  end

  def test_SWR_REPLAY_002_a_block_that_does_not_hold_what_it_announces_is_refused
    boresight.wait_until('something is recorded') { boresight.status['cycle'] > 1000 }
    file = end_recording
    announce_one_record_more(file)
    text, code = replay(file)
    assert_equal 2, code, text
    announced, read = text.match(/announce (\d+) records, (\d+) could be read/).captures.map(&:to_i)
    assert_equal read + 1, announced
  end

  def test_SWR_REPLAY_002_a_missing_file_is_named
    text, code = replay('/tmp/no-such-recording.bsr')
    assert_equal 2, code
    assert_includes text, '/tmp/no-such-recording.bsr'
  end
end
