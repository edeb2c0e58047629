#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The workflow of a robot for its targets (core/robot/NAME/targets.yml), on the simulated control box, driven by a real
# OpenIGTLink client under the foot pedal, as figures 33 and 35 of the thesis have it: home, carry into the scanner, drape,
# register; target, move and read back, or align alone, insert by hand, by the robot or by both together; treat the last one, under
# the scanner if targets.yml says so; retract; turn away, so that the patient can leave. At the end a push that moves the needle's axis.
#
#   ruby verification/demo/demo.rb NAME     exits 1 if a limit of SWR-DEMO-001 or 002 is missed, or if SWR-DEMO-003,
#                                           SWR-THESIS-002, SWR-FLOW-004 or SWR-FLOW-007 is
#
# Leaves in build/demo/NAME: the black box (*.bsr), all of the run, motion.csv, motion.png, the picture of one axis (figures 29 to 31
# of the thesis), targets.json, and points.csv with what the robot believes that it reached.

require 'English'
require 'fileutils'
require 'json'
require 'open3'
require_relative 'cooperation'
require_relative 'report'
require_relative 'targets'
require_relative 'workflow'
require_relative '../../tools/recorded_run'
require_relative '../../tools/results'
require_relative '../system/support/boresight'

# One run of the workflow.
class Demo
  ROOT = File.expand_path('../..', __dir__)
  LIMITS = JSON.parse(File.read("#{ROOT}/build/gen/limits/limits.json")).to_h { |limit| limit.values_at('name', 'value') }

  # No viewer watches: up to so many times faster than the clock, or as fast as the machine can.
  SPEEDUP = 100
  # How long the robot is carried and what it reached is treated, of its own time.
  CARRY_S = 10
  DWELL_S = 5
  # How far a hand pushes the probe, and how far in vain at the end.
  PUSH_MM = 10
  WRONG_PUSH_MM = 1
  # Difference of the counts of an axis at rest.
  TREMBLE_TICKS = 2
  # An axis that is switched off runs out by up to 4 ticks, in at most 70 ms as recorded.
  RUN_OUT_CYCLES = 100

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
    rest('Carried into the scanner', CARRY_S)
    take_up(:before)
    @workflow.register(@targets.registration)
    @rows = @targets.each_target.each_with_index.map { |target, index| reach(target, index + 1) }
    scanned(@targets.images) { rest('The last target treated', DWELL_S, from: @targets.images ? :true_places : :places) }
    draw_out
    take_up(:after)
    push_axis if by_hand?
  end

  # Figure 33 as well: poses, and a probe that is inserted by hand.
  def by_hand?
    @targets.each_target.any? { |target| target.by == 'hand' }
  end

  # Figure 35: a hand at the handle.
  def by_cooperation?
    @targets.each_target.any? { |target| target.by == 'cooperation' }
  end

  def hit?
    @rows.all? { |row| row[:error_mm] <= LIMITS.fetch('demo_error_nm') / 1e6 }
  end

  def punctual?
    @start_s <= LIMITS.fetch('demo_start_s') && @rows.all? { |row| row[:move_s] <= LIMITS.fetch('demo_move_s') }
  end

  # A push of a probe that is not coupled was no fault and left all where it was, one of the axis was.
  def pushed?
    @pushed == %i[in out fault]
  end

  # Figure 35: both membranes were found and answered, no other, and the needle was drawn out before the next target.
  def felt?
    @cooperation.found_all? && @drawn.size == 2
  end

  # No rest has cost an axis its place, and the needle alone was drawn out.
  def whole?
    @kept.all? && @drawn.all? { |axes| axes.size == 1 }
  end

  private

  # While the scanner acquires, if it does; its fields disturb the counts.
  def scanned(images)
    @robot.simctl('scanner', 'on') if images
    yield
    @robot.simctl('scanner', 'off') if images
  end

  # The pedal is up. SWR-AXIS-022 bounds the sum of the counts of the axes. A scanner that acquires leaves wrong counts of axes that
  # stand, so then the box says where they are.
  def rest(what, seconds, from: :places)
    pass_cycles(RUN_OUT_CYCLES)
    strayed = moved(from) { pass(seconds) }
    keep(strayed.empty?)
    puts "#{what} for #{seconds} s: strayed: #{strayed.empty? ? 'none' : strayed}"
  end

  def draw_out
    drawn = moved { @workflow.retract }
    (@drawn ||= []) << drawn.keys
    keep(true)
    puts "Drawn out: #{drawn.keys.join(', ')}"
  end

  # A pose by its name, without which this robot does.
  def take_up(moment)
    return unless @targets.poses

    name = @targets.poses.fetch(moment)
    seconds = timed { @workflow.pose(name) }
    keep(true)
    puts "In the pose #{name} after #{seconds} s"
  end

  # The robot sees nothing of it.
  def insert_by_hand
    @pushed = []
    from = @robot.log.last['number'] + 1
    @robot.simctl('probe', 'free')
    { in: PUSH_MM, out: 0 }.each do |way, depth|
      strayed = moved { push_to(depth) }
      @pushed << way if strayed.empty? && @workflow.aligned? && faults(from).empty?
    end
    @robot.simctl('probe', 'coupled')
    keep(true)
    puts "By hand #{PUSH_MM} mm in and out again: #{@pushed.size == 2 ? 'aligned, no fault' : faults(from)}"
  end

  def push_to(depth)
    @robot.simctl('push', (depth - pushed_mm).round.to_s)
    @robot.wait_until("the probe is #{depth} mm in") { (pushed_mm - depth).abs < 0.001 }
  end

  def pushed_mm
    Float(@robot.simctl('show')[/and (\S+) mm in by hand/, 1])
  end

  def faults(from)
    @robot.log(from).reject { |event| event['severity'] == 'information' }.map { |event| event['name'] }
  end

  # The axis is coupled again: pushing it is reported.
  def push_axis
    from = @robot.log.last['number'] + 1
    @robot.simctl('push', WRONG_PUSH_MM.to_s)
    @robot.wait_until('the push is a fault') { faults(from).include?('AXIS_MOVED_OFF') }
    @pushed << :fault
    puts "Pushed by #{WRONG_PUSH_MM} mm with the axis coupled: #{faults(from).join(', ')}"
  end

  def keep(is_there)
    (@kept ||= []) << (is_there && @robot.status['is_homed'])
  end

  def pass(seconds)
    seconds.times { pass_cycles(1_000_000 / LIMITS.fetch('cycle_us')) }
  end

  def pass_cycles(count)
    last = @robot.status['cycle'] + count
    @robot.wait_until("#{count} cycles have passed") { @robot.status['cycle'] >= last }
  end

  # By how many ticks which axes have moved, beyond what their encoders tremble.
  def moved(from = :places)
    before = send(from)
    yield
    send(from).merge(before) { |_, now, past| now - past }.select { |_, ticks| ticks.abs > TREMBLE_TICKS }
  end

  def places
    @robot.motors['axes'].to_h { |axis| axis.values_at('name', 'position_ticks') }
  end

  def true_places
    @robot.box_axes.to_h { |row| [row[1], Float(row[4])] }
  end

  def reach(target, number)
    propose(target.entry) if target.entry
    move_s = travel(target)
    reached = @workflow.measured
    row = { number: number, target: target.point, reached: reached.map { |value| value.round(3) },
            error_mm: Geometry.distance(reached, target.point).round(4), thesis_mm: target.thesis, move_s: move_s }
    puts "Target #{number}: #{row[:error_mm]} mm after #{move_s} s"
    sample if target.by == 'cooperation'
    row
  end

  # Returns how long the robot has moved by itself.
  def travel(target)
    case target.by
    when 'cooperation' then cooperate(target)
    when nil then @robot.despite_pauses { timed { go(:move, target) } }
    else go_by_halves(target)
    end
  end

  # Returns how long the alignment took: how long an insertion takes is decided by the hand.
  def cooperate(target)
    @cooperation = Cooperation.new(@robot, @workflow)
    align_s = timed { go(:align, target) }
    @cooperation.insert(target)
    puts @cooperation.told
    align_s
  end

  def sample
    scanned(true) { rest('The sample taken', DWELL_S, from: :true_places) }
    draw_out
  end

  def go(motion, target)
    @workflow.public_send(motion, Geometry.rows(target.rotation, target.point), accepts_entry: !target.entry.nil?)
  end

  def go_by_halves(target)
    align_s = timed { go(:align, target) }
    insert_by_hand if target.by == 'hand'
    (align_s + timed { @workflow.insert }).round(3)
  end

  # Seconds of the robot's own time from each press of the pedal to the end of what it moved; the client's answers take longer.
  def timed
    from = @robot.log.last['number'] + 1
    yield
    ends = @robot.wait_until('the end is in the log') { held(from).then { |runs| runs if runs.any? } }
    ends.sum { |pressed, done| done - pressed } * LIMITS.fetch('cycle_us') / 1e6
  end

  # Cycles of a press and of the end that it led to.
  def held(from)
    events = @robot.log(from).select { |event| %w[PEDAL_PRESSED ORDER_DONE].include?(event['name']) }
    runs = events.each_cons(2).select { |pair| pair.map { |event| event['name'] } == %w[PEDAL_PRESSED ORDER_DONE] }
    runs.map { |pair| pair.map { |event| event['cycle'] } }
  end

  # The entry point goes the way TheraVision sends it, as a transform on the other port; the commanding client accepts it.
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

