# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# The rule under test: the command line writes all or nothing, and says in one line what stands in its way.

require 'fileutils'
require 'json'
require 'minitest/autorun'
require 'open3'
require 'rbconfig'
require 'tmpdir'
require_relative '../proof/generated_test'

class TestChartCommand < Minitest::Test
  COMPILER = File.expand_path('../chartc', __dir__)
  FOLDER = File.join(__dir__, 'charts')
  LIMITS = { 'short_us' => 1000, 'tiny_us' => 500, 'cycle_us' => 1000 }.freeze

  def test_SWR_CHART_003_the_same_id_in_two_charts_is_refused
    with_charts('base', 'twin') do |source, target|
      File.write(File.join(source, 'twin.scxml'), chart('base').sub('name="base"', 'name="twin"'))
      _output, errors, status = compile(source, target)
      assert_equal 1, status.exitstatus
      assert_match(/twin\.scxml:5: CHART-R08 T-T01 stands in .*base\.scxml/, errors)
    end
  end

  def test_SWR_CHART_003_one_refused_chart_and_nothing_is_written
    with_charts('base', 'r07_unknown_target') do |source, target|
      _output, errors, status = compile(source, target)
      assert_equal 1, status.exitstatus
      assert_match(/CHART-R07/, errors)
      refute_path_exists File.join(target, 'charts')
    end
  end

  # What the message says, what of the test stands in the file.
  EXAMPLES = {
    'r22_overlapping_guards' => [/: CHART-R22 .* reached by: go, halt with is_ready;/, 't_t03',
                                 '!(inputs.is_ready && true)'],
    'r23_invariant_violated' => [/: CHART-R23 .* reached by: go, pull;/, 't_i01',
                                 'R23_INVARIANT_VIOLATED_EVENT_PULL);'],
    'r25_event_forgotten' => [/: CHART-R25 .* reached by: go;/, 'on_go', 'chart.trace.count != before']
  }.freeze

  EXAMPLES.each do |name, (message, id, words)|
    define_method("test_SWR_CHART_013_the_command_line_reports_and_writes_the_way_to_#{name}") do
      with_charts(name) do |source, target|
        output, errors, status = compile(source, target)
        path = File.join(target, "counterexamples/test_#{id}_counterexample.c")
        assert_equal ['', 1], [output, status.exitstatus]
        assert_match message, errors
        assert_match(/^#{path}: /, errors)
        assert_includes File.read(path), words
        code = %w[c h].map { |ending| "counterexamples/#{name}_chart.#{ending}" }
        assert_equal [*code.map { |file| File.join(target, file) }, path, limits_of(target)], files(target)
      end
    end

    define_method("test_SWR_CHART_013_what_the_command_line_writes_of_#{name}_compiles_as_it_stands_and_is_red") do
      with_charts(name) do |source, target|
        compile(source, target)
        folder = File.join(target, 'counterexamples')
        test = GeneratedTest.new(File.join(folder, "test_#{id}_counterexample.c"), folder, source)
        output, status = Open3.capture2e(test.program(File.join(folder, "#{name}_chart.c")))
        assert_equal 1, status.exitstatus, output
        assert_match(/^1 Tests 1 Failures 0 Ignored/, output)
      end
    end
  end

  def test_SWR_CHART_013_drawing_the_charts_leaves_counterexamples_alone
    with_charts('r25_event_forgotten') do |source, target|
      compile(source, target)
      before = files(target)
      refute run_compiler('page', source, target).last.success?
      assert_equal before, files(target)
    end
  end

  # --- trouble that is not of the charts ---

  # What stands where the compiler reads or writes, and which path is named.
  TROUBLE = {
    'a_folder_named_as_a_chart' => ->(source, _target) { FileUtils.mkdir_p("#{source}/x.scxml") },
    'a_file_in_the_place_of_a_folder' => ->(_source, target) { FileUtils.touch("#{target}/tests") },
    'a_folder_in_the_place_of_a_file' => ->(_source, target) { FileUtils.mkdir_p("#{target}/tests/test_base_walk.c") }
  }.freeze

  TROUBLE.each do |name, prepare|
    define_method("test_SWR_CHART_003_#{name}_is_named_and_nothing_is_written") do
      with_charts('base') do |source, target|
        path = prepare.call(source, target).first
        before = files(target)
        _output, errors, status = compile(source, target)
        assert_match(/\A#{path}: [^:]*; correct the path, or what stands there\n\z/, errors)
        assert_equal [1, before], [status.exitstatus, files(target)]
      end
    end
  end

  def test_SWR_CHART_003_limits_that_are_no_json_are_named
    with_charts('base') do |source, target|
      File.write(limits_of(target), '[{')
      _output, errors, status = compile(source, target)
      assert_equal 1, status.exitstatus
      assert_match(/\A\S*limits\.json:1: CHART-R15 the file is no JSON; remove it[^\n]*\n\z/, errors)
    end
  end

  def test_SWR_CHART_003_a_page_in_the_place_of_a_file_is_refused_in_one_line
    with_charts('base') do |source, target|
      FileUtils.cp(limits_of(target), "#{target}/page")
      _output, errors, status = run_compiler('page', source, "#{target}/page", limits: target)
      assert_equal ["#{target}/page: Not a directory; correct the path, or what stands there\n", 1],
                   [errors, status.exitstatus]
    end
  end

  def test_SWR_CHART_013_counterexamples_of_before_are_gone_when_the_charts_are_read_again
    with_charts('r25_event_forgotten') do |source, target|
      compile(source, target)
      assert_path_exists File.join(target, 'counterexamples')
      FileUtils.rm(Dir[File.join(source, '*')])
      copy('base', source)
      assert compile(source, target).last.success?
      refute_path_exists File.join(target, 'counterexamples')
    end
  end

  def test_SWR_CHART_003_a_folder_without_charts_is_no_success
    with_charts do |source, target|
      _output, errors, status = compile(source, target)
      assert_equal ["#{source} is no chart, and no folder with charts\n", 1], [errors, status.exitstatus]
    end
  end

  def test_SWR_CHART_003_missing_limits_are_named
    with_charts('base') do |source, target|
      FileUtils.rm_r(File.join(target, 'limits'))
      _output, errors, status = compile(source, target)
      assert_equal 1, status.exitstatus
      assert_match(/limits\.json:1: CHART-R15 .*generate the limits first/, errors)
    end
  end

  def test_SWR_CHART_003_wrong_arguments_get_the_usage
    _output, errors, status = Open3.capture3(RbConfig.ruby, COMPILER)
    assert_equal 2, status.exitstatus
    assert_match(/\Ausage: /, errors)
  end

  private

  def chart(name)
    File.read(File.join(FOLDER, "#{name}.scxml"))
  end

  def with_charts(*names)
    Dir.mktmpdir do |folder|
      source = File.join(folder, 'charts_in')
      target = File.join(folder, 'gen')
      FileUtils.mkdir_p([source, File.join(target, 'limits')])
      names.each { |name| copy(name, source) }
      listed = LIMITS.map { |name, value| { name: name, value: value, requirement: 'SWR-CHART-003' } }
      File.write(File.join(target, 'limits', 'limits.json'), JSON.generate(listed))
      yield source, target
    end
  end

  def copy(name, source)
    file = File.join(FOLDER, "#{name}.scxml")
    FileUtils.cp(file, source) if File.exist?(file)
  end

  def compile(source, target)
    run_compiler('build', source, target)
  end

  # With these limits where the commands other than compile look for them.
  def run_compiler(*arguments, limits: arguments.last)
    Dir.mktmpdir do |folder|
      FileUtils.mkdir_p(File.join(folder, 'build'))
      File.symlink(limits, File.join(folder, 'build/gen'))
      Open3.capture3(RbConfig.ruby, COMPILER, *arguments, chdir: folder)
    end
  end

  def limits_of(target)
    File.join(target, 'limits/limits.json')
  end

  # Hidden ones too.
  def files(folder)
    Dir.glob(File.join(folder, '**/*'), File::FNM_DOTMATCH).sort.reject { |path| File.directory?(path) }
  end
end
