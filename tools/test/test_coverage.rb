# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: lcov and gcovr count the same in every file, or the file is named with both counts.

require 'minitest/autorun'
require_relative '../coverage'

class TestCoverage < Minitest::Test
  TRACEFILE = <<~TEXT
    TN:
    SF:core/a.c
    FNF:1
    FNH:1
    BRF:2
    BRH:1
    LF:3
    LH:2
    end_of_record
    TN:
    SF:core/b.c
    FNF:1
    FNH:0
    LF:1
    LH:0
    end_of_record
  TEXT

  def test_SWR_COVER_001_equal_counts_are_summed_up
    assert_empty compare.differences
    assert_equal 'lcov and gcovr count the same in 2 files: 2 of 4 lines, 1 of 2 functions, 1 of 2 branches',
                 compare.summary
  end

  def test_SWR_COVER_001_every_other_count_names_its_file
    { 'LH:2' => 'LH:3', 'LF:3' => 'LF:4', 'FNH:1' => 'FNH:0', 'FNF:1' => 'FNF:2', 'BRH:1' => 'BRH:2',
      'BRF:2' => 'BRF:3' }.each do |from, to|
      differences = compare(TRACEFILE.sub(from, to)).differences
      assert_equal 1, differences.size, to
      assert_match(%r{\Acore/a\.c: lcov counts .*, gcovr 2 of 3 lines, 1 of 1 functions, 1 of 2 branches\z},
                   differences.first)
    end
  end

  def test_SWR_COVER_001_a_file_that_only_one_of_them_knows_is_named
    assert_equal ['core/b.c: lcov counts nothing, gcovr 0 of 1 lines, 0 of 1 functions, 0 of 0 branches',
                  'core/c.c: lcov counts 0 of 1 lines, 0 of 1 functions, 0 of 0 branches, gcovr nothing'],
                 compare(TRACEFILE.sub('core/b.c', 'core/c.c')).differences
  end

  private

  def compare(tracefile = TRACEFILE)
    a = { 'file' => 'core/a.c', 'functions' => [{ 'execution_count' => 4 }],
          'lines' => [line(0, 'gcovr/noncode' => true), line(4, 'branches' => [{ 'count' => 4 }, { 'count' => 0 }]),
                      line(1), line(0), line(0, 'gcovr/excluded' => true)] }
    b = { 'file' => 'core/b.c', 'functions' => [{ 'execution_count' => 0 }], 'lines' => [line(0)] }
    Coverage.new(Coverage.lcov(tracefile), Coverage.gcovr('files' => [a, b]))
  end

  def line(count, more = {})
    { 'count' => count, 'branches' => [] }.merge(more)
  end
end
