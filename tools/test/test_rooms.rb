# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: an include of a source shows its room in the line, and that room may be seen.

require 'fileutils'
require 'minitest/autorun'
require 'tmpdir'
require_relative '../rooms'

class TestRooms < Minitest::Test
  ROOT = File.expand_path('../..', __dir__)
  RULES = <<~YAML
    core/low: {holds: stones, sees: []}
    core/high: {holds: bricks, sees: [low/open.h]}
    bsp: {holds: a board, sees: []}
    app/top: {holds: tiles, sees: [bsp.h, high]}
  YAML

  def test_SWR_TOOL_014_the_house_keeps_its_rules
    assert_empty Rooms.new(ROOT).problems
  end

  def test_SWR_TOOL_014_a_room_sees_itself_and_what_it_may
    assert_empty problems('core/high/a.c' => "#include \"high/a.h\"\n#include <stdio.h>\n#include \"low/open.h\"\n",
                          'core/high/deep/b.c' => "#include \"high/deep/b.h\"\n",
                          'app/top/b.c' => "#include \"high/any.h\"\n#include \"bsp.h\"\n#include <sys/types.h>\n")
  end

  def test_SWR_TOOL_014_finds_an_arrow_upwards
    assert_equal ['core/low/a.h:2: core/low must not include "high/a.h"'],
                 problems('core/low/a.h' => "\n#include \"high/a.h\"\n")
  end

  def test_SWR_TOOL_014_finds_another_header_of_a_room_of_which_one_is_allowed
    assert_equal ['core/high/a.c:1: core/high must not include "low/inner.h"'],
                 problems('core/high/a.c' => "  # include \"low/inner.h\"\n")
  end

  def test_SWR_TOOL_014_finds_what_lies_below_a_folder_that_is_seen
    assert_equal ['app/top/a.c:1: app/top must not include "high/deep/b.h"'],
                 problems('app/top/a.c' => "#include \"high/deep/b.h\"\n")
  end

  def test_SWR_TOOL_014_finds_an_include_however_it_is_written
    ['#include"high/a.h"', '#include <high/a.h>', '#include "low/../high/a.h"', '/* so */ #include "high/a.h"',
     '#/**/include "high/a.h"', "#include \\\n", '%:include "high/a.h"', '#include HIGH', '#include_next "high/a.h"',
     '#include "low/a.inc"'].each do |line|
      found = problems('core/low/a.h' => "#{line}\n")
      assert_equal 1, found.size, line
      assert_match(%r{\Acore/low/a.h:1: core/low must not include}, found.first)
    end
  end

  def test_SWR_TOOL_016_core_and_app_name_no_board
    board = { 'bsp/own/board.mk' => "BOARD_PROGRAMS := boresight-lamp\n" }
    { 'app/top/a.c' => "/* bsp_own knows */\n", 'core/low/a.h' => "is_it(\"own\");\n", 'core/low/a.yml' => "run: boresight-lamp\n" }
      .each do |file, text|
      found = problems(**board, file => text)
      assert_equal 1, found.size, text
      assert_match(/\A#{file}:1: names (bsp_own|"own"|boresight-lamp), which is of a board/, found.first)
    end
    assert_empty problems(**board, 'app/top/a.c' => "/* Its own bsp_owner. */\n")
  end

  def test_SWR_TOOL_016_a_board_that_is_not_listed_sees_what_any_board_may
    board = { 'bsp/own/board.mk' => '' }
    assert_empty problems(**board, 'bsp/own/a.c' => "#include \"bsp.h\"\n#include \"own/a.h\"\n")
    assert_equal ['bsp/own/a.c:1: bsp/own must not include "high/a.h"'],
                 problems(**board, 'bsp/own/a.c' => "#include \"high/a.h\"\n")
  end

  def test_SWR_TOOL_014_knows_tests_of_robots_alone
    assert_empty problems('core/robot/any/test/test_any.c' => "#include \"unity.h\"\n")
    assert_equal 1, problems('core/low/test/a.c' => "#include \"high/a.h\"\n").size
  end

  def test_SWR_TOOL_014_finds_an_include_without_its_room
    assert_equal ['app/top/a.c:1: app/top must not include "a.h" without its room'],
                 problems('app/top/a.c' => "#include \"a.h\"\n")
  end

  def test_SWR_TOOL_014_finds_a_folder_that_is_no_room
    assert_equal ['core/cellar/a.c: its folder is no room of tools/rooms.yml'], problems('core/cellar/a.c' => '')
  end

  def test_SWR_TOOL_014_finds_rooms_that_may_see_each_other
    circle = "#{RULES}core/ring: {holds: a way back, sees: [loop]}\ncore/loop: {holds: another, sees: [ring/a.h]}\n"
    assert_equal ['tools/rooms.yml: core/loop and core/ring see each other'], problems({}, circle)
  end

  def test_SWR_TOOL_075_finds_files_of_one_room_that_include_each_other
    circle = { 'core/high/a.h' => "#include \"high/b.h\"\n", 'core/high/b.h' => '', 'core/high/b.c' => "#include \"high/c.h\"\n",
               'core/high/c.h' => "#include \"high/a.h\"\n" }
    assert_equal ['core/high/a: includes itself by core/high/b and core/high/c'], problems(circle)
    assert_empty problems(circle.merge('core/high/c.h' => "#include \"high/c.h\"\n"))
  end

  def test_SWR_TOOL_075_a_source_that_uses_what_stands_below_its_header_is_no_circle
    assert_empty problems('core/high/a.h' => "#include \"high/a_state.h\"\n", 'core/high/a.c' => "#include \"high/a.h\"\n#include \"high/b.h\"\n",
                          'core/high/a_state.h' => '', 'core/high/b.h' => "#include \"high/a_state.h\"\n")
  end

  def test_SWR_TOOL_014_a_room_within_a_room_sees_what_it_may_alone
    within = "#{RULES}core/high/inner: {holds: a cupboard, sees: [low]}\n"
    files = { 'core/high/inner/a.c' => "#include \"low/open.h\"\n#include \"high/inner/a.h\"\n", 'core/high/b.c' => "#include \"high/b.h\"\n" }
    assert_empty problems(files, within)
    assert_equal ['core/high/b.c:1: core/high must not include "high/inner/a.h"', 'core/high/inner/a.c:1: core/high/inner must not include "high/b.h"'],
                 problems({ 'core/high/inner/a.c' => "#include \"high/b.h\"\n", 'core/high/b.c' => "#include \"high/inner/a.h\"\n" }, within).sort
  end

  def test_SWR_TOOL_076_a_folder_with_more_files_than_one_overlooks_needs_a_reason
    files = (0..Rooms::MOST_FILES).to_h { |number| ["verification/heap/test_#{number}.rb", ''] }
    assert_equal ["verification/heap: holds #{Rooms::MOST_FILES + 1} files, more than #{Rooms::MOST_FILES}"], problems(files)
    reason = "#{RULES}---\nverification/heap: a file for each number\n"
    assert_empty problems(files, reason)
    assert_empty problems(files.drop(1).to_h)
    assert_equal ["tools/rooms.yml: verification/heap holds at most #{Rooms::MOST_FILES} files and needs no reason"], problems(files.drop(1).to_h, reason)
  end

  def test_SWR_ROBOT_020_finds_a_refusal_of_one_robot_outside_of_its_folder
    ant = { 'core/robot/ant/kinematics.yml' => "refusals:\n  - {code: 3, name: TOO_WET, says: No.}\n",
            'core/robot/ant/ant.c' => "return STATUS_TOO_WET;\n" }
    rules = "#{RULES}core/robot: {holds: robots, sees: []}\n"
    assert_empty problems(ant.merge('app/top/a.c' => "STATUS_TOO_WET_TODAY\n"), rules)
    assert_equal ['app/top/a.c:2: STATUS_TOO_WET belongs to core/robot/ant/ alone',
                  'core/robot/bee/bee.h:1: STATUS_TOO_WET belongs to core/robot/ant/ alone'],
                 problems(ant.merge('app/top/a.c' => "\nx = STATUS_TOO_WET;\n",
                                    'core/robot/bee/bee.h' => "/* STATUS_TOO_WET */\n"), rules)
  end

  private

  def problems(files, rules = RULES)
    Dir.mktmpdir do |root|
      { Rooms::FILE => rules, **files }.each do |file, text|
        FileUtils.mkdir_p(File.dirname(File.join(root, file)))
        File.write(File.join(root, file), text)
      end
      Rooms.new(root).problems
    end
  end
end
