# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the console in a real browser shows what a running system does, and says when it does not know.
# app/console/e2e/console.e2e.ts runs once; each test here is the verdict of its part for one requirement.
# With BORESIGHT_SCREENSHOT=FILE it leaves a picture of the console.

require 'socket'
require_relative '../support/browser_run'
require_relative '../support/system_test'

# Commands START_UP whenever its address is asked for. The peer stays connected: control stops what the peer has
# armed when it leaves.
class StartUpService
  def initialize(port)
    @peer = WorkphasePeer.new(port)
    @server = TCPServer.new('127.0.0.1', 0)
    @thread = Thread.new { serve }
  end

  def url
    "http://127.0.0.1:#{@server.addr[1]}/"
  end

  def close
    @thread.kill
    @server.close
    @peer.close
  end

  private

  def serve
    1.step do |number|
      client = @server.accept
      nil until client.gets.to_s.strip.empty?
      @peer.command(format('CMD_%04d', number), 'START_UP')
      client.write("HTTP/1.1 204 No Content\r\nConnection: close\r\n\r\n")
      client.close
    end
  end
end

class TestConsole < Minitest::Test
  include BrowserVerdicts

  # Time passes so much more slowly that homing does not end while a slow machine waits with the pedal pressed. START_UP
  # would arm nothing in a homed robot.
  SLOW = %w[--slow 8].freeze

  # Results of one run against one system.
  def self.results
    @results ||= with_system { |boresight, service| BrowserRun.results('console.e2e.ts', environment(boresight, service)) }
  end

  def self.with_system
    boresight = Boresight.start(arguments: SLOW)
    service = StartUpService.new(boresight.brp_port)
    yield boresight, service
  ensure
    service&.close
    boresight&.kill_all
  end

  def self.environment(boresight, service)
    { 'BORESIGHT_URL' => "http://127.0.0.1:#{boresight.http_port}/",
      'BORESIGHT_LOGIN_CODE' => boresight.output[/^Login: +([A-Z2-9-]{14}) /, 1],
      'BORESIGHT_HTTP_PID' => boresight.pid_of('http').to_s,
      'BORESIGHT_SIMCTL' => "#{Boresight.program('boresight-simctl')} --box #{boresight.box}",
      'BORESIGHT_START_UP' => service.url }
  end

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

  def test_SWR_CON_047_a_motion_that_begins_moves_nothing_else
    assert_parts 'SWR-CON-047'
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
