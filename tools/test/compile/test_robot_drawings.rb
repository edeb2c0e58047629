# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'minitest/autorun'
require_relative '../../compile/robot_drawings'

# Rule under test: the console draws a robot as its file states, and a drawing that cannot be drawn is refused.
class RobotDrawingsTest < Minitest::Test
  FOLDER = File.expand_path('../../../core/robot', __dir__)
  PATH = File.join(FOLDER, 'bench2/robot.yml')
  TEXT = File.binread(PATH).force_encoding(Encoding::UTF_8)

  def drawn(drawing)
    Robot::Drawing.new(PATH, TEXT, drawing).script
  end

  def refusal(drawing)
    assert_raises(Robot::Refused) { drawn(drawing) }.message
  end

  def test_SWR_CON_029_lengths_are_numbers_and_axes_are_asked_for
    script = drawn('where' => { 'high' => 'home_y_mm + 2' }, 'parts' => { 'bar' => [['slide', 'high', 'needle_maximum']] })
    assert_includes script, 'const high = (100.0) + 2;'
    assert_includes script, '[at("slide"), high, (30.0)],'
  end

  def test_SWR_CON_029_the_drawing_names_the_file_it_is_made_from
    assert_includes drawn({}), "checksum: \"#{format('%08x', Robot::Crc.of(TEXT))}\""
    refute_includes Robot::Drawing.new(PATH, "#{TEXT}#\n").script, format('%08x', Robot::Crc.of(TEXT))
  end

  def test_SWR_CON_029_every_robot_has_a_drawing
    script = RobotDrawings.new(FOLDER).script
    Dir.children(FOLDER).select { |name| File.directory?(File.join(FOLDER, name)) }.each do |name|
      assert_match(/^#{name}: \{$/, script)
    end
  end

  def test_SWR_CON_029_a_formula_of_what_nobody_knows_is_refused_with_its_place
    assert_match(%r{bench2/kinematics\.yml: drawing\.parts\.bar: slope \+ 1 is not a formula: slope},
                 refusal('parts' => { 'bar' => [['slope + 1', 0, 0]] }))
  end

  def test_SWR_CON_029_a_formula_without_a_value_is_refused
    assert_match(/drawing\.where\.high: sqrt\(0 - 1\) has no value/, refusal('where' => { 'high' => 'sqrt(0 - 1)' }))
  end

  def test_SWR_CON_029_a_needle_is_checked_like_the_rest
    assert_match(/drawing\.needle\.rear: /, refusal('needle' => { 'rear' => 'nothing' }))
  end
end
