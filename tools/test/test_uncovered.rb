# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: every line and branch that no test reached is listed with its place.

require 'minitest/autorun'
require_relative '../uncovered'

class TestUncovered < Minitest::Test
  def test_SWR_TRACE_001_lists_lines_and_branches_that_were_not_reached
    lines = [line(1, 0, 'gcovr/noncode' => true), line(2, 0), line(3, 7),
             line(4, 7, 'branches' => [{ 'count' => 7 }, { 'count' => 0 }]),
             line(5, 7, 'branches' => [{ 'count' => 7 }, { 'count' => 1 }]), line(6, 0, 'gcovr/excluded' => true)]
    report = { 'files' => [{ 'file' => 'core/a.c', 'lines' => lines }] }
    assert_equal ['core/a.c:2: not executed', 'core/a.c:4: 1 of 2 branches not taken'], Uncovered.new(report).lines
  end

  private

  def line(number, count, more = {})
    { 'line_number' => number, 'count' => count, 'branches' => [] }.merge(more)
  end
end
