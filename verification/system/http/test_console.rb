# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the console in a real browser shows what a running system does, and says when it does not know.
# app/console/e2e/console.e2e.ts runs once; each test here is the verdict of its part for one requirement.
# With BORESIGHT_SCREENSHOT=FILE it leaves a picture of the console.

require_relative '../support/console_run'

class TestConsole < Minitest::Test
  include BrowserVerdicts
  extend ConsoleRun

  FILE = 'console.e2e.ts'

  def test_SWR_CON_001_the_banner_says_what_is_needed_next
    assert_parts 'SWR-CON-001'
  end

  def test_SWR_CON_002_lamps_and_buttons_are_for_everybody
    assert_parts 'SWR-CON-002'
  end

  def test_SWR_CON_003_the_rows_follow_the_axes
    assert_parts 'SWR-CON-003'
  end

  def test_SWR_CON_004_a_frozen_server_is_seen_to_be_stale
    assert_parts 'SWR-CON-004'
  end

  def test_SWR_CON_005_the_reasons_stand_beside_each_axis
    assert_parts 'SWR-CON-005'
  end

  def test_SWR_CON_047_a_motion_that_begins_moves_nothing_else
    assert_parts 'SWR-CON-047'
  end

  def test_SWR_CON_020_one_word_says_whether_it_moves
    assert_parts 'SWR-CON-020'
  end

  def test_SWR_CON_021_what_is_not_known_is_not_shown_as_known
    assert_parts 'SWR-CON-021'
  end

  def test_SWR_CON_022_every_window_theme_and_hand
    assert_parts 'SWR-CON-022'
  end

  def test_SWR_CON_023_help_explains_and_covers_no_stop
    assert_parts 'SWR-CON-023'
  end

  def test_SWR_CON_024_the_first_load_is_small
    assert_parts 'SWR-CON-024'
  end

  def test_SWR_HTTP_004_the_browser_accepts_all_and_asks_nobody_else
    assert_parts 'SWR-HTTP-004'
  end
end
