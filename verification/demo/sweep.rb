#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The frequency sweep of the ProstateRobot's rotation (thesis 4.3.3), on the simulated control box, commanded over HTTP, under the
# foot pedal; it takes about six minutes. Draws it beside the published one.
#
#   ruby verification/demo/sweep.rb [PICTURE.svg [SWEEP.csv]]     or make sweep
#
# With the table of a sweep, as GET /api/v1/sweep.csv gives it, only draws that. Otherwise leaves in build/demo/sweep the black box,
# sweep.csv and, unless another place is said, sweep.svg.

require 'fileutils'
require_relative 'manual_page'
require_relative 'report'
require_relative '../system/support/boresight'

# The sweep, and its picture.
class SweepDemo
  include ManualPage

  OUT = File.expand_path('../../build/demo/sweep', __dir__)
  TABLE = File.join(OUT, 'sweep.csv')
  PUBLISHED = File.expand_path('published_sweep.csv', __dir__)
  AXIS = 'rotation'
  # Full speed of the robot's file, 1928 ticks/s of 1666.7 a turn, is that of the published table at 50.862 kHz.
  SCALE = 1928 / 1666.74 * 60 / ((141.4 + 138.2) / 2)

  def perform
    FileUtils.rm_rf(OUT)
    FileUtils.mkdir_p(OUT)
    robot = Boresight.start(arguments: ['--robot', 'prostate', '--recordings', OUT, '--accounts', Accounts.make(File.join(OUT, 'accounts'))])
    robot.home
    robot.leave
    run(robot, page(robot))
    robot.stop
  ensure
    robot&.kill_all
  end

  # Draws a table; returns the largest deviation from the published one, in percent, of speeds above a turn a minute.
  def draw(table, picture)
    DemoReport.gnuplot('sweep.gnuplot', source: table, published: PUBLISHED, picture: picture, scale: SCALE)
    rows(table).flat_map { |hertz, *speeds| deviations(hertz / 1000.0, speeds) }.max
  end

  def rows(table)
    lines = File.readlines(table, chomp: true).grep(/\A\d/)
    lines.map { |line| line.split(',').values_at(0, 3, 4).map(&:to_f) }
  end

  private

  def run(robot, page)
    asked = { axis: AXIS, is_free: true }
    expect(page.act('motion/sweep', asked), 'accepted')
    robot.simctl('pedal', 'press')
    await_end(robot, page)
    robot.simctl('pedal', 'release')
    robot.await_released_pedal
    robot.wait_until('it is kept') { state(page.request('get', '/api/v1/sweep')) == 'kept' }
    File.write(TABLE, page.request('get', '/api/v1/sweep.csv').body)
  end

  # Each run is waited for.
  def await_end(robot, page)
    runs = 0
    until state(page.act('motion/sweep', { axis: AXIS, is_free: true }, id: page.id)) != 'accepted'
      robot.wait_until('a run is over') { page.keep && (ended?(robot) || runs_of(robot) > runs) }
      runs = runs_of(robot)
    end
    abort("sweep: #{page.last.body}") unless state(page.last) == 'done'
  end

  def runs_of(robot)
    robot.log.count { |entry| entry['name'] == 'SWEEP_WORD' }
  end

  def ended?(robot)
    robot.status['order'] == 'none'
  end

  def deviations(khz, speeds)
    speeds.each_index.filter_map do |column|
      said = published(khz, column + 1) * SCALE
      (speeds[column] - said).abs / said * 100 if said > 1
    end
  end

  # Between its points as a straight line.
  def published(khz, column)
    @published ||= File.readlines(PUBLISHED, chomp: true).grep(/\A\d/).map { |line| line.split(',').map(&:to_f) }
    slower, faster = @published.each_cons(2).find { |a, b| khz <= a[0] && khz >= b[0] }
    return 0 unless slower

    slower[column] + ((faster[column] - slower[column]) * (slower[0] - khz) / (slower[0] - faster[0]))
  end
end

if $PROGRAM_NAME == __FILE__
  demo = SweepDemo.new
  demo.perform unless ARGV[1]
  table = ARGV.fetch(1, SweepDemo::TABLE)
  picture = ARGV.fetch(0, File.join(SweepDemo::OUT, 'sweep.svg'))
  farthest = demo.draw(table, picture)
  demo.rows(table).each { |row| puts format('%8.0f Hz %9.3f up %9.3f down, turns a minute', *row) }
  puts format('Above a turn a minute at most %.1f percent from the published table times %.3f.', farthest, SweepDemo::SCALE)
  puts "The picture is #{picture.delete_prefix("#{Dir.pwd}/")}."
end
