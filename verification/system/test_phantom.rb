# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: tissue comes from a file that is given at the start, and a wrong file is refused with line and reason.

require_relative 'support/system_test'

class TestPhantom < SystemTest
  BOX = Boresight.program('boresight-box')
  THICKNESS = 'thickness_mm 35'

  def file(text)
    path = File.join(Dir.mktmpdir('phantom'), 'mine.phantom')
    File.write(path, text)
    path
  end

  def usual
    @usual ||= boresight(arguments: ['--robot', 'prostate']).simctl('tissue', 'show')
  end

  def refusal(path)
    output, errors, status = Open3.capture3(BOX, '--box', "phantom-#{Process.pid}", '--tissue', path, stdin_data: '')
    assert_equal ['', 3], [output, status.exitstatus]
    errors
  end

  def test_SWR_BOX_529_a_robot_starts_with_the_tissue_of_a_file
    mine = usual.sub(THICKNESS, 'thickness_mm 12.5')
    other = Boresight.start(arguments: ['--robot', 'prostate', '--tissue', file("# Mine\n#{mine}")])
    assert_equal mine, other.simctl('tissue', 'show')
    other.simctl('tissue', 'usual')
    assert_equal usual, other.simctl('tissue', 'show')
  end

  def test_SWR_BOX_530_a_wrong_file_is_refused_with_line_and_reason
    path = file(usual.sub(THICKNESS, 'thickness_mm thick'))
    assert_equal "boresight-box: the phantom #{path}, line 6: thickness_mm is a number from 0.1 to 1000, not \"thick\".\n", refusal(path)
    assert_equal "boresight-box: the phantom /no/file cannot be read (No such file or directory)\n", refusal('/no/file')
    assert_match(/is no file, or longer than 8191 bytes\n\z/, refusal(file('#' * 9000)))
    assert_match(/is no file, or longer than 8191 bytes\n\z/, refusal('/'))
  end

  def test_SWR_BOX_530_nothing_starts_with_a_wrong_file
    path = file("surface_mm 30\nlayer\n")
    system = Boresight.new(arguments: ['--tissue', path])
    system.launch
    refute_equal 0, system.wait_for_end
    assert_includes system.output, "the phantom #{path}, line 1: the phantom has no \"presliding_mm\"."
  ensure
    system&.kill_all
  end
end
