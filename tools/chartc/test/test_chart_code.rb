# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'fileutils'
require 'json'
require 'minitest/autorun'
require 'open3'
require 'rbconfig'
require 'tmpdir'
require_relative '../lib/command'

# What the compiler writes for one chart: C without a warning, the same bytes every time, drawing and table to match.
class TestChartCode < Minitest::Test
  CHART = File.join(__dir__, 'charts', 'sample.scxml')
  CORE = File.join(__dir__, '..', '..', '..', 'core')
  COMPILER = File.join(__dir__, '..', 'chartc')
  WARNINGS = %w[-std=c99 -pedantic -Wall -Wextra -Werror -Wconversion -Wsign-conversion -Wshadow -Wswitch-enum
                -Wcast-qual -Wmissing-prototypes].freeze
  # The timer has run for all of its delay; its mark holds one bit.
  DAMAGED_MARK = <<~C
    #include "sample_chart.h"

    #include <stdio.h>
    #include <stdlib.h>

    void contract_broken(const char *module, uint32_t id)
    {
        (void)module;
        exit((int)id);
    }

    static int expires(uint32_t mark)
    {
        const sample_inputs_t inputs = {false, false};
        sample_chart_t chart;
        sample_chart_init(&chart);
        chart.heat_limit_is_armed = mark;
        chart.heat_limit_us = 0U;
        (void)sample_chart_advance(&chart, &inputs, 2000000U);
        return (chart.heat_limit_is_armed == 0U) && (chart.heat_limit_us == 0U);
    }

    int main(void)
    {
        int count = expires(UINT32_MAX);
        for (uint32_t bit = 0U; bit < 32U; bit++) {
            count += expires((uint32_t)1U << bit);
        }
        (void)printf("%d of 33 expire\\n", count);
        return 0;
    }
  C

  class << self
    # One compilation of the sample chart serves all tests.
    def folder
      @folder ||= Dir.mktmpdir.tap do |folder|
        Minitest.after_run { FileUtils.remove_entry(folder) }
        compile_chart(folder)
      end
    end

    def compile_chart(folder)
      FileUtils.mkdir_p([File.join(folder, 'in'), File.join(folder, 'gen', 'limits')])
      FileUtils.cp(CHART, File.join(folder, 'in'))
      limits = { cycle_us: 1000, short_us: 500_000, heat_limit_us: 2_000_000 }.map do |name, value|
        { name: name, value: value, requirement: 'SWR-CHART-001' }
      end
      File.write(File.join(folder, 'gen', 'limits', 'limits.json'), JSON.generate(limits))
      run!(RbConfig.ruby, COMPILER, 'build', File.join(folder, 'in'), File.join(folder, 'gen'))
    end

    def run!(*command)
      output, status = Open3.capture2e(*command)
      raise output unless status.success?
    end
  end

  %w[gcc clang].each do |compiler|
    define_method("test_SWR_CHART_001_#{compiler}_compiles_the_code_without_a_warning") do
      file = path('gen', 'charts', 'sample_chart.c')
      output, status = Open3.capture2e(compiler, *WARNINGS, '-O2', '-I', CORE, '-c', file, '-o', File::NULL)
      assert status.success?, output
      assert_empty output
    end
  end

  def test_SWR_CHART_001_a_second_run_writes_the_same_bytes
    files = Dir[path('gen', '{charts,tests}', '*')].sort
    before = files.map { |file| File.binread(file) }
    self.class.compile_chart(self.class.folder)
    assert_equal(before, files.map { |file| File.binread(file) })
    assert_equal %w[charts.json charts.ts sample.dot sample.svg sample_chart.c sample_chart.h test_sample_paths.c
                    test_sample_walk.c],
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

  # A seal over the state needs to know how far the part goes that decides.
  def test_SWR_CHART_001_the_header_says_how_many_bytes_decide
    header = File.read(Dir[File.join(TestChartCode.folder, 'gen', '**', 'sample_chart.h')].first)
    assert_includes header, '#define SAMPLE_CHART_BYTES offsetof(sample_chart_t, now_us)'
    assert_match(/    uint32_t \w+_is_armed;[^\n]*\n    uint64_t now_us;[^\n]*\n    chart_trace_t trace;[^\n]*\n\} sample_chart_t;/, header)
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

  # A bool of another value than 0 and 1 would be undefined, and every bit of memory may flip.
  def test_SWR_CHART_510_a_timer_with_a_damaged_mark_is_armed
    program = path('damaged_mark')
    output, status = Open3.capture2e('gcc', *WARNINGS, '-fsanitize=undefined', '-fno-sanitize-recover', '-I', CORE, '-I', path('gen', 'charts'), '-x', 'c',
                                     '-', '-x', 'none', path('gen', 'charts', 'sample_chart.c'), '-o', program, stdin_data: DAMAGED_MARK)
    assert status.success?, output
    assert_equal ["33 of 33 expire\n", true], Open3.capture2e(program).then { |text, ended| [text, ended.success?] }
  end

  private

  def path(*parts)
    File.join(self.class.folder, *parts)
  end

  def source
    File.read(path('gen', 'charts', 'sample_chart.c'))
  end
end
