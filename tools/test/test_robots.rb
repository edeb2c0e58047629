# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'minitest/autorun'
require 'tmpdir'
require_relative '../robots'

# Rule under test: what names all robots is made from their folders, and a robot more changes nothing of the others.
class RobotsTest < Minitest::Test
  def made(*names)
    Dir.mktmpdir do |folder|
      names.each do |name|
        FileUtils.mkdir_p(File.join(folder, name))
        File.write(File.join(folder, name, 'robot.yml'), '')
      end
      return Robots.new(folder)
    end
  end

  def test_SWR_ROBOT_014_each_folder_of_a_robot_is_a_case_of_each_switch
    source = made('neuro', 'bench2').source
    %w[bench2 neuro].each do |name|
      %w[forward inverse solve].each { |act| assert_includes(source, "#{name}_#{act}(robot, ") }
      assert_includes(source, "#include \"robot/#{name}/#{name}.h\"")
      assert_equal(3, source.scan("case ROBOT_KIND_#{name.upcase}:").size)
    end
  end

  def test_SWR_ROBOT_014_a_kind_that_nobody_knows_is_refused
    assert_equal(2, made('neuro').source.scan('solution = {STATUS_MEMORY_DAMAGED, 0U, 0U}').size)
    assert_equal(3, made('neuro').source.scan('default:').size)
  end

  def test_SWR_ROBOT_014_a_robot_more_changes_the_kind_of_none
    kind = made('neuro').header[/ROBOT_KIND_NEURO 0x\h+U/]
    assert_includes(made('aaa', 'neuro', 'zzz').header, kind)
    refute_nil(kind)
  end

  def test_SWR_ROBOT_014_no_function_is_called_by_a_pointer
    refute_includes(made('neuro', 'bench2').source, '(*')
  end

  def test_SWR_ROBOT_014_a_folder_without_a_robot_is_none
    Dir.mktmpdir do |folder|
      FileUtils.mkdir_p(File.join(folder, 'notes'))
      refute_includes(Robots.new(folder).source, 'notes')
    end
  end
end
