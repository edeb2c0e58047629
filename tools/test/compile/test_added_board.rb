# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: a board is one folder. It is added to a copy of the project, and nothing else, and control, the
# supervisor and the programs that come with it are those of that board.

require 'fileutils'
require_relative '../../../verification/system/support/session_client'
require_relative '../../../verification/system/support/system_test'
require_relative '../../rooms'
require_relative '../project_copy'

class TestAddedBoard < SystemTest
  BOARD = 'lamp'
  FOLDER = File.join(__dir__, '../board', BOARD)
  PROGRAMS = %w[boresight boresight-control boresight-http boresight-igtl boresight-lamp boresight-recorder].freeze

  class << self
    # Where the board was added to and built.
    def built
      @built ||= added.tap do |copy|
        text, is_good = copy.make("BOARD=#{BOARD}", *PROGRAMS.map { |name| "build/bin/#{name}" })
        raise text unless is_good
      end
    end

    def added
      made.tap { |copy| FileUtils.cp_r(FOLDER, copy.path('bsp')) }
    end

    # It is no simulated one: it does not start without an account.
    def accounts
      @accounts ||= Accounts.make(File.join(built.folder, 'accounts'))
    end

    def made
      ProjectCopy.new.tap { |copy| Minitest.after_run { copy.remove } }
    end
  end

  def test_SWR_TOOL_016_a_board_that_is_not_there_is_refused_with_those_that_are
    text, is_good = self.class.made.make("BOARD=#{BOARD}", 'build/bin/boresight')
    refute is_good
    assert_match(/There is no board "#{BOARD}"; choose one of these with BOARD: .*\bsim\b/, text)
  end

  def test_SWR_TOOL_016_control_is_linked_anew_with_another_board
    copy = self.class.added
    ["BOARD=#{BOARD}", 'BOARD=sim', "BOARD=#{BOARD}"].each do |board|
      text, is_good = copy.make(board, 'build/bin/boresight-control')
      assert is_good, text
      assert_includes text, 'built build/gcc/bin/boresight-control'
    end
  end

  def test_SWR_TOOL_016_a_folder_that_is_added_is_a_board_that_runs
    assert_empty Rooms.new(self.class.built.folder).problems
    assert_says start, 'control: opened lamp:green/3', 'Lamp:        it shines green'
  end

  def test_SWR_SUP_006_the_programs_of_the_board_are_given_what_its_file_says
    one = start('--shade', 'deep/red', '--dim')
    assert_says one, "lamp: deep/red 3 --dim for-#{one.instance}", 'control: opened lamp:deep/red/3', 'Lamp:        it shines deep/red'
    assert_equal %w[lamp control recorder igtl http].sort, one.pids.keys.sort
  end

  def test_SWR_SUP_006_what_was_not_given_is_left_out
    one = start
    assert_says one, "lamp: green 3 for-#{one.instance}"
  end

  def test_SWR_SUP_006_everything_stops_when_one_of_them_ends
    one = start
    one.kill('lamp', 'KILL')
    assert_equal 4, one.wait_for_end
    assert_match(/^lamp ended .*everything stops/, one.output)
  end

  def test_SWR_SUP_007_its_options_are_taken_and_those_of_another_board_are_not
    { %w[--slow 2] => /"--slow" is no option/, %w[--times 1] => /"1" is no number for --times; give one from 2 to 9/,
      %w[--shade] => /--shade lacks its value, TEXT/, ['--shade', 'x' * 4096] => /Something is too long/ }.each do |words, sentence|
      text, status = Open3.capture2e(program, *words)
      assert_equal 2, status.exitstatus, text
      assert_match sentence, text
    end
    assert_match(/^  --shade TEXT +of its light\n  --times NUMBER +how .*\n  --dim +it shines less$/, Open3.capture2e(program, '--help').first)
  end

  def test_SWR_SESS_006_it_does_not_start_without_an_account
    one = Boresight.new(programs: File.dirname(program))
    one.launch
    assert_equal 3, one.wait_for_end
    assert_includes one.output, 'There is no account, and this board drives a real robot'
  ensure
    one&.kill_all
  end

  def test_SWR_SUP_008_nobody_says_that_no_robot_is_connected
    assert_nil start.status['box']
  end

  def test_SWR_BOX_021_without_orders_of_its_own_nobody_gives_it_any
    one = start
    page = SessionClient.new(one.http_port).tap { |client| client.log_in('anna') }
    refusals = { 'get' => nil, 'post' => '{"pedal": "hold"}', 'put' => nil, 'delete' => nil }.map do |method, body|
      JSON.parse(page.request(method, '/api/v1/box', body, SessionClient::PAGE => '7').body).fetch('code')
    end
    assert_equal ['NO_BOX'] * 4, refusals
    names = Open3.capture2e('nm', self.class.built.path('build/bin/boresight-http')).first
    assert_includes names, 'bsp_bench_is_offered'
    refute_match(/wire_/, names)
  end

  private

  def program
    self.class.built.path('build/bin/boresight')
  end

  def start(*arguments)
    boresight(arguments: ['--accounts', self.class.accounts, *arguments], programs: File.dirname(program))
  end

  def assert_says(one, *lines)
    wait_until('the status is shown') { one.output.include?('lamp control recorder igtl http ok') }
    lines.each { |line| assert_includes one.output, "#{line}\n" }
  end
end
