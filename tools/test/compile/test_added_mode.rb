# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: a mode is one folder and one row. They are added to a copy of the project, and nothing else; then the mode
# is commanded by HTTP, by OpenIGTLink and by a button, refused with reasons, shown, recorded, replayed and documented.

require 'fileutils'
require_relative '../../rooms'
require_relative '../../tables'
require_relative '../project_copy'
require_relative '../../../verification/demo/workflow'
require_relative '../../../verification/system/support/session_client'
require_relative '../../../verification/system/support/system_test'

class TestAddedMode < SystemTest
  MODE = 'tremble'
  FOLDER = File.join(__dir__, '../mode', MODE)
  ROW = File.join(FOLDER, 'row.yml')
  PATH = "/api/v1/#{MODE}".freeze
  PROGRAMS = %w[boresight boresight-box boresight-control boresight-http boresight-igtl boresight-recorder
                boresight-replay boresight-simctl].freeze

  class << self
    # Where the mode was added to and built.
    def built
      @built ||= ProjectCopy.new.tap do |copy|
        Minitest.after_run { copy.remove }
        add(copy)
        text, is_good = copy.make(*PROGRAMS.map { |name| "build/bin/#{name}" })
        raise text unless is_good
      end
    end

    private

    def add(copy)
      FileUtils.mkdir_p(copy.path("core/mode/#{MODE}"))
      FileUtils.cp(Dir.glob("#{FOLDER}/*.[ch]"), copy.path("core/mode/#{MODE}"))
      table = copy.path('core/interface/modes.yml')
      File.write(table, "#{File.read(table).chomp}\n#{File.read(ROW)}")
      FileUtils.cp_r(File.join(ProjectCopy::ROOT, 'docs'), copy.folder)
    end
  end

  def test_SWR_MODE_014_an_added_mode_runs_by_http_and_by_openigtlink_and_is_replayed
    robot = boresight(arguments: ['--accounts', Accounts.make_for_a_while, *Boresight::FAST], programs: self.class.built.path('build/bin'))
    robot.home_fast
    robot.leave
    assert_equal('Only in MANUAL.', reason(robot))
    assert_runs_by_http(robot)
    Workflow.new(robot).send(:order, 'TREMBLE')
    assert_replayed(robot)
  end

  def test_SWR_MODE_014_an_added_mode_has_its_button
    copy = self.class.built
    page = Dir.glob(copy.path('build/console/assets/*.js')).map { |file| File.read(file) }.join
    assert_includes page, PATH
    text, status = Open3.capture2e('npx', 'vitest', 'run', 'src/views/ModesView.test.tsx', '--reporter', 'verbose',
                                   chdir: copy.path('app/console'))
    assert status.success?, text
    assert_match(/✓.*TREMBLE is commanded from its panel/, text)
  end

  def test_SWR_MODE_014_an_added_mode_is_of_the_manual_and_of_its_room
    copy = self.class.built
    assert_empty Rooms.new(copy.folder).problems
    text, status = Open3.capture2e('ruby', 'tools/tables.rb', '--root', copy.folder)
    assert status.success?, text
    assert_match(/`TREMBLE`.*The first axis goes a little way, and back\./, File.read(copy.path('docs/user-manual.md')))
    assert_includes File.read(copy.path('docs/user-manual.md')), PATH
  end

  private

  # In PLANNING it is refused, in MANUAL it moves and is shown.
  def assert_runs_by_http(robot)
    page = SessionClient.new(robot.http_port)
    page.log_in('anna')
    robot.wait_until('it has authority') { JSON.parse(page.take.body)['state'] == 'done' }
    answer = page.act(MODE)
    assert_equal(%w[409 WRONG_WORKPHASE], [answer.code, JSON.parse(answer.body)['code']], answer.body)
    page.act('workphase', { workphase: 'MANUAL' })
    robot.wait_until('it may be commanded') { reason(robot).nil? }
    assert_equal('202', page.act(MODE).code)
    assert_equal('TREMBLE', robot.status.dig('mode', 'name'))
    robot.simctl('pedal', 'press')
    answer = nil
    robot.wait_until('it ends') do
      page.keep
      answer = JSON.parse(page.act(MODE, {}, id: page.id).body)
      answer['state'] != 'accepted'
    end
    assert_equal('done', answer['state'], answer.inspect)
    robot.simctl('pedal', 'release')
    robot.await_released_pedal
    page.give_up
  end

  # nil: it may be commanded.
  def reason(robot)
    robot.send(:get, 'modes')['modes'].find { |mode| mode['name'] == 'TREMBLE' }.fetch('reason')
  end

  def assert_replayed(robot)
    Process.kill('TERM', robot.pid)
    robot.wait_for_end
    text, status = Open3.capture2e(self.class.built.path('build/bin/boresight-replay'), robot.recording_files.last)
    assert status.success?, text
    assert_match(/^(\d+) of \1 cycles replayed, every output equal$/, text)
  end
end
