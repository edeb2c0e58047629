#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The workflow of a robot for its targets (core/robot/NAME/targets.yml), on the simulated control box, driven by a real
# OpenIGTLink client under the foot pedal: home, register, target, move, read back.
#
#   ruby verification/demo/demo.rb NAME     exits 1 if a limit of SWR-DEMO-001 or 002 is missed
#
# Leaves in build/demo/NAME: the black box (*.bsr), motion.csv, motion.png, the picture of one axis (figures 29 to 31
# of the thesis), targets.json, and points.csv with what the robot believes that it reached.

require 'English'
require 'fileutils'
require 'json'
require 'open3'
require_relative 'report'
require_relative 'targets'
require_relative 'workflow'
require_relative '../../tools/results'
require_relative '../system/support/boresight'

# One run of the workflow.
class Demo
  ROOT = File.expand_path('../..', __dir__)
  LIMITS = JSON.parse(File.read("#{ROOT}/build/gen/limits/limits.json")).to_h { |limit| limit.values_at('name', 'value') }

  # The rows of the table, and whether every one is within its limits.
  attr_reader :rows

  def initialize(robot, targets)
    @robot = robot
    @targets = targets
    @workflow = Workflow.new(robot)
  end

  def run
    puts 'Homing with the pedal held ...'
    @start_s = timed { @workflow.home }
    puts "Homed after #{@start_s} s of the robot's time"
    @workflow.register(@targets.registration)
    @rows = @targets.each_target.each_with_index.map { |target, index| reach(target, index + 1) }
  end

  def hit?
    @rows.all? { |row| row[:error_mm] <= LIMITS.fetch('demo_error_nm') / 1e6 }
  end

  def punctual?
    @start_s <= LIMITS.fetch('demo_start_s') && @rows.all? { |row| row[:move_s] <= LIMITS.fetch('demo_move_s') }
  end

  private

  def reach(target, number)
    propose(target.entry) if target.entry
    move_s = timed do
      @workflow.move(Geometry.rows(target.rotation, target.point), accepts_entry: !target.entry.nil?)
    end
    reached = @workflow.measured
    row = { number: number, target: target.point, reached: reached.map { |value| value.round(3) },
            error_mm: Geometry.distance(reached, target.point).round(4), thesis_mm: target.thesis, move_s: move_s }
    puts "Target #{number}: #{row[:error_mm]} mm after #{move_s} s"
    row
  end

  # Seconds of the robot's own time.
  def timed
    before = @robot.status['cycle']
    yield
    (@robot.status['cycle'] - before) * LIMITS.fetch('cycle_us') / 1e6
  end

  # The entry point goes the way TheraVision sends it, as a transform on the other port; whoever commands accepts it.
  def propose(entry)
    matrix = Geometry.rows(Geometry::IDENTITY, entry)
    _, status = Open3.capture2e(Boresight.program('boresight-client'), '--port', @robot.igtl_port.to_s,
                                "transform ENTRY_POINT #{matrix.join(' ')}", 'wait POINT entry_point')
    raise 'the entry point was not taken' unless status.success?
  end
end

# The result in the form that the trace reads; each robot leaves its own.
def result(test, passed, count)
  { test: test, file: 'verification/demo/demo.rb', result: passed ? 'pass' : 'fail', assertions: count,
    message: passed ? nil : 'A limit was missed; the table is in the log.' }
end

def leave_results(demo)
  count = demo.rows.size
  Results.leave([result('test_SWR_DEMO_001_the_targets_are_reached', demo.hit?, count),
                 result('test_SWR_DEMO_002_homing_and_moves_end_in_time', demo.punctual?, count + 1)])
end

def replay(recording)
  output, status = Open3.capture2e(Boresight.program('boresight-replay'), recording)
  puts output
  abort 'demo: the recording could not be replayed' unless status.success?
end

# Runs the workflow; returns what it did and the recording.
def perform(name, targets, out)
  FileUtils.rm_rf(out)
  FileUtils.mkdir_p(out)
  robot = Boresight.start(arguments: ['--robot', name, '--recordings', out])
  demo = Demo.new(robot, targets)
  demo.run
  robot.stop
  [demo, Dir[File.join(out, '*.bsr')].min]
ensure
  robot&.kill_all
end

def demonstrate(name)
  targets = Targets.new("#{Demo::ROOT}/core/robot/#{name}/targets.yml")
  out = "#{Demo::ROOT}/build/demo/#{name}"
  demo, recording = perform(name, targets, out)
  report = DemoReport.new(name, demo.rows, out)
  report.print_table(targets.note)
  replay(recording)
  csv = File.join(out, 'motion.csv')
  system(Boresight.program('boresight-replay'), '--table', recording, out: csv) || abort('demo: no table')
  report.leave(csv, targets.close_up)
  puts "Black box, table and pictures are in #{out.delete_prefix("#{Dir.pwd}/")}."
  leave_results(demo)
  abort 'demo: a target was missed' unless demo.hit?
  abort 'demo: homing or a move took too long' unless demo.punctual?
end

demonstrate(ARGV.fetch(0)) if $PROGRAM_NAME == __FILE__
