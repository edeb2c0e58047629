# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: a reader of docs/thesis.md beside the thesis finds each listing, figure, table, mode and test, and all
# that its rows name is there.

require 'minitest/autorun'
require_relative '../../documents/thesis_page'

class TestThesisPage < Minitest::Test
  ROOT = File.expand_path('../../..', __dir__)
  SOURCES = Trace::Sources.new(ROOT)

  def test_SWR_THESIS_001_the_page_is_true
    assert_empty ThesisPage.new(ROOT, sources: SOURCES).complaints
  end

  def test_SWR_THESIS_001_what_is_not_there_is_named_with_its_line
    names = ['make nothing', 'make gate NAME=none', 'make one NAME=test_none', 'make demo ROBOT=none', 'ROBOT=none make run',
             'make points FILE=none.csv', 'make $(rm', 'test_SWR_ENC_001_none', 'GET /api/v1/none', 'POST /api/v1/motors',
             'curl http://127.0.0.1:8080/none', 'build/bin/boresight-none', 'SWR-NONE-001', 'NO_SUCH', 'docs/none.md']
    assert_equal names.map.with_index(1) { |name, line| "docs/thesis.md:#{line}: there is no #{name}" },
                 complaints_of(names.map { |name| "| Step: x | ours | `#{name}` |" })
  end

  def test_SWR_THESIS_001_what_is_there_is_not
    names = ['make one NAME=test_link', 'make gate NAME=unit', 'make demo ROBOT=prostate', 'ROBOT=prostate make run', 'START_UP',
             'make points FILE=tools/test/points/neuro.csv PLANE=xz', 'GET /api/v1/motors', 'POST /api/v1/needle/retract',
             'curl http://127.0.0.1:8080/api/v1/log', 'build/bin/boresight-simctl', 'build/bin/boresight-control', 'SWR-ENC-001',
             'docs/charts.md', 'test_SWR_ENC_001_the_position_follows_the_reading']
    assert_empty complaints_of(names.map { |name| "Words and `#{name}`." })
  end

  def test_SWR_THESIS_001_a_row_names_the_file_of_its_test_or_says_why_there_is_nothing
    test = 'test_SWR_ENC_001_the_position_follows_the_reading'
    assert_equal ["docs/thesis.md:1: #{test} is not in verification/unit/card/test_link.c",
                  'docs/thesis.md:2: a row has three cells, and none is empty',
                  'docs/thesis.md:3: a row has three cells, and none is empty',
                  'docs/thesis.md:4: a command, or - and nothing else'],
                 complaints_of(["| Step: a | ours | `make one NAME=test_link` `#{test}` |", '| Step: b | | - |', '| Step: c | ours |',
                                '| Step: d | ours | soon |', "| Step: e | ours | `make one NAME=test_encoder` `#{test}` |"])
  end

  def test_SWR_THESIS_001_what_has_no_row_or_two_is_named
    rows = ['| Figures 1 to 22, 24: x | ours | - |', '| Figures 25 to 37: x | ours | - |', '| Figure 2: again | ours | - |']
    reported = ThesisPage.new(ROOT, rows.join("\n"), sources: SOURCES).complaints
    assert_equal ['Figure 2 has 2 rows', 'Figure 23 has no row', 'Figure 38 has no row'],
                 reported.filter_map { |line| line[/Figure .*/] }.sort
    assert_equal [17, 2, 5, 16], %w[Listing Table Mode Test].map { |kind| reported.count { |line| line.match?(/: #{kind} .* no row/) } }
  end

  private

  # Complaints about these lines by themselves.
  def complaints_of(lines)
    ThesisPage.new(ROOT, lines.join("\n"), sources: SOURCES).complaints.grep_v(/has no row/)
  end
end
