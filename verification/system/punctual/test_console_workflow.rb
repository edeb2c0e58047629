# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: with nothing but the browser a needle comes to its target, positions are saved and restored, command
# passes from one to another, any page stops, and a page outlives its server. A page that is starved loses authority, as it
# must, so the machine is left to it.
# app/console/e2e/workflow.e2e.ts runs once, its parts in order; each test here is the verdict of its part for one
# requirement. With BORESIGHT_PICTURES=FOLDER it leaves the pictures of the documents there; `make pictures` does so.
# With BORESIGHT_ROBOT=prostate the needle of the ProstateRobot goes to its target, which takes minutes, and nothing else is
# done.

require_relative '../support/browser_run'
require_relative '../support/session_client'
require_relative '../support/system_test'

class TestConsoleWorkflow < Minitest::Test
  include BrowserVerdicts

  ROBOT = ENV.fetch('BORESIGHT_ROBOT', 'neuro')

  PICTURES = ENV.fetch('BORESIGHT_PICTURES', nil)

  def self.results
    @results ||= BrowserRun.results('workflow.e2e.ts', environment, *('--testNamePattern=SWR-CON-042' if ROBOT == 'prostate')).tap { join_frames if PICTURES }
  ensure
    boresight.kill_all
  end

  # The moving picture.
  def self.join_frames
    frames = Dir.glob(File.join(PICTURES, 'frames', '*.png')).sort
    words = %w[img2webp -loop 0 -lossy -q 60 -d 600] + frames + ['-o', File.join(PICTURES, 'procedure.webp')]
    system(*words, out: File::NULL) || raise('img2webp, of the Debian package webp, has failed')
  end

  def self.boresight
    @boresight ||= Boresight.start(arguments: ['--robot', ROBOT, '--accounts', Accounts.make_for_a_while])
  end

  def self.environment
    { 'BORESIGHT_URL' => "http://127.0.0.1:#{boresight.http_port}/", 'BORESIGHT_ROBOT' => ROBOT,
      'BORESIGHT_ENGINEER' => login('egon'), 'BORESIGHT_OPERATOR' => login('anna'),
      'BORESIGHT_HTTP_PID' => boresight.pid_of('http').to_s }
  end

  def self.login(name)
    "#{name} #{Accounts::PASSWORDS.fetch(name).last}"
  end

  def test_SWR_CON_042_a_needle_goes_to_its_target_by_the_browser_alone
    assert_parts 'SWR-CON-042'
  end

  unless ROBOT == 'prostate'
    def test_SWR_CON_028_positions_are_saved_and_restored
      assert_parts 'SWR-CON-028'
    end

    def test_SWR_CON_014_command_passes_from_browser_to_browser
      assert_parts 'SWR-CON-014'
    end

    def test_SWR_HTTP_002_who_only_looks_on_stops
      assert_parts 'SWR-HTTP-002'
    end

    def test_SWR_SESS_035_a_page_says_why_its_session_has_not_outlived_its_server
      assert_parts 'SWR-SESS-035'
    end

    def test_SWR_CON_043_a_killed_server_is_seen_and_outlived
      assert_parts 'SWR-CON-043'
    end
  end
end
