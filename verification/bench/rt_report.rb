#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# How punctual the control loop is for an hour (thesis 5.1, figures 20 to 23): the whole system in real time on the simulated box,
# that moves from target to target under the pedal, with a client of OpenIGTLink, consoles and requests. Read from the
# recordings, which have every cycle: if one is missing, it exits with 1.
#
#   ruby verification/bench/rt_report.rb      or make rt-report HOURS=1 (or MINUTES=2; PICTURE=file.svg)
#
# Leaves in build/rt-report: report.txt, histogram.csv, seconds.csv, stages.csv and rt-report.png; the recordings of a run with
# a gap.

$stdout.sync = true
require_relative 'crowd'
require_relative 'support'
require_relative '../../tools/intervals'
require_relative '../../tools/recorded_run'
require_relative '../demo/report'
require_relative '../system/support/session_client'

# One run, and the report on it.
class RealTimeReport
  OUT = File.join(ROOT, 'build/rt-report')
  RECORDINGS = File.join(OUT, 'recordings')
  LOAD = { consoles: 8 }.freeze
  LATE_US = 1500 # SWR-LOOP-001
  # Motions that are given up, beside those that are not.
  TIMEOUT = 5

  def self.seconds
    hours, minutes = ENV.values_at('HOURS', 'MINUTES').map { |text| text.to_s.empty? ? nil : Float(text) }
    (((hours || 0) * 3600) + ((minutes || 0) * 60)).then { |asked| asked.positive? ? asked : 3600 }
  rescue ArgumentError
    raise BenchFailed, 'HOURS and MINUTES are numbers'
  end

  def initialize(seconds, picture)
    @seconds = seconds
    @picture = picture
    @moves = 0
    @given_up = 0
  end

  def run
    FileUtils.rm_rf(OUT)
    FileUtils.mkdir_p(OUT)
    puts "Intervals of the control loop, #{duration} in real time"
    @check = checked
    @is_shared = Neighbours.new.any?
    measure
    @intervals = read
    leave
    puts text, "The tables and the picture are in #{OUT.delete_prefix("#{ROOT}/")}."
    raise BenchFailed, 'the recordings do not have the whole run' unless @is_whole
  end

  private

  def duration
    @seconds < 3600 ? format('%g minutes', @seconds / 60.0) : format('%g hours', @seconds / 3600.0)
  end

  # Before anything runs.
  def checked
    said, = Open3.capture2e(Boresight.program('boresight'), '--check')
    said.lines.drop(1).join
  end

  def measure
    robot = Boresight.start(arguments: ['--real-time', '--robot', TargetMove::ROBOT, '--recordings', RECORDINGS])
    Crowd.around(robot.http_port, **LOAD) { move(robot) }
    @is_shared ||= Neighbours.new.any?
    @loop = robot.status['loop']
    @counts = robot.status['counts']
    robot.stop
  ensure
    robot&.kill_all
  end

  def move(robot)
    target_move = TargetMove.new(robot)
    ends = Boresight.now + @seconds
    while Boresight.now < ends
      is_prepared ||= tried(robot) { target_move.prepare }
      is_prepared &&= tried(robot) { target_move.move }
      @moves += 1 if is_prepared
    end
  end

  # A cycle that is too late gives up a motion, as it shall, or makes its axis faulty: false.
  def tried(robot)
    yield
    true
  rescue RuntimeError => e
    @given_up += 1
    raise BenchFailed, "no motion ends: #{e.message}" if @given_up > TIMEOUT * (@moves + 1)

    robot.simctl('pedal', 'release')
    robot.await_released_pedal
    false
  end

  def read
    all = Intervals.new(LATE_US)
    run = RecordedRun.new(RECORDINGS, Boresight.program('boresight-replay'))
    @is_whole = run.each_interval { |line| all.add(line) }
    @missing = run.said
    raise BenchFailed, 'nothing was recorded' if all.cycles.zero?

    all
  end

  def leave
    tables = { histogram: @intervals.histogram_csv, seconds: @intervals.seconds_csv }.to_h do |name, csv|
      File.join(OUT, "#{name}.csv").then { |path| File.write(path, csv) && [name, path] }
    end
    DemoReport.gnuplot('../bench/rt_report.gnuplot', **tables, picture: @picture, longest: @intervals.counts.keys.max.to_f,
                                                               says: "#{duration} on #{machine}, in motion, with clients and consoles")
    FileUtils.rm_rf(RECORDINGS) if @is_whole
    File.write(File.join(OUT, 'stages.csv'), StageTimes.csv(@loop['stages']))
    File.write(File.join(OUT, 'report.txt'), "#{text}\n")
  end

  def text
    [head, Table.render(%w[interval us], interval_rows), Table.render(['stage', 'longest, us'], stage_rows), *remarks,
     "What boresight --check said before:\n#{@check}"].join("\n\n")
  end

  def head
    "#{File.read('/proc/version').strip}\n#{Time.now.utc.strftime('%Y-%m-%d %H:%M')} UTC, #{machine}; #{duration} in real time, " \
      "robot #{TargetMove::ROBOT} on the simulated control box\n" \
      "#{@moves} moves, #{@given_up} given up; #{LOAD[:consoles]} consoles with their streams and a client of OpenIGTLink"
  end

  def interval_rows
    quantiles = { 'p50' => 0.5, 'p99' => 0.99, 'p99.9' => 0.999, 'p99.99' => 0.9999, 'longest' => 1.0 }
    [['cycles', @intervals.cycles], ['not recorded', @intervals.missing], ["longer than #{LATE_US} us", @intervals.late],
     *quantiles.map { |says, share| [says, @intervals.quantile(share)] }, ['shortest', @intervals.counts.keys.min],
     ['page faults', @loop.values_at('minor_faults', 'major_faults').sum], ['wake-up, worst', @loop['wake_worst_us']],
     ['wake-up, p99', @loop['wake_p99_us']]]
  end

  def stage_rows
    @loop['stages'].map { |stage| [stage['name'].downcase, stage['worst_us']] }
  end

  def remarks
    late = @intervals.late_stages.sort_by { |_, count| -count }.map { |stage, count| "#{stage.downcase} #{count}" }
    lines = []
    lines << "Longest stage before a cycle that was late: #{late.join(', ')}." if late.any?
    lines << "This is #{machine}: without a real-time kernel the longest times are the machine's." unless @check.match?(/^ok  KERNEL/)
    lines << Neighbours::REMARK if @is_shared
    lines << "This is not the whole run:\n#{@missing}" unless @is_whole
    lines << "#{@counts['cycles_lost']} cycles found the recorder late." if @counts['cycles_lost'].positive?
    lines
  end
end

if $PROGRAM_NAME == __FILE__
  begin
    picture = ENV['PICTURE'].to_s.empty? ? File.join(RealTimeReport::OUT, 'rt-report.png') : ENV['PICTURE']
    RealTimeReport.new(RealTimeReport.seconds, picture).run
  rescue Interrupt
    code = 130
  rescue BenchFailed, Boresight::TimedOut, SystemCallError => e
    warn "rt-report: #{e.message}"
    code = 1
  ensure
    Boresight.running.dup.each(&:kill_all)
  end
  # The harness of the system tests would now run the tests of this program; it has none.
  exit! code || 0
end