def leave_results(demo, is_replayed)
  count = demo.rows.size
  results = [result('test_SWR_DEMO_001_the_targets_are_reached', demo.hit?, count),
             result('test_SWR_DEMO_002_homing_and_moves_end_in_time', demo.punctual?, count + 1),
             result('test_SWR_DEMO_003_the_whole_run_is_replayed_and_every_output_is_equal', is_replayed, 2),
             result('test_SWR_THESIS_002_rests_cost_no_axis_its_place_and_the_needle_ends_out', demo.whole?, 3)]
  results << result('test_SWR_FLOW_007_a_hand_inserts_a_steered_needle_through_its_membranes', demo.felt?, 3) if demo.by_cooperation?
  results << result('test_SWR_FLOW_004_inserted_by_hand_or_by_the_robot', demo.pushed?, 3) if demo.by_hand?
  Results.leave(results)
end

# Replay of the whole run; writes its motion to the file `csv`.
def replay(out, csv)
  run = RecordedRun.new(out, Boresight.program('boresight-replay'))
  is_equal = run.replay
  puts run.said
  run.write_table(csv) && is_equal
end

# Runs the workflow; returns what it did.
def perform(name, targets, out)
  FileUtils.rm_rf(out)
  FileUtils.mkdir_p(out)
  robot = Boresight.start(arguments: ['--robot', name, '--recordings', out, '--fast', Demo::SPEEDUP.to_s])
  demo = Demo.new(robot, targets)
  demo.run
  robot.stop
  demo
ensure
  robot&.kill_all
end

def demonstrate(name)
  targets = Targets.new("#{Demo::ROOT}/core/robot/#{name}/targets.yml")
  out = "#{Demo::ROOT}/build/demo/#{name}"
  demo = perform(name, targets, out)
  report = DemoReport.new(name, demo.rows, out)
  report.print_table(targets.note)
  csv = File.join(out, 'motion.csv')
  is_replayed = replay(out, csv)
  report.leave(csv, targets.close_up)
  puts "Black box, table and pictures are in #{out.delete_prefix("#{Dir.pwd}/")}."
  leave_results(demo, is_replayed)
  abort 'demo: the whole run could not be replayed' unless is_replayed
  abort 'demo: a target was missed' unless demo.hit?
  abort 'demo: homing or a move took too long' unless demo.punctual?
  abort 'demo: an axis lost its place, or the needle did not end out' unless demo.whole?
  abort 'demo: a membrane was missed, invented or not answered' unless !demo.by_cooperation? || demo.felt?
  abort 'demo: a push was reported otherwise than it was' unless !demo.by_hand? || demo.pushed?
end

demonstrate(ARGV.fetch(0)) if $PROGRAM_NAME == __FILE__
