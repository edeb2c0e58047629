# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: in no scene (an operator, who now and then draws the needle out, somebody who watches and proposes at
# any time, a world, a fault now and then; an enemy at the pedal and the fault keyboard; jogs; moves into the corners of
# the workspace, under a pedal that is released again and again, or of motors that are not as the robot's table says,
# with run and stop or magnitudes for cards without pwm; pages and connections that all want to command; one order of any
# mode after the other; treatment programs with their gate; sweeps; any hand at the needle, and load cells that break;
# an operator who follows the next step alone; cycles that come late,
# exchanges apart from them, a box that stands and wires that damage frames) does the controller of any robot break one of the
# sentences of the oracle, who knows where the simulated axes truly stand.
# `make supervise COUNT=n SEED=n PLAY=name ROBOT=name` plays more.

require 'minitest/autorun'
require 'open3'
require 'yaml'

class TestSupervise < Minitest::Test
  PROGRAM = File.expand_path('../../build/gcc/bin/supervise', __dir__)
  # And how much of the plays each gets.
  ROBOTS = { 'neuro' => 1.0, 'bench2' => 0.25, 'prostate' => 0.05 }.freeze
  # How many scenes, or moves; and flips of bits for each.
  PLAYS = { random: 74, corners: 24, interrupted: 24, spread: 30, magnitude: 30, jogs: 30, taps: 47,
            rivals: 50, modes: 14, programs: 6, sweeps: 60, operator: 40, late: 40, hands: 480 }.freeze
  # Those of scenes, whether or not a move comes about.
  SCENES = %i[random jogs taps rivals modes programs sweeps operator late hands].freeze
  # Card that an axis of the robot must have for a play, or the hand of its file; and the reason why not otherwise.
  NEEDS = { magnitude: ['non_pwm', 'no axis of it takes run and stop'],
            sweeps: ['high_frequency', 'no axis of it takes waves'],
            hands: ['hand', 'no hand moves its needle'] }.freeze
  FLIPS = 100
  # Commands that arm a motion, one row of orders.c each.
  MODES = %w[WORKPHASE RETRACT RUN_TRAJECTORY VELOCITY JOG_BY ALIGN INSERT POSE].freeze
  # Steps that the operator who knows these alone is shown in the scenes of a robot that has all of them.
  STEPS = %w[START_UP RELEASE_ESTOP CHECK_CARDS CHECK_BOX SCANNER WAIT CONFIRM PLACE SERVICE STOP AUTHORITY RECORDER
             PRESS_PEDAL RELEASE_PEDAL PLANNING CALIBRATION TARGETING MOVE NOTHING].freeze
  SENTENCES = {
    SWR_PERMIT_002_a_drive_leaves_only_with_the_permit: /A drive leaves only with/,
    SWR_AXIS_012_an_axis_held_for_homed_stands_where_it_is_believed_to: /A homed axis without a fault/,
    SWR_AXIS_016_an_axis_that_moves_while_off_does_not_stay_homed: /moves while off/,
    SWR_MOTION_005_a_move_ends: /under the pedal ends/,
    SWR_AXIS_013_homing_drives_the_needle_forwards_by_little_only: /drives the needle forwards/,
    SWR_AXIS_030_homing_drives_who_homes_and_who_follows_it: /drives who homes in its scenario/,
    SWR_NEXT_002_an_arrival_that_is_shown_is_true: /is reached": it is/,
    SWR_COUPLE_001_coupled_limits_are_kept: /Coupled limits are kept/,
    SWR_JOG_001_nothing_is_jogged_across_a_needle_that_is_in: /across a needle that is in/,
    SWR_JOG_003_a_needle_that_is_not_homed_is_not_jogged_inwards: /is not jogged inwards/,
    SWR_PLAN_018_what_is_proposed_changes_no_target: /changes no target/,
    SWR_MOTION_023_a_retraction_drives_the_needle_outwards_only: /drives the needle outwards only/,
    SWR_POSE_001_to_a_pose_the_needle_is_not_driven: /To a pose the needle/,
    SWR_ALIGN_002_to_line_up_the_needle_is_not_driven_in: /To line up the needle/,
    SWR_ALIGN_005_an_insertion_moves_no_other_axis: /An insertion moves no other/,
    SWR_JOG_004_jogs_speeds_sweeps_and_programs_drive_the_axes_that_they_name: /Jogs, speeds, sweeps and programs/,
    SWR_MODE_008_an_axis_that_was_disabled_is_not_driven: /that was disabled is not driven/,
    SWR_TRAJ_009_a_trajectory_keeps_each_axis_between_its_rows: /keeps each axis between its rows/,
    SWR_MODE_012_the_end_of_an_order_is_reported: /end of an order is reported/,
    SWR_SWEEP_005_waves_keep_their_range: /Waves are of 45 to 55 kHz/,
    SWR_SWEEP_002_a_sweep_drives_in_manual_with_the_needle_out: /A sweep drives in MANUAL/,
    SWR_SWEEP_004_what_a_sweep_reports_is_the_true_way_of_a_whole_run: /What a sweep reports/,
    SWR_SWEEP_006_a_sweep_is_done_with_its_points: /A sweep is done with points/,
    SWR_PROG_008_no_program_drives_while_the_gate_says_stop: /While the gate says stop/,
    SWR_PROG_006_a_step_ends_at_its_place_after_its_dwell_or_by_its_dose: /A step ends at its place/,
    SWR_PROG_011_a_program_is_done_once_its_steps_are: /treatment program is done once/,
    SWR_COOP_004_an_insertion_by_hand_drives_the_needle_alone_and_inwards: /An insertion by hand drives the needle alone/,
    SWR_COOP_003_no_hand_takes_the_true_needle_past_its_target: /No hand takes the true needle past/,
    SWR_COOP_013_without_a_hand_that_pushes_no_insertion_by_hand_goes_on: /Without a hand that truly pushes/,
    SWR_STEER_006_a_needle_that_is_steered_gains_no_depth_without_its_rotation: /needle that is steered gains no/,
    SWR_VIB_707_a_needle_that_vibrates_goes_no_deeper_than_its_stop: /needle that vibrates goes no deeper/,
    SWR_AXIS_019_no_fault_is_found_where_there_is_none: /nothing is broken, no fault/,
    SWR_CTRL_014_no_axis_is_called_faulty_for_time_or_wires: /of which nothing is broken is not called faulty/,
    SWR_MOTION_007_no_axis_goes_beyond_its_end: /beyond its end/,
    SWR_MOTION_007_no_axis_is_faster_than_its_speed: /faster than its speed/,
    SWR_AUTH_001_one_commands_and_none_before_the_axes_rest: /One commands: between two/,
    SWR_AUTH_008_authority_is_lost_by_its_holder_silence_or_the_button_without_the_pedal: /Authority is lost by/,
    SWR_AUTH_007_a_page_that_commands_has_renewed_it: /has renewed it/,
    SWR_AUTH_005_after_a_loss_nothing_is_driven: /After a loss nothing is driven/,
    SWR_AUTH_003_only_who_has_authority_arms: /Only who has authority arms/
  }.freeze

  # Facts of its file that decide what it can show.
  def self.facts(robot)
    YAML.safe_load_file(File.expand_path("../../core/robot//#{robot}/robot.yml", __dir__))
  end

  def self.card?(robot, card)
    facts(robot)['axes'].any? { |axis| axis['card'] == card }
  end

  def self.plays_without_card(robot)
    NEEDS.reject { |_, (need, _)| need == 'hand' ? facts(robot).key?('hand') : card?(robot, need) }
  end

  def self.plays_of_sentences(robot)
    PLAYS.keys - plays_without_card(robot).keys
  end

  def self.sentences(robot)
    SENTENCES.reject { |name, _| facts(robot)['coupled_limits'].empty? && name.start_with?('SWR_COUPLE') }
  end

  def self.play(robot, play)
    @played ||= {}
    count = play == :flips ? FLIPS : (PLAYS[play] * ROBOTS[robot]).ceil.clamp(2, nil) # One alone may end before its order.
    @played[[robot, play]] ||= Open3.capture2e(PROGRAM, '--robot', robot, count.to_s, '1', play.to_s)
  end

  def lines(robot, play)
    self.class.play(robot, play).first.lines(chomp: true)
  end

  ROBOTS.each_key do |robot|
    (plays_of_sentences(robot) - SCENES).each do |play|
      define_method("test_SWR_MOTION_006_moves_are_done_soon_after_their_profiles_#{robot}_#{play}") do
        ends = lines(robot, play).grep(/done after their profiles/)
        expected = self.class.card?(robot, 'non_pwm') ? 2 : 1
        assert_equal(expected, ends.grep(/\A[1-9].* 99 % by \d+ ms, in time\z/).size, lines(robot, play).join("\n"))
      end
    end

    define_method("test_SWR_AUTH_005_rivals_lose_authority_in_every_way_and_in_motion_#{robot}") do
      losses = lines(robot, :rivals).grep(/authority was lost/).first.scan(/\d+/).map(&:to_i)
      assert_equal 5, losses.size
      assert losses.all?(&:positive?) || ROBOTS[robot] < 1.0, losses.to_s
    end

    define_method("test_SWR_MODE_001_orders_of_every_mode_that_a_robot_has_end_as_asked_#{robot}") do
      done = lines(robot, :modes).grep(/orders that were done/).first.scan(/(\d+) of \d+ (\w+)/).to_h { |n, kind| [kind, n.to_i] }
      assert MODES.all? { |kind| done.fetch(kind, 0).positive? } || ROBOTS[robot] < 1.0, done.to_s
    end

    # He comes into a scene of any play, with anything broken, and knows nothing but the next step.
    define_method("test_SWR_NEXT_008_who_follows_the_next_step_gets_out_of_anything_#{robot}") do
      line = lines(robot, :operator).grep(/an operator who follows/).first
      assert_match(/: [1-9]\d* homed, .* 0 dead ends, 0 refusals, /, line, lines(robot, :operator).join("\n"))
    end

    define_method("test_SWR_NEXT_008_he_is_shown_steps_of_every_kind_#{robot}") do
      shown = lines(robot, :operator).grep(/scenes that showed/).first.scan(/([A-Z_]+) \d+/).flatten
      assert_empty STEPS - shown if ROBOTS[robot] == 1.0
      assert_includes shown, 'START_UP'
    end

    define_method("test_SWR_MODE_001_programs_sweeps_and_insertions_by_hand_end_as_asked_#{robot}") do
      plays = self.class.plays_of_sentences(robot) & %i[programs sweeps hands]
      plays.each do |play|
        orders = lines(robot, play).grep(/orders that were done/).first
        order = { sweeps: 'SWEEP', programs: 'RUN_PROGRAM', hands: 'COOPERATE' }.fetch(play)
        assert_match(/[1-9]\d* of \d+ #{order}/, orders)
      end
    end

    if plays_of_sentences(robot).include?(:hands)
      # Each of them would hold of scenes in which nothing is felt.
      define_method("test_SWR_VIB_707_hands_meet_membranes_vibrations_and_doubts_#{robot}") do
        events = lines(robot, :hands).grep(/\Aevents:/).first.scan(/(\d+) ([A-Z_]+)/).to_h { |count, name| [name, count.to_i] }
        %w[MEMBRANE_UNEXPECTED VIBRATION_BEGUN FORCE_DOUBTED].each { |name| assert_operator events.fetch(name), :>, 0, name }
      end
    end

    # 1 to 3 bits of the controller's memory change, at rest and in motion.
    define_method("test_SWR_MEMORY_007_no_bit_flip_ends_elsewhere_or_crashes_#{robot}") do
      text = lines(robot, :flips).join("\n")
      assert_equal 2, text.scan(/[1-9]\d* noticed, .* 0 wrong, 0 crashed$/).size, text
    end

    plays_of_sentences(robot).product(sentences(robot).to_a).each do |play, (name, sentence)|
      define_method("test_#{name}_#{robot}_#{play}") do
        line = lines(robot, play).grep(sentence).first
        assert line, lines(robot, play).join("\n")
        assert_match(/\bholds\z/, line)
      end
    end

    plays_without_card(robot).each do |play, (_, reason)|
      define_method("test_SWR_MOTION_022_a_play_that_a_robot_cannot_give_is_refused_#{robot}_#{play}") do
        text, status = self.class.play(robot, play)
        assert_equal([3, "The robot #{robot} cannot give this play: #{reason}.\n"], [status.exitstatus, text])
      end
    end
  end
end
