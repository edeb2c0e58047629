#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The test of thesis 5.3, figures 29 to 31: the yaw axis of the NeuroRobot goes 600 ticks at 833 ticks/s. On the simulated
# control box, commanded over HTTP, under the foot pedal; drawn from the recording.
#
#   ruby verification/demo/velocity.rb [PICTURE.svg]     or make velocity
#
# Leaves in build/demo/velocity the black box, motion.csv and, unless another place is said, yaw.svg. Prints what was reached
# and how even the measured speed is.

require 'fileutils'
require_relative 'manual_page'
require_relative 'report'
require_relative '../../tools/recorded_run'
require_relative '../system/support/boresight'

# The motion, and what its recording shows.
class VelocityTest
  include ManualPage

  OUT = File.expand_path('../../build/demo/velocity', __dir__)
  AXIS = 'yaw'
  WAY_TICKS = 600
  SPEED_TICKS_PER_S = 833
  DEGREES_PER_TICK = 180 / Math::PI / 795.8
  # Counts of 0 or 1 in cycles of 1 ms, of which 83.3 percent have one: thesis 5.3.
  THESIS_NOISE = 1000 * Math.sqrt(0.833 * 0.167)

  def perform
    FileUtils.rm_rf(OUT)
    FileUtils.mkdir_p(OUT)
    robot = Boresight.start(arguments: ['--robot', 'neuro', '--recordings', OUT, '--accounts', Accounts.make(File.join(OUT, 'accounts'))])
    robot.home
    robot.leave
    run(robot, page(robot))
    robot.stop
  ensure
    robot&.kill_all
  end

  # Draws it; returns [name, value] pairs.
  def report(picture)
    csv = File.join(OUT, 'motion.csv')
    run = RecordedRun.new(OUT, Boresight.program('boresight-replay'))
    run.write_table(csv) || abort("velocity: no table of the whole run: #{run.said}")
    rows = DemoReport.read(csv, AXIS)
    move = DemoReport.moves(rows).max_by { |part| part.map { |row| row[:setpoint_ticks_per_s].abs }.max }
    DemoReport.gnuplot('axis.gnuplot', source: csv, picture: picture, axis: AXIS, from: move.first[:time] - 0.2,
                                       to: move.last[:time] + 0.3)
    figures(rows, move)
  end

  private

  def run(robot, page)
    speed = -SPEED_TICKS_PER_S * DEGREES_PER_TICK
    asked = { speeds: [{ axis: AXIS, speed_per_s: speed.round(6), unit: 'deg' }], way: (WAY_TICKS * DEGREES_PER_TICK).round(6),
              unit: 'deg' }
    expect(page.act('velocity', asked), 'accepted')
    robot.simctl('pedal', 'press')
    robot.wait_until('it has ended') { state(page.act('velocity', asked, id: page.id)) == 'done' }
    robot.simctl('pedal', 'release')
    robot.await_released_pedal
  end

  def figures(rows, move)
    cruise = move.select { |row| row[:setpoint_ticks_per_s].abs == SPEED_TICKS_PER_S }
    # The motor gains speed for a while yet.
    speeds = cruise.drop(5).map { |row| row[:ticks_per_s].abs }
    mean = speeds.sum / speeds.size
    noise = Math.sqrt(speeds.sum { |speed| (speed - mean)**2 } / speeds.size)
    start = move.first[:position_ticks]
    { 'way, ticks' => (rows.last[:position_ticks] - start).abs, 'time, s' => move.last[:time] - move.first[:time],
      'mean speed, ticks/s' => mean, 'noise of the measured speed, ticks/s' => noise,
      'farthest from the set-point, ticks' => move.map { |row| (row[:setpoint_ticks] - row[:position_ticks]).abs }.max }
  end
end

if $PROGRAM_NAME == __FILE__
  picture = ARGV.fetch(0, File.join(VelocityTest::OUT, 'yaw.svg'))
  test = VelocityTest.new
  test.perform
  puts format('%-40s %10s %10s', 'thesis 5.3: 600 ticks at 833 ticks/s', 'ours', 'thesis')
  thesis = { 'way, ticks' => '600 +-1', 'noise of the measured speed, ticks/s' => format('%.0f', VelocityTest::THESIS_NOISE) }
  test.report(picture).each { |name, value| puts format('%-40s %10.2f %10s', name, value, thesis[name]) }
  puts "The picture is #{picture.delete_prefix("#{Dir.pwd}/")}."
end
