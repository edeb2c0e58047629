# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: each hazard that the simulated robot can show has a scene in which its control is seen to act, and would
# not be seen if that scene were another; a scene is a text that says nothing else when it is read and written; and what
# differs between two courses a page says as native code does.

require 'minitest/autorun'
require 'json'
require 'open3'
require 'tempfile'
require_relative '../../tools/trace/requirements'

class TestScenes < Minitest::Test
  ROOT = File.expand_path('../..', __dir__)
  MODULE = "#{ROOT}/build/site/robot.wasm"
  NATIVE = "#{ROOT}/build/gcc/bin/closed-loop-scene"
  HAZARDS = Trace::Requirements.load('requirements', ROOT).of_kind('HAZ')
  SCENES = HAZARDS.select { |hazard| hazard['scene'] }

  def node(script, *words, **options)
    said, status = Open3.capture2e('node', "#{__dir__}/#{script}", MODULE, *words, **options)
    assert status.success?, said
    said
  end

  # Reactions of the robot to all scenes.
  def played
    @@played ||= begin
      scenes = SCENES.to_h { |hazard| [hazard.id, { scene: hazard.scene, expects: hazard['expects'] }] }
      JSON.parse(node('scenes.mjs', stdin_data: JSON.generate(scenes)))
    end
  end

  def test_SWR_SITE_019_each_hazard_has_a_scene_or_the_reason_why_it_has_none
    assert_empty(HAZARDS.reject { |hazard| hazard['scene'] || hazard['no_scene'] }.map(&:id))
    puts "SWR-SITE-019: #{SCENES.size} of #{HAZARDS.size} hazards have a scene"
  end

  def test_SWR_SITE_019_the_control_of_each_scene_acts
    refute_empty SCENES
    assert_equal SCENES.to_h { |hazard| [hazard.id, []] }, played.transform_values { |result| result['missed'] }
  end

  # Otherwise what a scene expects would be so without its hazard.
  def test_SWR_SITE_019_no_scene_is_as_expected_without_its_last_input
    assert_empty(played.select { |_id, result| result['without'].empty? }.keys)
  end

  def test_SWR_SITE_017_a_scene_that_is_written_is_read_as_it_was_and_a_damaged_one_is_refused_or_another
    counts = JSON.parse(node('scene_text.mjs', '2000'))
    assert_equal [2000, []], counts.values_at('equal', 'wrong')
    assert_operator counts['refused'], :>, 1000
  end

  REFUSED = {
    'robot=neuro&seed=7' => 'At character 1: a scene is robot=NAME&seed=NUMBER&inputs=INPUTS.',
    'robot=Neuro&seed=7&inputs=' => 'At character 7: “Neuro” is no name of a robot.',
    'robot=neuro&seed=07&inputs=' => 'At character 18: “07” is no number from 0 to 4294967295.',
    'robot=neuro&seed=7&inputs=x:pedal,press' => 'At character 27: “x:pedal,press” does not begin with CYCLE:.',
    'robot=neuro&seed=7&inputs=9:pedal,press;8:pedal,release' => 'At character 41: cycle 8 stands behind a later one.',
    'robot=neuro&seed=7&inputs=9:pedal,kick' => 'At character 29: “pedal kick” is no order of the box and no command.',
    'robot=neuro&seed=7&inputs=9:JOG,axis=3,axis=3' => 'At character 40: axis is given twice.',
    'robot=neuro&seed=7&inputs=9:JOG,speed=3' =>
      'At character 33: “speed=3” is not FIELD=VALUE with one of id, source, peer, axis, to_ticks.',
    'robot=neuro&seed=7&inputs=9:JOG,to_ticks=3.5' => 'At character 42: “3.5” is nothing that to_ticks can be.',
    'robot=neuro&seed=7&inputs=9:card,3,silent;' => 'At character 43: “” does not begin with CYCLE:.',
    'robot=neuro&seed=7&inputs=9:estop,pull' => 'it is one'
  }.freeze

  def test_SWR_SITE_017_a_text_that_is_no_scene_is_refused_with_the_place_and_the_reason
    said = node('refused_scenes.mjs', stdin_data: "#{REFUSED.keys.join("\n")}\n")
    assert_equal REFUSED.values, said.lines(chomp: true)
  end

  # Both in the words of a scene; native code reads commands as numbers.
  HOMING = { 'neuro' => '100:WORKPHASE,workphase=START_UP;200:pedal,press',
             'prostate' => '100:WORKPHASE,workphase=START_UP;200:pedal,press' }.freeze
  NATIVE_HOMING = "100 command 1 0 1 1 1 0\n200 order pedal press\n"
  FORK = 1500
  CYCLES = 100

  # A change at FORK, said by native code and by the module.
  def said_of(robot, change)
    scene = "robot=#{robot}&seed=7&inputs=#{HOMING.fetch(robot)}"
    native = Tempfile.create('other') do |file|
      file.write("#{NATIVE_HOMING}#{FORK} order #{change.tr(',', ' ')}\n")
      file.flush
      Open3.capture2(NATIVE, robot, '7', (FORK + CYCLES).to_s, file.path, stdin_data: NATIVE_HOMING).first
    end
    [native, node('what_if.mjs', scene, "#{scene};#{FORK}:#{change}", FORK.to_s, CYCLES.to_s)]
  end

  def test_SWR_SITE_018_what_would_be_if_is_said_as_native_code_says_it
    { %w[neuro pedal,release] => /\ACycle 1500 \(1\.500 s\): .*: state pedal is opening, was pressed\./m,
      %w[prostate estop,pull] => /state workphase is EMERGENCY, was START_UP\..*event ESTOP_PULLED: /m,
      %w[neuro card,head,silent] => %r{cards/7 link is late, was live\.} }.each do |(robot, change), words|
      native, page = said_of(robot, change)
      assert_match words, native
      assert_equal native, page, "#{robot} #{change}"
    end
  end

  def test_SWR_SITE_018_what_was_so_anyway_makes_no_difference
    assert_equal ['', ''], said_of('neuro', 'pedal,press')
  end
end
