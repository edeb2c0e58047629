# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: of a folder all of a run is replayed, and "every output equal" is said of nothing less; what is missing is
# named with both ends.

require 'securerandom'
require_relative '../../../tools/recorded_run'
require_relative '../support/recording_parts'
require_relative '../support/stopped_homing'

class TestReplayRun < StoppedHoming
  include RecordingParts

  OTHER_RUN = 1_700_000_000_000_042
  WHOLE = /^(\d+) of \1 cycles replayed, every output equal$/

  # Runs it whole, before any folder of this test is made.
  def setup
    recording
  end

  def header
    recording[0, HEADER]
  end

  def run_name
    @run_name ||= name_of(header[RUN, 8].unpack1('Q<'))
  end

  def name_of(run)
    Time.at(run / 1_000_000, run % 1_000_000, :usec).utc.strftime('%Y%m%dT%H%M%S.%6NZ')
  end

  def blocks
    @blocks ||= parts_of(recording)[0..-2]
  end

  # Cycles of the run.
  def cycles
    cycle_of(parts_of(recording).last) + 1
  end

  # Its blocks in three files; first cycle of each as well.
  def thirds
    third = blocks.size / 3
    parts = [blocks[0, third], blocks[third, third], blocks[(2 * third)..]]
    ends = parts.drop(1).map { |part| trailer(TRAILER, cycle_of(part.first) - 1) } + [trailer(RUN_END, cycles - 1)]
    [parts.zip(ends).map { |part, last| joined(header, [*part, last]) }, parts.map { |part| cycle_of(part.first) }]
  end

  # Yields a folder with such files, by what stands in their names.
  def in_folder(files)
    Dir.mktmpdir do |folder|
      files.each { |name, bytes| File.binwrite(File.join(folder, name), bytes) }
      yield folder
    end
  end

  def file_name(number)
    format('blackbox-%06d-20261124T114012Z.bsr', number)
  end

  def numbered(files, from = 1)
    files.each_with_index.to_h { |bytes, index| [file_name(from + index), bytes] }
  end

  def replay_folder(files, *words)
    in_folder(files) { |folder| replay(*words, folder).map { |said| said.is_a?(String) ? said.gsub("#{folder}/", '') : said } }
  end

  def assert_whole(said, code, files)
    assert_equal 0, code, said
    assert_equal cycles, said[WHOLE, 1].to_i, said
    assert_includes said, "Run #{run_name}: cycles 0 to #{cycles - 1}, its last, in #{files} recordings.\n"
  end

  def refute_whole(said, code)
    assert_equal 3, code, said
    refute_includes said, 'every output equal'
    assert_includes said, 'their outputs equal; this is not the whole run'
  end

  def test_SWR_REPLAY_030_three_recordings_of_a_run_are_replayed_in_the_order_of_their_cycles
    files, = thirds
    assert_whole(*replay_folder(numbered(files)), 3)
    assert_whole(*replay_folder(numbered(files.reverse)), 3)
    assert_whole(*replay_folder(files.zip(%w[c.bsr a.bsr b.bsr]).to_h { |bytes, file| [file, bytes] }), 3)
  end

  def test_SWR_REPLAY_030_what_is_printed_of_three_recordings_is_that_of_one
    files, = thirds
    %w[--table --events --loop --board].each do |option|
      said, code = replay_folder(numbered(files), option)
      assert_equal 0, code, said
      assert said == printed(option), option # A difference would be printed whole.
    end
  end

  def test_SWR_REPLAY_033_a_recording_that_is_missing_between_two_is_named_by_both_ends
    files, (_, from, to) = thirds
    said, code = replay_folder(numbered([files.first, files.last]))
    refute_whole(said, code)
    assert_includes said, "Cycles #{from} to #{to - 1} are missing (#{to - from}).\n"
    # Only a file after a checkpoint can be computed again: this one has been cut in the middle.
    assert_includes said, "Cycles #{to} to #{cycles - 1} follow no checkpoint and were not replayed (#{cycles - to}).\n"
    assert_includes said, "#{from} of #{cycles} cycles replayed, "
    %w[--table --loop].each do |option|
      reported, status = replay_folder(numbered([files.first, files.last]), option)
      assert_equal 3, status
      assert_includes reported, "Cycles #{from} to #{to - 1} are missing (#{to - from}).\n"
    end
  end

  def test_SWR_REPLAY_033_a_gap_in_a_recording_is_named_by_both_ends
    from, to = blocks[1, 2].map { |block| cycle_of(block) }
    bytes = joined(header, [*blocks.values_at(0), *blocks.drop(2), trailer(RUN_END, cycles - 1)])
    said, code = replay_folder(numbered([bytes]))
    refute_whole(said, code)
    assert_includes said, "Cycles #{from} to #{to - 1} are missing (#{to - from}).\n"
    alone, status = in_file(bytes) { |file| replay(file) }
    refute_whole(alone, status)
    assert_includes alone, "Cycles #{from} to #{to - 1} are missing (#{to - from}).\n"
  end

  def test_SWR_REPLAY_033_a_beginning_that_is_missing_is_named
    files, (_, second) = thirds
    said, code = replay_folder(numbered(files.drop(1), 2))
    assert_includes [2, 3], code, said # 2 where no checkpoint follows.
    assert_includes said, "Cycles 0 to #{second - 1} are missing (#{second}).\n"
    refute_includes said, 'every output equal'
  end

  def test_SWR_REPLAY_031_a_run_without_its_end_says_so
    files, (_, _, third) = thirds
    said, code = replay_folder(numbered(files.take(2)))
    refute_whole(said, code)
    assert_includes said, "The end of the run is missing; the last cycle is #{third - 1}.\n"
    assert_includes said, "#{third} of at least #{third} cycles replayed, "
  end

  def test_SWR_REPLAY_031_a_recording_that_is_all_of_a_run_says_so_alone
    said, code = in_file { |file| replay(file) }
    assert_equal 0, code, said
    assert_equal cycles, said[WHOLE, 1].to_i, said
    assert_includes said, "Run #{run_name}: cycles 0 to #{cycles - 1}, its last, in this recording.\n"
  end

  def test_SWR_REPLAY_032_a_recording_that_is_a_part_of_a_run_says_which_share_it_is
    files, (_, second) = thirds
    said, code = in_file(files.first) { |file| replay(file) }
    assert_equal 0, code, said # All that it has is equal.
    assert_includes said, "Run #{run_name}: cycles 0 to #{second - 1} in this recording.\n" \
                          "#{second} of at least #{second} cycles replayed, their outputs equal; this is not the whole run\n"
    refute_includes said, 'every output equal'
  end

  def test_SWR_REPLAY_030_of_two_runs_the_newest_is_replayed_or_the_one_that_is_named
    files, = thirds
    other = joined(changed_header(header, RUN, [OTHER_RUN].pack('Q<')), parts_of(recording))
    both = numbered(files).merge(file_name(4) => other)
    said, code = replay_folder(both)
    assert_equal 0, code, said
    assert_includes said, "Run #{name_of(OTHER_RUN)}: cycles 0 to #{cycles - 1}, its last, in 1 recording.\n"
    assert_includes said, "Other runs there, which --run NAME replays: #{run_name}.\n"
    assert_whole(*replay_folder(both, '--run', run_name[0, 10]), 3)
    said, code = replay_folder(both, '--run', '1999')
    assert_equal 2, code
    assert_match(/ holds no recording of run 1999\.\nThe runs there: #{name_of(OTHER_RUN)}, #{run_name}\.\n\z/, said)
  end

  def test_SWR_REPLAY_030_a_cycle_that_is_there_twice_counts_once
    files, = thirds
    said, code = replay_folder(numbered([files[0], files[0], *files.drop(1)]))
    assert_includes said, "#{cycles} of #{cycles} cycles replayed, "
    assert_whole(said, code, 4)
    reported, = replay_folder(numbered([files[0], files[0], *files.drop(1)]), '--loop')
    assert reported.sub(/^Cycles 0 to \d+ are there again in .*\n/, '') == printed('--loop'), 'a cycle is reported twice'
  end

  def test_SWR_REPLAY_034_what_is_no_recording_is_named_and_left_out
    files, = thirds
    with = numbered(files).merge('foreign.bsr' => 'a' * 1000, "evil\e.bsr" => '', 'none.bsr' => header, 'motion.csv' => 'a',
                                 'old.bsr' => changed_header(header, 8, [1].pack('V')))
    said, code = replay_folder(with)
    assert_whole(said, code, 3)
    assert_includes said, "foreign.bsr is left out: it is no recording, or its header was changed or damaged.\n"
    assert_includes said, "evil\\x1B.bsr is left out: it is no recording, or its header was changed or damaged.\n"
    assert_includes said, "none.bsr is left out: it holds no cycle.\n"
    assert_includes said, "old.bsr is left out: it is of another version of the format.\n"
    refute_includes said, 'motion.csv'
  end

  # The block with the first checkpoint, as if it were of `cycle`.
  def moved(cycle)
    fields, rest = blocks.first
    fields = fields.dup
    fields[8, 4] = [cycle].pack('V')
    [fields, rest]
  end

  def forged(cycle)
    joined(header, [moved(cycle), trailer(TRAILER, cycle)])
  end

  def test_SWR_REPLAY_037_a_recording_of_another_state_that_fills_a_gap_is_named_with_the_words
    files, (_, second) = thirds
    files[1] = forged(second)
    said, code = replay_folder(numbered(files))
    assert_equal 1, code, said
    assert_match(/^#{file_name(2)}: The checkpoint before cycle #{second} is another state than was computed, in \d+ of \d+ words: /, said)
    refute_includes said, 'every output equal'
    assert_equal 1, replay_folder(numbered(files), '--table').last
  end

  def test_SWR_REPLAY_037_what_follows_a_forged_recording_after_a_gap_is_compared_with_its_state
    files, (_, second) = thirds
    files[1] = joined(header, [moved(second + 1), trailer(TRAILER, second + 1)])
    said, code = replay_folder(numbered(files))
    assert_includes said, "Cycles #{second} to #{second} are missing (1).\n"
    assert_equal 3, code, said
    next_block = forged(second + 1 + cycle_of(blocks[1]))
    reported, status = replay_folder(numbered([*files[0, 2], next_block]))
    assert_equal 1, status, reported
    assert_match(/^#{file_name(3)}: The checkpoint before cycle #{second + 1 + cycle_of(blocks[1])} is another state /, reported)
  end

  def test_SWR_REPLAY_038_what_is_there_again_is_named_by_both_ends_and_counted_once
    files, (_, second) = thirds
    said, code = replay_folder(numbered([files[0], files[0], *files.drop(1)]))
    assert_whole(said, code, 4)
    assert_includes said, "Cycles 0 to #{second - 1} are there again in #{file_name(2)} (#{second}).\n"
  end

  def test_SWR_REPLAY_038_what_is_there_again_without_a_checkpoint_is_not_called_whole
    files, (_, _, third) = thirds
    said, code = replay_folder(numbered([*files, files[2]]))
    refute_whole(said, code)
    # The first of a block is kept whole, and its record compared; of the others there is a proof, which needs a checkpoint.
    firsts = blocks.map { |block| cycle_of(block) }.select { |first| first >= third }
    firsts.zip([*firsts.drop(1), cycles]).each do |first, behind|
      assert_includes said, "Cycles #{first + 1} to #{behind - 1} are there again in #{file_name(4)}, follow no checkpoint there and " \
                            "were not compared (#{behind - first - 1}).\n"
    end
  end

  def test_SWR_REPLAY_038_a_forged_recording_between_those_of_a_run_is_named
    files, = thirds
    said, code = replay_folder(numbered([*files, forged(cycles - 7)]))
    assert_equal 1, code, said
    assert_match(/^#{file_name(4)}: Cycle #{cycles - 7} is there again, with a checkpoint of another state /, said)
  end

  def test_SWR_REPLAY_039_a_recording_behind_the_end_of_the_run_is_named
    said, code = replay_folder(numbered([recording, joined(header, [moved(cycles + 5), trailer(TRAILER, 0)])]))
    assert_equal 3, code, said
    assert_includes said, "#{file_name(2)} goes on with cycle #{cycles + 5}, although a recording before it says that the run ends with it.\n"
    refute_includes said, 'every output equal'
  end

  def test_SWR_REPLAY_036_an_older_run_is_not_judged_in_the_place_of_a_newest_file_that_cannot_be_read
    files, = thirds
    other = changed_header(header, RUN, [OTHER_RUN].pack('Q<'))
    [other.dup.tap { |bytes| bytes.setbyte(40, bytes.getbyte(40) ^ 1) }, '', other, changed_header(header, 8, [1].pack('V')),
     SecureRandom.bytes(3000)].each do |newest|
      said, code = replay_folder(numbered([*files, newest]))
      assert_equal 2, code, said
      assert_match(/^#{file_name(4)} is left out: /, said)
      assert_includes said, "#{file_name(4)} is newer than all recordings that can be read; name the run with --run NAME.\n"
      refute_includes said, 'every output equal'
      assert_whole(*replay_folder(numbered([*files, newest]), '--run', run_name), 3)
    end
  end

  def test_SWR_REPLAY_036_a_number_of_more_than_32_bits_is_still_a_number
    %w[4294967295 4294967296 4294967297 99999999999999999999].each do |number|
      newest = "blackbox-#{number}-x.bsr"
      said, code = replay_folder(numbered([recording]).merge(newest => ''))
      assert_equal 2, code, said
      assert_includes said, "#{newest} is newer than all recordings that can be read; name the run with --run NAME.\n"
    end
  end

  def test_SWR_REPLAY_036_a_file_that_cannot_be_read_and_is_older_is_left_out
    files, = thirds
    assert_whole(*replay_folder(numbered(['', *files])), 3)
    assert_whole(*replay_folder(numbered([*files, header])), 3) # It is of the same run.
  end

  def test_SWR_REPLAY_002_a_recording_of_the_run_that_is_damaged_is_refused_by_its_name_and_place
    files, = thirds
    at = files[1].bytesize / 2
    files[1].setbyte(at, files[1].getbyte(at) ^ 1)
    said, code = replay_folder(numbered(files))
    assert_equal 2, code, said
    refute_includes said, 'equal'
    first, last = said.match(/^#{file_name(2)}: Block \d+, bytes (\d+)\.\.(\d+): /).captures.map(&:to_i)
    assert_includes (first..last), at
    files[1].setbyte(HEADER, files[1].getbyte(HEADER) ^ 1) # Its first cycle is no longer known.
    assert_match(/^#{file_name(2)}: Block 0, /, replay_folder(numbered(files)).first)
  end

  def test_SWR_REPLAY_033_a_recorder_that_was_killed_has_cut_a_recording_short_in_the_run
    files, (_, _, third) = thirds
    files[1] = files[1][0..-100]
    said, code = replay_folder(numbered(files))
    refute_whole(said, code)
    assert_match(/^#{file_name(2)}: Cut short after /, said)
    assert_match(/^Cycles \d+ to #{third - 1} are missing /, said)
    files[2] = files[2][0..-2]
    assert_includes replay_folder(numbered(files)).first, 'The end of the run is missing; the last cycle is '
  end

  def test_SWR_REPLAY_034_a_folder_without_a_recording_is_refused
    said, code = replay_folder({})
    assert_equal 2, code
    assert_match(/\A\S+ holds no recording\.\n\z/, said)
  end

  def test_SWR_REPLAY_035_what_is_of_one_recording_refuses_a_folder
    [%w[--html x], %w[--csv x], %w[--mcap x], %w[--what-if 5 pedal_a=0]].each do |words|
      said, code = replay_folder(numbered([recording]), *words)
      assert_equal 2, code, said
      assert_match(/: #{words.first} takes one recording; \S+ is a folder\. See /, said)
    end
    said, code = in_file { |file| replay('--run', '2026', file) }
    assert_equal 2, code
    assert_match(/: --run needs a folder; \S+ is none\. See /, said)
  end

  # As demonstrations and the report of real time read it: verdict and what is said, of each way.
  def read_as_they_do(files)
    in_folder(files) do |folder|
      run = RecordedRun.new(folder, Boresight.program('boresight-replay'))
      intervals = 0
      ways = [-> { run.replay }, -> { run.write_table(File.join(folder, 'motion.csv')) }, -> { run.each_interval { intervals += 1 } }]
      [ways.map { |way| [way.call, run.said] }, intervals - 1]
    end
  end

  def test_SWR_DEMO_003_SWR_CHECK_014_a_gap_is_red_wherever_a_run_is_read
    files, (_, from, to) = thirds
    reported, intervals = read_as_they_do(numbered(files))
    assert_equal [[true, true, true], cycles], [reported.map(&:first), intervals]
    reported, intervals = read_as_they_do(numbered([files.first, files.last]))
    assert_equal [[false, false, false], cycles - (to - from)], [reported.map(&:first), intervals]
    reported.each { |_, said| assert_includes said, "Cycles #{from} to #{to - 1} are missing (#{to - from})." }
  end

  def test_SWR_REPLAY_017_a_page_of_a_part_of_a_run_says_so
    files, (_, second) = thirds
    [[recording, cycles, true], [files.first, second, false]].each do |bytes, count, is_whole|
      text, = in_file(bytes) { |file| Open3.capture2e(Boresight.program('boresight-replay'), '--html', '-', file) }
      identity = JSON.parse(text[%r{<script id="recording" type="application/json">(.*?)</script>}m, 1]).fetch('recording')
      assert_equal [run_name, 0, count, is_whole, is_whole, 0],
                   identity.values_at('run', 'first', 'cycles', 'has_run_end', 'is_whole_run', 'missing')
    end
  end
end
