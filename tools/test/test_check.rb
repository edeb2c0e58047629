# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'minitest/autorun'
require 'tmpdir'
require_relative '../check'

# Rule under test: a check finds the tests that reach a changed file, and names each step that failed.
class TestCheck < Minitest::Test
  ROOT = File.expand_path('../..', __dir__)

  def test_SWR_TOOL_041_tests_that_include_a_changed_module_are_run
    tests = change('core/axis/encoder.c').c_tests
    assert_includes tests, 'verification/unit/axis/test_encoder.c'
    refute_includes tests, 'verification/unit/robot/test_probe.c'
    assert_includes change('core/robot/neuro/neuro.c').c_tests, 'core/robot/neuro/test/test_neuro.c'
  end

  def test_SWR_TOOL_041_tests_that_share_a_changed_part_or_include_a_module_by_it_are_run
    assert_equal %w[test_mode.c test_mode_table.c], change('verification/unit/mode/armed_mode_world.inc').c_tests.map { |test| File.basename(test) }
    assert_includes change('core/card/aim32_frame.h').c_tests, 'verification/unit/nifpga/test_bsp_nifpga.c'
  end

  def test_SWR_TOOL_041_of_many_tests_those_of_the_module_are_run_first
    tests = change('core/controller/controller.h').c_tests
    assert_equal 24, tests.size
    assert_equal 'verification/unit/axis/test_encoder.c', change('core/controller/controller.h', 'core/axis/encoder.h').c_tests.first
  end

  def test_SWR_TOOL_041_a_changed_test_is_run
    assert_equal ['verification/unit/axis/test_encoder.c'], change('verification/unit/axis/test_encoder.c').c_tests
    assert_equal ['tools/test/test_rooms.rb'], change('tools/test/test_rooms.rb').ruby_tests
  end

  def test_SWR_TOOL_041_the_tests_of_a_changed_tool_are_run
    assert_equal ['tools/test/test_rooms.rb'], change('tools/rooms.rb').ruby_tests
  end

  def test_SWR_TOOL_041_a_step_that_fails_is_named_with_its_output
    check = Class.new(Check) do
      def steps
        { 'form of C' => listed(%w[clang-format --dry-run --Werror], @change.of('.c')), 'rooms' => %w[true] }
      end
    end
    Dir.mktmpdir do |folder|
      File.write("#{folder}/wrong.c", "int  a;\n")
      said, = capture_io { refute check.new(Change.new(["#{folder}/wrong.c"], folder)).run }
      assert_match(/check: form of C: failed/, said)
      assert_match(/wrong\.c:1:\d+: error/, said)
      assert_match(/check: failed: form of C$/, said)
    end
  end

  private

  def change(*files)
    Change.new(files, ROOT)
  end
end
