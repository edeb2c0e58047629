# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: the stated accuracy of measured points is right, as is the remainder after a correction; the
# tables of thesis 5.2 are reckoned anew from their points.

require 'matrix'
require 'minitest/autorun'
require 'open3'
require 'rbconfig'
require 'tempfile'
require_relative '../../points/list'
require_relative '../../points/fit'
require_relative '../../points/report'

class TestPoints < Minitest::Test
  TOOL = File.expand_path('../../points.rb', __dir__)
  HEAD = "target_x,target_y,target_z,measured_x,measured_y,measured_z\n"
  CUBE = [0.0, 80.0].product([0.0, 80.0], [0.0, 80.0]).map { |place| Vector[*place] }.freeze

  # Table 1 prints 2.19 for trial 6 and 2.37 for the mean; its points give 2.912 and 2.477.
  def test_SWR_POINTS_002_table_1_of_the_thesis_is_reckoned_without_its_slip
    text = table('neuro', 'xz')
    assert_equal [2.190, 2.680, 3.147, 1.934, 2.506, 2.912, 1.972], totals(text)
    assert_equal [1.981, 0.0, 1.236, 2.477, 2.477], figures(text, 'mean, without signs')
    assert_equal [-0.615, 0.0, 0.653], figures(text, 'bias')
    assert_equal [0.82, 0.0, 0.497], figures(text, 'standard error')
    assert_equal [2.17, 0.0, 1.316, 0.468, 0.468], figures(text, 'standard deviation')
    assert_equal [2.636, 0.0, 1.943, 3.147, 3.147], figures(text, 'worst')
  end

  # Table 2 prints 1.334 for trial 4 and calls its mean of all axes, 0.923, one in the plane.
  def test_SWR_POINTS_002_table_2_of_the_thesis_is_reckoned_without_its_slips
    text = table('prostate')
    assert_equal [0.730, 1.471, 1.403, 1.189, 0.632, 0.569, 0.321], totals(text)
    assert_equal [0.422, 0.272, 0.560, 0.902, 0.559], figures(text, 'mean, without signs')
    assert_equal [0.337, 0.050, -0.318], figures(text, 'bias')
  end

  def test_SWR_POINTS_002_an_error_is_measured_minus_target_and_a_single_point_has_no_deviation
    text, = run_tool("#{HEAD}1,2,3,1.5,2,2\n")
    assert_match(/0\.500 +0\.000 +-1\.000 +1\.118 +0\.500$/, text.lines[1])
    assert_equal %w[- - - - -], text[/^standard deviation(.*)/, 1].split
  end

  def test_SWR_POINTS_002_the_plane_is_the_one_that_was_asked_for
    points = "#{HEAD}0,0,0,3,4,12\n"
    assert_equal([5.0, 12.369, 12.649], %w[xy xz yz].map { |plane| figures(run_tool(points, plane).first, 'worst').last })
    assert_equal [false, true], [run_tool(points, 'zx').last, run_tool(points).last]
  end

  def test_SWR_POINTS_003_a_registration_explains_little_of_either_table_of_the_thesis
    assert_equal [2.222, 2.222], figures(table('neuro', 'xz'), 'mean error with the bias taken out')
    assert_equal [2.213, 2.213], figures(table('neuro', 'xz'), 'mean error with the best').last(2)
    assert_equal [0.817, 0.459], figures(table('prostate'), 'mean error with the bias taken out')
    assert_equal [0.724, 0.353], figures(table('prostate'), 'mean error with the best').last(2)
  end

  def test_SWR_POINTS_003_a_motion_is_found_again
    [[0.001, Vector[0, 0, 1]], [1.2, Vector[1, 2, -2] / 3], [Math::PI, Vector[0.6, 0, 0.8]]].each do |angle, axis|
      motion = turn(angle, axis)
      fit = fit_of(CUBE.map { |place| [place, (motion * place) + Vector[5, -7, 900]] })
      assert_operator (fit.rotation - motion).to_a.flatten.map(&:abs).max, :<, 1e-9
      assert_operator (fit.translation - Vector[5, -7, 900]).norm, :<, 1e-6
      assert_in_delta angle * 180 / Math::PI, fit.angle_deg, 1e-5
    end
  end

  def test_SWR_POINTS_003_no_small_motion_leaves_less_than_the_best_one
    points = Points::List.read(list('prostate'))
    fit = Points::Fit.new(points)
    least = squares(points, fit.rotation, fit.translation)
    [1e-3, -1e-3].product((0..2).map { |axis| Vector.basis(size: 3, index: axis) }) do |step, axis|
      assert_operator squares(points, fit.rotation, fit.translation + (axis * step)), :>, least
      assert_operator squares(points, turn(step, axis) * fit.rotation, fit.translation), :>, least
    end
  end

  def test_SWR_POINTS_003_a_mirrored_frame_is_never_called_a_motion
    fit = fit_of(CUBE.map { |place| [place, Vector[place[0], place[1], -place[2]]] })
    assert_in_delta 1, fit.rotation.determinant
    assert_operator fit.residuals.map(&:norm).max, :>, 1
  end

  def test_SWR_POINTS_004_no_turn_is_fitted_to_two_points_or_to_noise_about_a_line
    line = (0..9).map { |number| Vector[number * 10.0, (number % 2) * 0.1, 0.0] }
    noisy = line.each_with_index.map { |place, number| [place, place + Vector[0, 0, [0.5, -0.4, 0.1][number % 3]]] }
    same = CUBE.map { |place| [CUBE.first, place] }
    [noisy, noisy.first(2), line.map { |place| [place, place] }.values_at(0, 2, 4, 6), same].each do |pairs|
      fit = fit_of(pairs)
      refute_predicate fit, :turns?
      assert_equal Matrix.identity(3), fit.rotation
    end
    assert_predicate fit_of(CUBE.map { |place| [place, place] }), :turns?
    assert_includes run_tool("#{HEAD}1,2,3,1,2,3\n").first, 'No turn is fitted'
  end

  # Six of their nine coordinates go into the fit; the remainder looks less than it is.
  def test_SWR_POINTS_004_three_points_that_a_turn_would_fit_well_are_not_believed
    targets = [Vector[0.0, 0, 0], Vector[50.0, 2, 0], Vector[100.0, 0, 0]]
    refute_predicate fit_of(targets.zip(targets.zip([0.5, -0.5, 0.5]).map { |at, up| at + Vector[0, 0, up] })), :turns?
    assert_predicate fit_of(targets.zip(targets.zip([0.1, -0.1, 0.1]).map { |at, up| at + Vector[0, 0, up] })), :turns?
  end

  def test_SWR_POINTS_001_what_a_line_says_wrongly_is_refused_with_its_number
    { '' => "1: the first line has to be #{HEAD.chomp}", "1,2,3,4,5,6\n" => '1: the first line has to be',
      HEAD => '1: there is no point below', "# of today\n\n#{HEAD}# none\n" => '3: there is no point below',
      "#{HEAD}1,2,3,4,5\n" => '2: 5 fields instead of 6; decimals have a point',
      "#{HEAD}1,2,3,4,5,6\n1,5,2,3,4,5,6\n" => '3: 7 fields instead of 6', "#{HEAD}\n1,2,3,4,5,\n" => '3: measured_z is ""',
      "#{HEAD}1,2,3 mm,4,5,6\n" => '2: target_z is "3 mm", no number of mm', "#{HEAD}1,nan,3,4,5,6\n" => '2: target_y is "nan"',
      "#{HEAD}1,2,3,1e3,5,6\n" => '2: measured_x is "1e3"', "#{HEAD}1,2,3,4000000,5,6\n" => '2: measured_x is "4000000"',
      "#{HEAD}1,2,3,4,0x5,6\n" => '2: measured_y is "0x5"', "\xFF\xFE" => '1: this is not text' }.each do |text, complaint|
      assert_refused text, complaint
    end
  end

  def test_SWR_POINTS_001_what_a_spreadsheet_saves_is_read
    text, passed = run_tool("\uFEFF#{HEAD.chomp}\r\n+1.5, -2 ,0,1.5,-2,.5\r\n".sub(',.5', ',0.5'))
    assert passed
    assert_equal [0.0, 0.0, 0.5, 0.5, 0.0], figures(text, 'worst')
  end

  def test_SWR_POINTS_001_a_file_that_is_not_there_is_refused
    text, status = Open3.capture2e(RbConfig.ruby, TOOL, '/nowhere/points.csv')
    assert_equal "points: /nowhere/points.csv: No such file or directory\n", text
    refute_predicate status, :success?
  end

  private

  def list(name)
    File.expand_path("../points/#{name}.csv", __dir__)
  end

  def table(name, plane = 'xy')
    Points::Report.new(Points::List.read(list(name)), plane).to_s
  end

  # Output of the tool for such a file, and whether it took it.
  def run_tool(text, *plane)
    Tempfile.create(['points', '.csv']) do |file|
      file.write(text)
      file.close
      output, status = Open3.capture2e(RbConfig.ruby, TOOL, file.path, *plane)
      return [output.gsub(file.path, 'FILE'), status.success?]
    end
  end

  def assert_refused(text, complaint)
    output, passed = run_tool(text)
    refute passed, text
    assert_equal 1, output.lines.size
    assert_operator output, :start_with?, "points: FILE:#{complaint}"
  end

  def totals(text)
    text.lines[1..7].map { |line| line.split[-2].to_f }
  end

  def figures(text, head)
    text[/^#{head}[^\d\n]*?( +-?\d.*)/, 1].scan(/-?\d+\.\d{3}/).map(&:to_f)
  end

  def fit_of(pairs)
    Points::Fit.new(pairs.map { |target, measured| Points::Point.new(target, measured) })
  end

  # By Rodrigues; the tool goes by quaternions.
  def turn(angle, axis)
    cross = Matrix[[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]]
    Matrix.identity(3) + (cross * Math.sin(angle)) + (cross**2 * (1 - Math.cos(angle)))
  end

  def squares(points, rotation, translation)
    points.sum { |point| (point.measured - ((rotation * point.target) + translation)).norm**2 }
  end
end
