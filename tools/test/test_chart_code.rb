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
  BASE = File.join(__dir__, '..', '..', 'core', 'base')
  COMPILER = File.join(__dir__, '..', 'chart_compiler.rb')
  UNITY = File.join(Gem::Specification.find_by_name('ceedling').gem_dir, 'vendor', 'unity')
  WARNINGS = %w[-std=c99 -pedantic -Wall -Wextra -Werror -Wconversion -Wsign-conversion -Wshadow -Wswitch-enum
                -Wcast-qual -Wmissing-prototypes].freeze

  # What a wrong emitter could do, as [pattern, replacement] on the C.
  FAULTS = {
    'a_swapped_target' => ['sample_enter_heat(self, SAMPLE_HEAT_HIGH);', 'sample_enter_heat(self, SAMPLE_HEAT_LOW);'],
    'a_lost_entry' => [/(take_sample_t10\(.*?)    sample_enter_job\(self, SAMPLE_JOB_SLOW\);\n/m, '\1'],
    'a_lost_raise' => ['sample_raise_event(run, SAMPLE_EVENT_HALT);', ''],
    'a_wrong_raise' => ['sample_raise_event(run, SAMPLE_EVENT_TRIP);', 'sample_raise_event(run, SAMPLE_EVENT_HALT);'],
    'a_wrong_action' => ['(SAMPLE_ACTION_COMPLAIN | SAMPLE_ACTION_BEEP)', 'SAMPLE_ACTION_BEEP'],
    'a_lost_action' => ['    run->actions |= SAMPLE_ACTION_REPORT;', ''],
    'actions_that_replace_each_other' => ['run->actions |= SAMPLE_ACTION_REPORT', 'run->actions = SAMPLE_ACTION_BEEP'],
    'a_dropped_exit' => ['    sample_stop_fast_end(self);', ''],
    'an_exit_after_the_entry' => [/(take_sample_t06\(.*?)    sample_start_heat_limit\(self\);\n(.*?)\}/m,
                                  '\1\2    sample_start_heat_limit(self);    sample_stop_heat_limit(self);}'],
    'a_lost_cancel' => [/(take_sample_t09\(.*?)    sample_stop_boost_end\(self\);\n/m, '\1'],
    'a_timer_not_restarted' => [/(take_sample_t06\(.*?)sample_start_heat_limit\(self\);/m, '\1'],
    'a_timer_not_started' => [/(take_sample_t07\(.*?)    sample_start_boost_end\(self\);\n/m, '\1'],
    'a_timer_one_late' => ['self->boost_end_us >=', 'self->boost_end_us >'],
    'a_timer_with_the_delay_of_another' => ['SAMPLE_BOOST_END_DELAY_US 500000U', 'SAMPLE_BOOST_END_DELAY_US 2000000U'],
    'a_timer_with_the_event_of_another' => [/(heat_limit_has_expired\(self\)\) \{.*?)SAMPLE_EVENT_TOO_LONG/m,
                                            '\1SAMPLE_EVENT_HALT'],
    'a_timer_that_expires_again' => [/(boost_end_has_expired\(self\)\) \{\n)\s*sample_stop_boost_end\(self\);\n/, '\1'],
    'a_time_that_is_not_counted' => ['if (self->fast_end_is_armed) {', 'if (self->heat_limit_is_armed) {'],
    'a_sum_that_wraps' => ['? UINT32_MAX :', '? (sum_us + elapsed_us) :'],
    'a_turned_guard' => ['if (!inputs->is_allowed)', 'if (inputs->is_allowed)'],
    'a_swapped_guard' => ['if (inputs->is_strong) {', 'if (inputs->is_allowed) {'],
    'a_dropped_conjunct' => ['inputs->is_allowed && (before->job != SAMPLE_JOB_IDLE)', 'inputs->is_allowed'],
    'a_guard_that_sees_the_step' => ['.heat = self->heat,', '.heat = SAMPLE_HEAT_LOW,'],
    'a_swapped_event' => ['event == SAMPLE_EVENT_ADJUST', 'event == SAMPLE_EVENT_TICK'],
    'an_ancestor_first' => ['take_sample_t09(self, run);', 'take_sample_t04(self);'],
    'a_region_forgotten' => [/    sample_step_job\(self[^;]*;\n(?=\}\n\nstatic void sample_settle)/, ''],
    'regions_in_the_wrong_order' => [/(    sample_step_heat\(self[^;]*;\n)(    sample_step_job\(self[^;]*;\n)/, '\2\1'],
    'one_round_too_few' => ["    sample_settle(self, inputs, run);\n", ''],
    'an_unguarded_internal_event' => [' && (event != SAMPLE_EVENT_STARTED)', ''],
    'a_timer_event_from_outside' => [/ &&\s+\(event != SAMPLE_EVENT_TOO_LONG\)/, ''],
    'a_missing_inverse_copy' => ['    self->job_inverse = ~(uint32_t)leaf;', ''],
    'an_inverse_copy_not_compared' => ['(self->job_inverse == ~(uint32_t)self->job)', 'true'],
    'a_leaf_too_many' => ['<= (uint32_t)SAMPLE_JOB_FAST', '<= ((uint32_t)SAMPLE_JOB_FAST + 1U)'],
    'a_wrong_safe_state' => [/(repaired = 0U;.*?)SAMPLE_HEAT_COLD/m, '\1SAMPLE_HEAT_LOW'],
    'a_repair_that_leaves_timers' => [/(static void sample_clear.*?)    sample_stop_heat_limit\(self\);\n/m, '\1'],
    'a_wrong_number_in_the_trace' => ['chart_trace_add(&self->trace, self->now_us, 7U)',
                                      'chart_trace_add(&self->trace, self->now_us, 6U)'],
    'a_clock_that_stands' => ['    self->now_us += elapsed_us;', '']
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
      trap = File.join(folder, 'trap.c')
      File.write(trap, "#include \"contract.h\"\n#include <stdlib.h>\nvoid contract_broken(const char *module, " \
                       "uint32_t id)\n{\n    (void)module;\n    (void)id;\n    abort();\n}\n")
      { 'trap' => trap, 'test' => test, 'runner' => runner, 'unity' => File.join(UNITY, 'src', 'unity.c') }.each do |name, file|
        run!('gcc', '-std=c99', '-c', file, *includes(folder), '-o', File.join(folder, "#{name}.o"))
      end
    end

    def includes(folder)
      ["-I#{File.join(folder, 'gen', 'charts')}", "-I#{File.join(UNITY, 'src')}", "-I#{BASE}"]
    end

    def run!(*command)
      output, status = Open3.capture2e(*command)
      raise output unless status.success?
    end
  end

  def test_SWR_CHART_001_the_sample_chart_passes_its_walk
    output, status = walk(source)
    assert status.success?, output
    assert_match(/16 Tests 0 Failures 0 Ignored/, output)
  end

  FAULTS.each do |name, (pattern, replacement)|
    define_method("test_SWR_CHART_001_the_walk_goes_red_for_#{name}") do
      broken = source.sub(pattern, replacement)
      refute_equal source, broken, 'the fault no longer fits the generated code'
      output, status = walk(broken)
      refute status.success?, output
      assert(status.signaled? || output.include?(':FAIL:'), output)
    end
  end

  %w[gcc clang].each do |compiler|
    define_method("test_SWR_CHART_001_#{compiler}_compiles_the_code_without_a_warning") do
      file = path('gen', 'charts', 'sample_chart.c')
      output, status = Open3.capture2e(compiler, *WARNINGS, '-O2', '-I', BASE, '-c', file, '-o', File::NULL)
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
    marks = chart.fetch('transitions').flat_map { |transition| transition.fetch('svg_ids') }
    assert_empty(chart.fetch('transitions').reject { |transition| transition.fetch('svg_ids').any? })
    marks.each { |mark| assert_includes svg, "id=\"#{mark}\"" }
    refute_includes svg, 'style='
  end

  def test_SWR_CHART_001_the_table_numbers_agree_with_the_code
    chart = JSON.parse(File.read(path('gen', 'charts', 'charts.json'))).fetch('charts').first
    header = File.read(path('gen', 'charts', 'sample_chart.h'))
    values = chart.fetch('regions').flat_map { |region| region.fetch('leaves') } + chart.fetch('events')
    values.each { |one| assert_match(/\b#{one.fetch('enumerator')} = #{one.fetch('value')}U/, header) }
    chart.fetch('transitions').each do |one|
      name = "take_#{one.fetch('id').downcase.tr('-', '_')}"
      assert_match(/#{name}\([^{]*\{[^}]*self->now_us, #{one.fetch('number')}U\);/, source)
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
      objects = %w[trap.o test.o runner.o unity.o].map { |name| path(name) }
      self.class.run!('gcc', '-std=c99', '-O0', *self.class.includes(self.class.folder), file, *objects, '-o', program)
      Open3.capture2e(program)
    end
  end
end
