# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'fileutils'
require 'json'
require 'minitest/autorun'
require 'open3'
require 'rbconfig'
require 'tmpdir'
require_relative '../chart/command'

# Each file in tools/test/charts whose name starts with a rule breaks that rule once, in the line that says so.
class TestChartRefusals < Minitest::Test
  FOLDER = File.join(__dir__, 'charts')
  LIMITS = { 'short_us' => 1000 }.freeze
  MARK = /<!-- refused: CHART-R(\d\d) -->/

  Dir[File.join(FOLDER, 'r*.scxml')].sort.each do |file|
    define_method("test_SWR_CHART_003_refuses_#{File.basename(file, '.scxml')}") do
      text = File.read(file)
      line = text.lines.index { |one| one.match?(MARK) } + 1
      refusal = assert_raises(Chart::Refusal) { Chart::Compiled.from(file, text, LIMITS) }
      assert_equal [text[MARK, 1].to_i, line], [refusal.rule, refusal.line], refusal.message
      assert_match(/\A#{Regexp.escape(file)}:\d+: CHART-R\d\d .+/, refusal.message)
    end
  end

  def test_SWR_CHART_003_every_rule_has_a_refused_file
    broken = Dir[File.join(FOLDER, 'r*.scxml')].map { |file| File.basename(file)[1, 2].to_i }
    assert_equal Chart::RULES.keys, broken.uniq.sort
  end

  def test_SWR_CHART_003_a_refusal_says_what_to_write_instead
    assert_match(/write one of: off, on\z/, refusal_of('r07_unknown_target').message)
    assert_match(/write delay="1ms"\z/, refusal_of('r15_delay_differs').message)
    assert_match(/add type="internal"\z/, refusal_of('r17_external_at_region').message)
  end

  def test_SWR_CHART_003_a_violated_invariant_comes_with_the_shortest_list_of_events
    assert_match(/violated in on open, reached by: go, pull;/, refusal_of('r23_invariant_violated').message)
  end

  def test_SWR_CHART_003_the_same_id_in_two_charts_is_refused
    with_charts('sample', 'twin') do |source, target|
      text = File.read(File.join(source, 'sample.scxml')).sub('name="sample"', 'name="twin"')
      File.write(File.join(source, 'twin.scxml'), text)
      _output, errors, status = compile(source, target)
      assert_equal 1, status.exitstatus
      assert_match(/twin\.scxml:7: CHART-R08 SAMPLE-T01 stands in .*sample\.scxml/, errors)
    end
  end

  def test_SWR_CHART_003_one_refused_chart_and_nothing_is_written
    with_charts('sample', 'r07_unknown_target') do |source, target|
      _output, errors, status = compile(source, target)
      assert_equal 1, status.exitstatus
      assert_match(/CHART-R07/, errors)
      refute_path_exists File.join(target, 'charts')
    end
  end

  def test_SWR_CHART_003_missing_limits_are_named
    with_charts('sample') do |source, target|
      FileUtils.rm_r(File.join(target, 'limits'))
      _output, errors, status = compile(source, target)
      assert_equal 1, status.exitstatus
      assert_match(/limits\.json:1: CHART-R15 .*generate the limits first/, errors)
    end
  end

  def test_SWR_CHART_003_wrong_arguments_get_the_usage
    _output, errors, status = Open3.capture3(RbConfig.ruby, File.join(__dir__, '..', 'chart_compiler.rb'))
    assert_equal 2, status.exitstatus
    assert_match(/\Ausage: /, errors)
  end

  private

  def refusal_of(name)
    file = File.join(FOLDER, "#{name}.scxml")
    assert_raises(Chart::Refusal) { Chart::Compiled.from(file, File.read(file), LIMITS) }
  end

  def with_charts(*names)
    Dir.mktmpdir do |folder|
      source = File.join(folder, 'charts_in')
      target = File.join(folder, 'gen')
      FileUtils.mkdir_p([source, File.join(target, 'limits')])
      names.each { |name| copy(name, source) }
      limits = LIMITS.merge('short_us' => 500_000, 'heat_limit_us' => 2_000_000)
      listed = limits.map { |name, value| { name: name, value: value } }
      File.write(File.join(target, 'limits', 'limits.json'), JSON.generate(listed))
      yield source, target
    end
  end

  def copy(name, source)
    file = File.join(FOLDER, "#{name}.scxml")
    FileUtils.cp(file, source) if File.exist?(file)
  end

  def compile(source, target)
    Open3.capture3(RbConfig.ruby, File.join(__dir__, '..', 'chart_compiler.rb'), source, target)
  end
end
