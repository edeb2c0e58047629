# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: any page of the console in a real browser stops the motion, and one page at a time commands. Nine pages are late
# on a machine that does something else, so it is left to them.
# app/console/e2e/stop.e2e.ts runs once; each test here is the verdict of its part for one requirement.
# With BORESIGHT_SCREENSHOT=FILE it leaves a picture of the console.

require_relative '../support/console_run'

class TestConsoleStop < Minitest::Test
  include BrowserVerdicts
  extend ConsoleRun

  FILE = 'stop.e2e.ts'

  def test_SWR_CON_006_tabs_share_a_stream_and_a_stop_leaves_from_each
    assert_parts 'SWR-CON-006'
  end

  def test_SWR_CON_007_a_stop_that_failed_cannot_be_overlooked
    assert_parts 'SWR-CON-007'
  end

  def test_SWR_CON_008_stopped_is_seen_and_not_remembered
    assert_parts 'SWR-CON-008'
  end

  def test_SWR_CON_009_the_stop_is_always_there
    assert_parts 'SWR-CON-009'
  end

  def test_SWR_CON_010_one_press_is_one_stop
    assert_parts 'SWR-CON-010'
  end

  def test_SWR_CON_011_one_console_too_many_is_given_the_reason
    assert_parts 'SWR-CON-011'
  end

  def test_SWR_CON_012_who_commands_is_seen_by_everybody
    assert_parts 'SWR-CON-012'
  end

  def test_SWR_CON_013_who_asks_for_the_button_is_seen_by_everybody
    assert_parts 'SWR-CON-013'
  end

  def test_SWR_CON_014_a_page_takes_command_and_keeps_it
    assert_parts 'SWR-CON-014'
  end

  def test_SWR_CON_015_a_page_that_has_gone_does_not_command
    assert_parts 'SWR-CON-015'
  end

  def test_SWR_HTTP_002_stop_by_button_and_by_key
    assert_parts 'SWR-HTTP-002'
  end

  def test_SWR_SESS_012_a_browser_logs_in_and_out
    assert_parts 'SWR-SESS-012'
  end

  def test_SWR_HTTP_004_the_browser_accepts_all_and_asks_nobody_else
    assert_parts 'SWR-HTTP-004'
  end
end
