# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'minitest/autorun'
require 'open3'
require 'tmpdir'
require_relative '../../compile/robots'

# Rule under test: the code that names all robots is made from their folders, and a robot more changes nothing of the others.
class RobotsTest < Minitest::Test
  ROOT = File.expand_path('../../..', __dir__)
  ROBOTS = File.join(ROOT, 'core/robot')
  BINARIES = File.join(ROOT, 'build/bin')

  # One has a coupled limit.
  KINEMATICS = Hash.new("axes: {a: [mm, along]}\ncoupled_limits: {}\n").merge!(
    'neuro' => "axes: {a: [mm, along]}\ncoupled_limits: {c: {axes: [a], unit: mm, curved: false, refusal: OFF}}\n"
  ).freeze

  def made(*names)
    Dir.mktmpdir do |folder|
      names.each do |name|
        FileUtils.mkdir_p(File.join(folder, name))
        File.write(File.join(folder, name, 'robot.yml'), '')
        File.write(File.join(folder, name, 'kinematics.yml'), KINEMATICS[name])
      end
      return Robots.new(folder, 'neuro')
    end
  end

  def test_SWR_ROBOT_014_each_folder_of_a_robot_is_a_case_of_each_switch
    source = made('neuro', 'bench2').source
    %w[bench2 neuro].each do |name|
      %w[forward inverse solve].each { |act| assert_includes(source, "#{name}_#{act}(robot, ") }
      assert_includes(source, "#include \"robot/#{name}/#{name}.h\"")
      assert_operator(source.scan("case ROBOT_KIND_#{name.upcase}:").size, :>=, 3)
    end
  end

  def test_SWR_ROBOT_021_a_robot_without_coupled_limits_needs_no_function_for_them
    source = made('neuro', 'bench2').source
    assert_includes source, 'value = neuro_coupled(robot, index, joints);'
    refute_includes source, 'bench2_coupled'
  end

  def test_SWR_ROBOT_014_a_kind_that_nobody_knows_is_refused
    assert_equal(2, made('neuro').source.scan('solution = {.status = STATUS_MEMORY_DAMAGED}').size)
    assert_equal(4, made('neuro').source.scan('default:').size)
  end

  def test_SWR_ROBOT_014_a_robot_more_changes_the_kind_of_none
    kind = made('neuro').header[/ROBOT_KIND_NEURO 0x\h+U/]
    assert_includes(made('aaa', 'neuro', 'zzz').header, kind)
    refute_nil(kind)
  end

  def test_SWR_ROBOT_014_no_function_is_called_by_a_pointer
    refute_includes(made('neuro', 'bench2').source, '(*')
  end

  def test_SWR_ROBOT_016_a_robot_is_found_by_its_name_among_all
    tables = made('neuro', 'bench2').tables
    assert_includes(tables, 'robots[] = {&robot_bench2, &robot_neuro};')
    assert_includes(made('neuro', 'bench2').names, 'names[] = {"bench2", "neuro"};')
  end

  def test_SWR_ROBOT_016_the_names_are_listed_as_words
    { %w[neuro] => 'neuro', %w[neuro bench2] => 'bench2 or neuro', %w[neuro aa bench2] => 'aa, bench2 or neuro' }
      .each { |names, words| assert_includes(made(*names).names, "return \"#{words}\";") }
  end

  # Symbols that are the table of a robot.
  TABLE = /^\h+ [rRdD] robot_(?:#{Dir.glob('*/robot.yml', base: ROBOTS).map { |path| File.dirname(path) }.join('|')})$/

  def linked(program)
    symbols, status = Open3.capture2('nm', File.join(BINARIES, program))
    assert(status.success?)
    symbols.scan(TABLE).size
  end

  def test_SWR_ROBOT_017_control_box_and_replay_link_all_robots_and_no_other_program_any
    all = Dir.glob('*/robot.yml', base: ROBOTS).size
    %w[-control -box -replay].each { |name| assert_equal(all, linked("boresight#{name}"), name) }
    ['', '-simctl', '-igtl', '-http', '-recorder'].each { |name| assert_equal(0, linked("boresight#{name}"), name) }
  end

  def test_SWR_ROBOT_017_no_source_of_core_board_and_programs_names_a_robot
    names = Dir.glob('*/robot.yml', base: ROBOTS).map { |path| "robot_#{File.dirname(path)}" }
    sources = Dir.glob('{core,bsp,app}/**/*.[ch]', base: ROOT).reject { |path| path.match?(%r{\Acore/robot/\w+/}) }
    refute_empty(sources)
    sources.each { |path| refute_match(/\b(?:#{names.join('|')})\b/, File.read(File.join(ROOT, path)), path) }
  end

  def test_SWR_ROBOT_014_a_folder_without_a_robot_is_none
    Dir.mktmpdir do |folder|
      FileUtils.mkdir_p(File.join(folder, 'notes'))
      refute_includes(Robots.new(folder, 'neuro').source, 'notes')
    end
  end
end
