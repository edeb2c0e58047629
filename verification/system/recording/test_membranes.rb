# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: the replay finds the membranes of any recording of force and depth, and says how it did against depths
# that are given.

require 'minitest/autorun'
require 'open3'
require 'tmpdir'
require_relative '../support/boresight'

class TestMembranes < Minitest::Test
  REPLAY = Boresight.program('boresight-replay')
  REST_MS = 1500
  WAY_MM = 80
  MM_PER_MS = 0.004
  NOISE_N = 0.1

  def setup
    @folder = Dir.mktmpdir
  end

  def teardown
    FileUtils.rm_rf(@folder)
  end

  # An insertion, in which the force has grown by 1.5 N before each drop and falls by so much.
  def write(name, drops_mm, seed: 1, rest_ms: REST_MS)
    file = File.join(@folder, name)
    File.write(file, "time_ms,depth_mm,force_n\n#{rows(drops_mm, Random.new(seed), rest_ms).join}")
    file
  end

  def rows(drops_mm, chance, rest_ms)
    (0...(rest_ms + (WAY_MM / MM_PER_MS))).map do |time|
      depth = [(time - rest_ms) * MM_PER_MS, 0].max
      before = drops_mm.map { |drop| drop - depth }.select { |left| left.between?(0, 2) }.min
      force = (0.01 * depth) + (before ? 1.5 * (1 - (before / 2)) : 0)
      format("%<time>d,%<depth>.3f,%<force>.4f\n", time: time, depth: depth, force: force + noise(chance))
    end
  end

  def noise(chance)
    NOISE_N * Math.sqrt(-2 * Math.log(1 - chance.rand)) * Math.cos(2 * Math::PI * chance.rand)
  end

  def find(*arguments)
    Open3.capture3(REPLAY, '--membranes', *arguments)
  end

  def found(*arguments)
    output, errors, status = find(*arguments)
    assert_equal ['', 0], [errors, status.exitstatus]
    output.lines(chomp: true)
  end

  def refused(*arguments)
    output, errors, status = find(*arguments)
    assert_equal ['', 2], [output, status.exitstatus]
    errors
  end

  # Depths of the lines that match.
  def depths(lines, pattern)
    lines.filter_map { |line| line[pattern, 1]&.to_f }
  end

  def test_SWR_PUNCT_552_each_puncture_is_a_line_with_its_depth
    lines = found(write('a.csv', [30, 55]))
    assert_match(/a\.csv: noise 0\.0[12]\d\d N behind the filter: no fall below 0\.1[4-9]\d N is found\z/, lines.first)
    at = depths(lines, /\A\d+ ms: puncture at ([\d.]+) mm, a fall of 0\.\d{3} N or more\z/)
    assert_equal 3, lines.size
    assert_in_delta 30, at[0], 0.1
    assert_in_delta 55, at[1], 0.1
  end

  def test_SWR_PUNCT_552_a_given_noise_decides_the_least_fall_and_needs_no_rest
    file = write('a.csv', [30], rest_ms: 0)
    assert_match(/a\.csv, line \d+: the needle has not rested for 1064 ms, in which the noise is measured; give it by --noise\.\n\z/,
                 refused(file))
    assert_equal 2, found('--noise', '21.5', file).size
    lines = found('--noise', '500', file)
    assert_equal ["#{file}: noise 0.5000 N behind the filter: no fall below 4.000 N is found"], lines
  end

  def test_SWR_PUNCT_552_a_recording_of_fewer_samples_is_read_as_well
    file = write('a.csv', [30, 55])
    head, *rows = File.readlines(file)
    File.write(file, head + rows.each_slice(5).map(&:first).join)
    at = depths(found(file), /puncture at ([\d.]+) mm/)
    assert_equal [30, 55], at.map(&:round)
  end

  def test_SWR_PUNCT_553_membranes_are_expected_unexpected_and_missed
    lines = found('--expected', '30,60', write('a.csv', [31.5, 45]))
    assert_match(/puncture at 31\.5\d\d mm.*, expected at 30\.000 mm\z/, lines[1])
    assert_match(/puncture at 45\.0\d\d mm.*, unexpected\z/, lines[2])
    assert_match(/\A\d+ ms: missed the membrane at 60\.000 mm\z/, lines[3])
    assert_equal ['found 1 of 2 membranes, recall 50.0 %; insertions: 1',
                  'false alarms per insertion: 0.00 with the window, 1.00 without',
                  'precision without the window: 50.0 %'], lines[4..]
  end

  def test_SWR_PUNCT_553_figures_are_those_of_all_insertions
    files = [write('a.csv', [30, 34]), write('b.csv', [], seed: 2), write('c.csv', [70], seed: 3)]
    lines = found('--expected', '30', *files)
    assert_equal ['found 1 of 3 membranes, recall 33.3 %; insertions: 3',
                  'false alarms per insertion: 0.33 with the window, 0.67 without',
                  'precision without the window: 33.3 %'], lines.last(3)
  end

  def test_SWR_PUNCT_553_a_membrane_that_was_not_reached_is_not_missed
    lines = found('--expected', '30,81,200', write('a.csv', [30]))
    assert_equal ['the recording ends before 2 of the expected membranes', 'found 1 of 1 membranes, recall 100.0 %; insertions: 1'],
                 lines[2, 2]
    assert_equal ['the recording ends before 1 of the expected membranes', 'no expected membrane was passed; insertions: 1',
                  'false alarms per insertion: 0.00 with the window, 0.00 without'],
                 found('--expected', '200', write('b.csv', [])).drop(1)
  end

  def test_SWR_PUNCT_553_a_membrane_shortly_before_the_end_is_missed
    lines = found('--expected', '30,79,81', write('a.csv', [30]))
    assert_match(/\A21499 ms: missed the membrane at 79\.000 mm\z/, lines[2])
    assert_equal ['the recording ends before 1 of the expected membranes', 'found 1 of 2 membranes, recall 50.0 %; insertions: 1'],
                 lines[3, 2]
  end

  def test_SWR_PUNCT_553_without_given_depths_nothing_is_judged
    refute_match(/recall|false|precision|expected/, found(write('a.csv', [30])).join)
  end

  def test_SWR_PUNCT_553_depths_that_are_no_list_are_refused
    file = write('a.csv', [])
    ['', '30;55', '55,30', '-1', '30,', 'x', '301', '1,2,3,4,5,6,7,8,9', '1e', '30,nan'].each do |depths|
      assert_equal "boresight-replay: \"#{depths}\" is no list of depths in mm. See boresight-replay --help.\n",
                   refused("--expected=#{depths}", file)
    end
    ['', '-1', '10001', '1x'].each do |noise|
      assert_equal "boresight-replay: \"#{noise}\" is no noise in mN. See boresight-replay --help.\n", refused("--noise=#{noise}", file)
    end
  end

  def test_SWR_PUNCT_554_a_bad_file_is_refused_with_line_and_reason
    file = File.join(@folder, 'bad.csv')
    File.write(file, "time_ms,depth_mm,force_n\n0,1,2\n1,1,2,5\n")
    assert_equal "#{file}, line 3: it has not as many values as the head has columns.\n", refused(file)
    ["0,1,2\n1,1\0,2\n", "0,1,2\n1,1,2\n\0" "2,1,2\n"].each_with_index do |rows, more|
      File.binwrite(file, "time_ms,depth_mm,force_n\n#{rows}")
      assert_equal "#{file}, line #{3 + more}: it has a byte of 0, which is no text.\n", refused(file)
    end
    assert_equal "#{@folder}/none: No such file or directory.\n", refused("#{@folder}/none")
    assert_equal "#{@folder} is no regular file.\n", refused(@folder)
    large = File.join(@folder, 'large.csv')
    File.write(large, '')
    File.truncate(large, (256 * 1024 * 1024) + 1)
    assert_equal "#{large} is larger than 268435456 bytes.\n", refused(large)
  end

  def test_SWR_PUNCT_554_its_options_go_with_nothing_else
    file = write('a.csv', [])
    assert_match(/All its options exclude each other/, refused('--table', file))
    assert_match(/--run needs a folder/, refused('--run', 'x', file))
    _, errors, status = Open3.capture3(REPLAY, '--expected', '30', file)
    assert_match(/--expected and --noise need --membranes/, errors)
    assert_equal 2, status.exitstatus
  end
end
