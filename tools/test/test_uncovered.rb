# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: every line and branch of the core and the charts that no test reached is listed with its place.

require 'minitest/autorun'
require 'tmpdir'
require_relative '../uncovered'

class TestUncovered < Minitest::Test
  # Line, column, count, whether it is counted, begins a region, is a gap.
  SEGMENTS = [[1, 1, 3, true, true, false], [2, 5, 0, true, true, false], [3, 1, 0, true, false, true], [4, 1, 0, false, false, false],
              [5, 1, 7, true, true, false], [5, 9, 0, true, true, false]].freeze

  def test_SWR_TOOL_490_lists_lines_and_branches_that_were_not_reached
    uncovered = of(["#{Dir.pwd}/core/a.c"], [[1, 5, 1, 9, 3, 0, 0, 0, 4], [5, 5, 5, 9, 7, 1, 0, 0, 4]])
    assert_equal ['core/a.c:1: 1 of 2 branches not taken', 'core/a.c:2: not executed', 'core/a.c:5: not executed'], uncovered.lines
    assert_equal 'counted: 3 lines, 4 branches in 1 files', uncovered.summary
  end

  def test_SWR_TOOL_490_a_branch_of_a_header_is_taken_if_any_source_takes_it
    branches = [[[1, 5, 1, 9, 3, 0, 0, 0, 4]], [[1, 5, 1, 9, 0, 2, 0, 0, 4]]]
    report = report(['core/a.h'], branches.first)
    report['data'].first['functions'] += report(['core/a.h'], branches.last)['data'].first['functions']
    refute_includes Uncovered.new(report).lines.join, 'branches'
  end

  def test_SWR_TOOL_490_a_branch_of_a_macro_is_one_of_each_place_that_uses_it
    uses = [[8, 5, 8, 20, 1, 0, 1, 1], [9, 5, 9, 20, 1, 0, 2, 1]]
    branches = [[27, 14, 27, 20, 0, 4, 1, 0, 4], [27, 14, 27, 20, 4, 4, 2, 0, 4]]
    uncovered = of(%w[core/a.c core/base/contract.h core/base/contract.h], branches, uses)
    assert_includes uncovered.lines, 'core/a.c:8: 1 of 2 branches not taken'
    refute_includes uncovered.lines.join, 'a.c:9'
  end

  def test_SWR_TOOL_490_a_default_beside_a_case_is_the_same_branch
    in_folder("switch (x) {\ncase A:\ndefault:\n    break;\ncase B:\n    break;\ndefault:\n    break;\n}\n") do
      branches = [[2, 1, 2, 7, 3, 1, 0, 0, 4], [3, 1, 3, 8, 0, 4, 0, 0, 4], [5, 1, 5, 7, 1, 3, 0, 0, 4], [7, 1, 7, 8, 0, 4, 0, 0, 4]]
      assert_equal(['core/a.c:7: 1 of 2 branches not taken'], of(['core/a.c'], branches).lines.grep(/branches/))
    end
  end

  def test_SWR_TOOL_490_lists_nothing_of_other_places_and_of_tests
    %w[app/a.c build/gen/robot/robot_neuro.c core/robot/neuro/test/t.c].each do |file|
      uncovered = of([file], [[1, 5, 1, 9, 3, 0, 0, 0, 4]])
      assert_empty uncovered.lines
      assert_empty uncovered
    end
  end

  private

  def of(files, branches, regions = [])
    Uncovered.new(report(files, branches, regions))
  end

  def report(files, branches, regions = [])
    { 'data' => [{ 'files' => [{ 'filename' => files.first, 'segments' => SEGMENTS }],
                   'functions' => [{ 'filenames' => files, 'branches' => branches, 'regions' => regions }] }] }
  end

  def in_folder(source)
    Dir.mktmpdir do |folder|
      Dir.chdir(folder) do
        FileUtils.mkdir_p('core')
        File.write('core/a.c', source)
        yield
      end
    end
  end
end
