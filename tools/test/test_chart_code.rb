# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'fileutils'
require 'json'
require 'minitest/autorun'
require 'open3'
require 'rbconfig'
require 'tmpdir'
require_relative '../chart/command'

# The generated C against the interpreter, and the walk against broken C: a walk that cannot fail proves nothing.
class TestChartCode < Minitest::Test
  CHART = File.join(__dir__, 'charts', 'sample.scxml')
  COMPILER = File.join(__dir__, '..', 'chart_compiler.rb')
  UNITY = File.join(Gem::Specification.find_by_name('ceedling').gem_dir, 'vendor', 'unity')
  WARNINGS = %w[-std=c99 -pedantic -Wall -Wextra -Werror -Wconversion -Wsign-conversion -Wshadow -Wswitch-enum
                -Wcast-qual -Wmissing-prototypes].freeze

  # What a wrong emitter could do, as [pattern, replacement] on the C.
  FAULTS = {
    'a_swapped_target' => ['enter_heat(self, SAMPLE_HEAT_HIGH)', 'enter_heat(self, SAMPLE_HEAT_LOW)'],
    'a_lost_raise' => ['sample_raise_event(raised, SAMPLE_EVENT_HALT);', ''],
    'a_wrong_action' => ['return (SAMPLE_ACTION_COMPLAIN | SAMPLE_ACTION_BEEP);', 'return SAMPLE_ACTION_BEEP;'],
    'a_timer_not_cancelled' => ['    sample_stop_fast_end(self);', ''],
    'a_timer_not_restarted' => [/(take_sample_t06\(.*?)sample_start_heat_limit\(self\);/m, '\1'],
    'a_turned_guard' => ['if (!inputs->is_allowed)', 'if (inputs->is_allowed)'],
    'a_guard_that_sees_the_step' => ['sample_chart_in_work(before)', 'true'],
    'an_ancestor_first' => ['actions = take_sample_t09(self);', 'actions = take_sample_t04(self);'],
    'an_unguarded_internal_event' => [' && (event != SAMPLE_EVENT_STARTED)', ''],
    'a_timer_one_late' => ['self->boost_end_us >=', 'self->boost_end_us >'],
    'a_sum_that_wraps' => ['? UINT32_MAX :', '? (sum_us + elapsed_us) :'],
    'a_missing_inverse_copy' => ['    self->job_inverse = ~(uint32_t)leaf;', ''],
    'a_wrong_safe_state' => [/(repaired = 0U;.*?)SAMPLE_HEAT_COLD/m, '\1SAMPLE_HEAT_LOW']
  }.freeze

  class << self
    # One compilation of the sample chart serves all tests.
    def folder
      @folder ||= Dir.mktmpdir.tap do |folder|
        Minitest.after_run { FileUtils.remove_entry(folder) }
        compile_chart(folder)
        build_once(folder)
      end
    end

    def compile_chart(folder)
      FileUtils.mkdir_p([File.join(folder, 'in'), File.join(folder, 'gen', 'limits')])
      FileUtils.cp(CHART, File.join(folder, 'in'))
      limits = [{ name: 'short_us', value: 500_000 }, { name: 'heat_limit_us', value: 2_000_000 }]
      File.write(File.join(folder, 'gen', 'limits', 'limits.json'), JSON.generate(limits))
      run!(RbConfig.ruby, COMPILER, File.join(folder, 'in'), File.join(folder, 'gen'))
    end

    # The test, its runner and Unity as objects; each fault then compiles the chart alone.
    def build_once(folder)
      test = File.join(folder, 'gen', 'tests', 'test_sample_walk.c')
      runner = File.join(folder, 'runner.c')
      run!(RbConfig.ruby, File.join(UNITY, 'auto', 'generate_test_runner.rb'), test, runner)
      { 'test' => test, 'runner' => runner, 'unity' => File.join(UNITY, 'src', 'unity.c') }.each do |name, file|
        run!('gcc', '-std=c99', '-c', file, *includes(folder), '-o', File.join(folder, "#{name}.o"))
      end
    end

    def includes(folder)
      ["-I#{File.join(folder, 'gen', 'charts')}", "-I#{File.join(UNITY, 'src')}"]
    end

    def run!(*command)
      output, status = Open3.capture2e(*command)
      raise output unless status.success?
    end
  end

  def test_SWR_CHART_001_the_sample_chart_passes_its_walk
    output, status = walk(source)
    assert status.success?, output
    assert_match(/14 Tests 0 Failures 0 Ignored/, output)
  end

  FAULTS.each do |name, (pattern, replacement)|
    define_method("test_SWR_CHART_001_the_walk_goes_red_for_#{name}") do
      broken = source.sub(pattern, replacement)
      refute_equal source, broken, 'the fault no longer fits the generated code'
      output, status = walk(broken)
      refute status.success?, output
      assert_match(/:FAIL:/, output)
    end
  end

  %w[gcc clang].each do |compiler|
    define_method("test_SWR_CHART_001_#{compiler}_compiles_the_code_without_a_warning") do
      file = path('gen', 'charts', 'sample_chart.c')
      output, status = Open3.capture2e(compiler, *WARNINGS, '-O2', '-c', file, '-o', File::NULL)
      assert status.success?, output
      assert_empty output
    end
  end

  def test_SWR_CHART_001_a_second_run_writes_the_same_bytes
    files = Dir[path('gen', '{charts,tests}', '*')].sort
    before = files.map { |file| File.binread(file) }
    self.class.compile_chart(self.class.folder)
    assert_equal(before, files.map { |file| File.binread(file) })
    assert_equal %w[charts.json sample.dot sample.svg sample_chart.c sample_chart.h test_sample_walk.c],
                 files.map { |file| File.basename(file) }
  end

  def test_SWR_CHART_001_the_drawing_names_every_state_and_transition
    svg = File.read(path('gen', 'charts', 'sample.svg')).gsub('&#45;', '-')
    chart = JSON.parse(File.read(path('gen', 'charts', 'charts.json'))).fetch('charts').first
    chart.fetch('states').each { |state| assert_includes svg, "id=\"#{state.fetch('svg_id')}\"" }
    drawn = chart.fetch('transitions').select { |transition| transition.fetch('target') }
    drawn.each { |transition| assert_includes svg, "id=\"#{transition.fetch('id')}\"" }
    refute_includes svg, 'style='
  end

  def test_SWR_CHART_001_the_table_numbers_agree_with_the_code
    chart = JSON.parse(File.read(path('gen', 'charts', 'charts.json'))).fetch('charts').first
    header = File.read(path('gen', 'charts', 'sample_chart.h'))
    values = chart.fetch('regions').flat_map { |region| region.fetch('leaves') } + chart.fetch('events')
    values.each { |one| assert_match(/\b#{one.fetch('enumerator')} = #{one.fetch('value')}U/, header) }
    chart.fetch('transitions').each do |one|
      name = "take_#{one.fetch('id').downcase.tr('-', '_')}"
      assert_match(/#{name}\([^{]*\{[^}]*last_transition = #{one.fetch('number')}U;/, source)
    end
  end

  private

  def path(*parts)
    File.join(self.class.folder, *parts)
  end

  def source
    File.read(path('gen', 'charts', 'sample_chart.c'))
  end

  def walk(code)
    Dir.mktmpdir do |folder|
      file = File.join(folder, 'sample_chart.c')
      File.write(file, code)
      program = File.join(folder, 'walk')
      objects = %w[test.o runner.o unity.o].map { |name| path(name) }
      self.class.run!('gcc', '-std=c99', '-O0', *self.class.includes(self.class.folder), file, *objects, '-o', program)
      Open3.capture2e(program)
    end
  end
end
