# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: a robot is one folder. A copy of the project is built without it; then the folder is added, and
# nothing else, and the programs home the robot, move it to its targets and replay what was recorded.

require 'fileutils'
require 'yaml'
require_relative '../project_copy'
require_relative '../../../verification/demo/targets'
require_relative '../../../verification/demo/workflow'
require_relative '../../../verification/system/support/system_test'

class TestAddedRobot < SystemTest
  ROBOT = 'bench2'
  FOLDER = "core/robot/#{ROBOT}".freeze
  # Made anew where a robot comes or goes; while it is gone, no page is looked at.
  PAGES = 'build/gen/assets/assets.c'
  PROGRAMS = %w[boresight boresight-box boresight-control boresight-http boresight-igtl boresight-recorder
                boresight-replay boresight-simctl].freeze
  NEAR_MM = 0.01

  def setup
    @copy = ProjectCopy.new
  end

  def teardown
    super
    @copy.remove
  end

  def test_SWR_ROBOT_018_a_folder_that_is_added_is_a_robot_that_homes_moves_and_is_replayed
    build_without_it
    build
    robot = boresight(arguments: ['--robot', ROBOT], programs: programs)
    assert_reaches_its_targets(robot)
    assert_equal(ROBOT, robot.status['robot'])
    names = YAML.safe_load_file(path("#{FOLDER}/robot.yml"))['axes'].map { |axis| axis['name'] }
    assert_equal(names, robot.motors['axes'].map { |axis| axis['name'] })
    assert_replayed(robot)
  end

  private

  def programs
    path('build/bin')
  end

  def path(name)
    @copy.path(name)
  end

  # Nothing of it is left, and no program knows it.
  def build_without_it
    FileUtils.mv(path(FOLDER), path('later'))
    FileUtils.rm_rf(Dir.glob(path("build/**/*#{ROBOT}*")))
    build('-o', PAGES)
    text = call("#{programs}/boresight --robot #{ROBOT}", fails: true)
    assert_match(/There is no robot "#{ROBOT}"; choose neuro/, text)
    FileUtils.mv(path('later'), path(FOLDER))
  end

  def build(*options)
    text, is_good = @copy.make(*options, *PROGRAMS.map { |name| "build/bin/#{name}" })
    assert is_good, text
  end

  def call(command, fails: false)
    text, status = Open3.capture2e(command)
    assert_equal(fails, !status.success?, text)
    text
  end

  def assert_reaches_its_targets(robot)
    workflow = Workflow.new(robot)
    targets = Targets.new(path("#{FOLDER}/targets.yml"))
    workflow.home
    workflow.register(targets.registration)
    targets.each_target.each do |target|
      workflow.move(Geometry.rows(target.rotation, target.point))
      workflow.measured.zip(target.point).each { |reached, wanted| assert_in_delta(wanted, reached, NEAR_MM) }
    end
  end

  def assert_replayed(robot)
    Process.kill('TERM', robot.pid)
    robot.wait_for_end
    text = call("#{programs}/boresight-replay #{robot.recording_files.last}")
    assert_match(/^(\d+) of \1 cycles replayed, every output equal$/, text)
  end
end
