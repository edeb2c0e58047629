# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: each fault of an encoder or a motor of an axis at its speed is found as soon as is aimed at, and the
# document that says so is true. `make detection` writes it.

require 'minitest/autorun'
require 'open3'

class TestDetection < Minitest::Test
  PROGRAM = File.expand_path('../../build/gcc/bin/detection', __dir__)
  DOCUMENT = File.expand_path('../../docs/detection.md', __dir__)

  def self.text
    @text ||= Open3.capture2e(PROGRAM).first
  end

  def rows(pattern)
    self.class.text.lines(chomp: true).grep(/\A\| #{pattern}/)
  end

  def assert_aim_met(pattern, count)
    assert_equal count, rows(pattern).size, self.class.text
    assert_empty(rows(pattern).grep_v(/\| yes \|\z/))
  end

  def test_SWR_AXIS_018_a_blind_axis_is_found_within_the_aim
    assert_aim_met('(encoder cut|encoder lines|shaft)', 21)
  end

  def test_SWR_AXIS_019_wrong_counts_and_wrong_speeds_are_found_within_the_aim
    assert_aim_met('(half the counts|motor half|motor twice)', 21)
  end

  def test_SWR_AXIS_023_ten_minutes_of_scanning_are_accounted_for_and_nothing_is_critical
    assert_includes self.class.text, "\nCritical events: 0.\n"
    accounts = rows('\\w+ \\| -?\\d+ ticks').map { |row| row.scan(/(-?[\d.]+) ticks/).flatten.map(&:to_f) }
    assert_equal 7, accounts.size, self.class.text
    accounts.each { |counted, apart| assert_in_delta apart, counted, 1.0 }
  end

  def test_SWR_AXIS_018_the_document_holds_the_figures_of_today
    assert_equal File.read(DOCUMENT), self.class.text, 'run make detection'
  end
end
