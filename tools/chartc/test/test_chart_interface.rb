# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# The rule under test: the compiler has one interface. Nobody outside its house requires another file of it or names what is
# not open; and through the interface, in Ruby and on the command line, an engineer of another project comes from an empty
# folder to a program, as the README says.

require 'minitest/autorun'
require 'open3'
require 'rbconfig'
require 'tmpdir'
require_relative '../chart'

class TestChartInterface < Minitest::Test
  ROOT = File.expand_path('../../..', __dir__)
  HOUSE = 'tools/chartc/'
  INTERFACE = "#{HOUSE}chart"
  README = File.read(File.join(ROOT, HOUSE, 'README.md'))
  CHARTC = File.join(ROOT, HOUSE, 'chartc')
  OPEN = README[/^\| What is open.*?\n\n/m].scan(/\bChart(?:::|\.)\w+/)
  CHARTS = File.join(__dir__, 'charts')
  LIMITS = Chart::Limits.new(*[1000, 'SWR-CHART-003'].map { |one| { 'cycle_us' => one, 'short_us' => one } })

  # --- who comes in ---

  def test_SWR_CHART_035_nobody_outside_requires_more_than_the_interface
    outside = ruby_files
    assert_operator outside.count { |file| required(file, read(file)).include?(INTERFACE) }, :>=, 3
    assert_empty(outside.flat_map { |file| strays(file, read(file)) })
  end

  def test_SWR_CHART_035_another_way_in_is_seen
    ['../../tools/chartc/lib/walk/walk', '../../tools/chartc/proof/pairs', '../../tools/chartc/lib/compiled.rb'].each do |path|
      assert_equal 1, strays('verification/model/x.rb', "require_relative '#{path}'\n").length, path
    end
    assert_equal 1, strays('tools/x.rb', "  require_relative \"chartc/lib/refusal\" if true\n").length
    assert_equal 1, strays('tools/x.rb', "LIB = 'tools/chartc/lib/walk'\n").length
    assert_empty strays('verification/model/x.rb', "require_relative '../../tools/chartc/chart'\n")
  end

  def test_SWR_CHART_035_nobody_outside_names_what_is_not_open
    assert_empty(ruby_files.flat_map { |file| closed(file, read(file)) })
    assert_equal ['x.rb: Chart::Walk', 'x.rb: Chart::C'],
                 closed('x.rb', "Chart::Walk.new\nChart::Refusal\nChart.compile(file)\nChart::C::Source.new\nComposedChart::X")
  end

  # --- through the interface ---

  def test_SWR_CHART_035_the_interface_gives_all_of_a_chart
    chart = Chart.compile(File.join(CHARTS, 'base.scxml'), Chart::Limits.new({}))
    assert_equal %w[go halt], chart.document.events
    assert_equal 2, chart.walk.reached.length
    assert_match(/#ifndef BORESIGHT_BASE_CHART_H/, chart.header)
    assert_equal :direct, chart.shape
    assert_equal %w[test_base_walk.c test_base_paths.c], chart.tests.keys
  end

  def test_SWR_CHART_035_the_interface_refuses_and_forgives_as_it_is_asked_to
    file = File.join(CHARTS, 'r25_event_forgotten.scxml')
    limits = Chart::Limits.new({ 'cycle_us' => 1000 })
    refusal = assert_raises(Chart::Refusal) { Chart.compile(file, limits) }
    assert_equal [file, 25], [refusal.file, refusal.rule]
    assert_equal 'r25_event_forgotten', Chart.compile(file, limits, forgiven: [25]).document.name
  end

  # --- on the command line ---

  def test_SWR_CHART_036_the_readme_leads_from_an_empty_folder_to_a_program
    Dir.mktmpdir do |folder|
      { 'kettle.scxml' => 'xml', 'limits.json' => 'json', 'main.c' => 'c' }.each do |name, language|
        File.write("#{folder}/#{name}", blocks(language).first)
      end
      assert_equal blocks('text'), blocks('sh').map { |commands| call(folder, 'sh', '-e', '-c', commands) }
      assert_equal files_in_readme, Dir.glob('**/*.*', base: "#{folder}/gen").sort
      assert_match(/\A\d+\n3\n2\n\z/, call(folder, RbConfig.ruby, '-e', blocks('ruby').first))
    end
  end

  def test_SWR_CHART_036_a_refused_chart_ends_with_its_file_line_and_rule
    Dir.mktmpdir do |folder|
      file = File.join(folder, 'kettle.scxml')
      File.write(file, blocks('xml').first.sub('target="heating"', 'target="heat"'))
      File.write("#{folder}/limits.json", blocks('json').first)
      output, errors, status = chartc(file, '--limits', "#{folder}/limits.json", '--out', "#{folder}/gen")
      assert_equal ['', 1], [output, status.exitstatus]
      assert_equal "#{folder}/#{README[/^ {4}(kettle.scxml:\d+: CHART-R07 .*\n)/, 1]}", errors
      refute_path_exists "#{folder}/gen"
    end
  end

  def test_SWR_CHART_036_a_counterexample_stands_beside_the_code
    Dir.mktmpdir do |folder|
      _output, errors, status = chartc(File.join(CHARTS, 'r23_invariant_violated.scxml'), '--out', folder)
      assert_equal 1, status.exitstatus
      assert_match(/ CHART-R23 .*reached by: /, errors)
      assert_equal %w[r23_invariant_violated_chart.c r23_invariant_violated_chart.h test_t_i01_counterexample.c],
                   Dir.children("#{folder}/counterexamples").sort
    end
  end

  # Of the table that says what the tests of every chart stand for, those of one chart.
  def test_SWR_CHART_044_tests_are_named_after_the_requirements_that_the_project_says
    chart = Chart.compile(File.join(CHARTS, 'base_timer.scxml'), LIMITS)
    own = names(chart.tests).grep_v(/\Atest_SWR_CHART_003_/)
    assert_includes own, 'test_base_timer_equals_the_interpreter_on_every_pair'
    assert_empty own.grep_v(/\Atest_base_timer_/)
    named = names(chart.tests(proves: { behaviour: 'KETTLE-03', damage: 'KETTLE-04' }))
    assert_includes named, 'test_KETTLE_03_base_timer_equals_the_interpreter_on_every_pair'
    assert_includes named, 'test_KETTLE_04_base_timer_a_sound_chart_is_left_alone'
    assert_includes named, 'test_base_timer_dates_its_steps'
  end

  def test_SWR_CHART_044_the_command_line_says_what_the_tests_stand_for
    Dir.mktmpdir do |folder|
      chartc(File.join(CHARTS, 'base.scxml'), '--proves', 'clock=KETTLE-05', '--out', folder)
      assert_includes File.read("#{folder}/test_base_walk.c"), 'void test_KETTLE_05_base_dates_its_steps(void)'
      refute_match(/SWR_(?!CHART_003)/, Dir["#{folder}/**/*.c"].map { |file| File.read(file) }.join)
    end
    %w[time=A-01 clock clock=a-1 clock=].each do |list|
      _output, errors, status = chartc(File.join(CHARTS, 'base.scxml'), '--proves', list, '--out', '/nowhere')
      assert_equal 2, status.exitstatus
      assert_match(/^invalid argument: --proves #{list}: write KIND=ID of behaviour, invariants, clock, damage\n\z/, errors)
    end
  end

  # Where no language is set, too.
  def test_SWR_CHART_042_arguments_that_are_no_text_get_the_usage
    [%W[\xFF.scxml --out x], %W[a.scxml --out \xFF], %W[build \xFF x], %W[diff a.scxml \xFF]].each do |arguments|
      output, errors, status = chartc(*arguments)
      assert_equal ['', 2], [output, status.exitstatus]
      assert_match(/\Ausage: .*^an argument is not UTF-8\n\z/m, errors.b)
    end
    Dir.mktmpdir do |folder|
      file = File.join(folder, 'b\u00E4r')
      assert Open3.capture3({ 'LC_ALL' => 'C' }, CHARTC, File.join(CHARTS, 'base.scxml'), '--out', file).last.success?
      assert_path_exists "#{file}/base_chart.c"
    end
  end

  # What gcc takes for its own in its GNU modes, and other words of compilers and headers.
  def test_SWR_CHART_016_inputs_are_named_as_macros_of_compilers
    text = File.read(File.join(CHARTS, 'base_input.scxml'))
    Dir.mktmpdir do |folder|
      %w[linux unix asm typeof errno].each do |word|
        File.write("#{folder}/base_input.scxml", text.gsub('is_ready', word))
        chart = Chart.compile("#{folder}/base_input.scxml", LIMITS)
        chart.files.each { |name, content| File.write("#{folder}/#{name}", "#include <errno.h>\n#{content}") }
        call(folder, 'gcc', '-std=gnu17', '-Wall', '-Werror', '-c', '-I', File.join(ROOT, 'core'), 'base_input_chart.c')
      end
    end
  end

  def test_SWR_CHART_043_characters_that_turn_text_around_are_refused
    text = File.read(File.join(CHARTS, 'base.scxml'))
    ["\u202E", "\u2066", "\u200F", "\u061C"].each do |stray|
      words = format('CHART-R01 the character U+%04X turns around what is read; remove it', stray.ord)
      [[/(?=<!-- )/, "<!-- a #{stray} b -->"], ['"off" bs:req', "\"off#{stray}\" bs:req"]].each do |change|
        refusal = assert_raises(Chart::Refusal) { Chart.tree('base.scxml', text.sub(*change)) }
        assert_includes refusal.message, words
      end
    end
  end

  {
    'no chart' => [%w[--out x], 'name one chart'], 'two charts' => [%w[a.scxml b.scxml --out x], 'name one chart'],
    'no folder' => [%w[a.scxml], 'name a folder with --out'],
    'an unknown option' => [%w[a.scxml --fast], 'invalid option: --fast']
  }.each do |what, (arguments, words)|
    define_method("test_SWR_CHART_036_#{what.tr(' ', '_')}_gets_the_usage") do
      output, errors, status = chartc(*arguments)
      assert_equal ['', 2], [output, status.exitstatus]
      assert_match(/\Ausage: chartc FILE --out FOLDER.*^#{words}\n\z/m, errors)
    end
  end

  def test_SWR_CHART_036_a_limit_that_is_no_whole_number_is_named
    ['"5s"', 'null', '1.5', '[]'].each do |value|
      Dir.mktmpdir do |folder|
        File.write("#{folder}/limits.json", "[{\"name\": \"long_us\", \"value\": #{value}, \"requirement\": \"A-01\"}]")
        _output, errors, status = chartc(File.join(CHARTS, 'base.scxml'), '--limits', "#{folder}/limits.json", '--out', folder)
        assert_equal 1, status.exitstatus
        assert_match(/\A\S+limits\.json:1: CHART-R15 the value of long_us is no whole number; [^\n]*\n\z/, errors)
      end
    end
  end

  # What stands in the file, and what is said of it.
  WRONG_LIMITS = {
    '[{"name": "short_us", "value": 1000, "requirement": null}]' => 'the requirement of short_us is no id, as AREA-NAME-nnn; ',
    '[{"name": "short_us", "value": 1000, "requirement": "a"}]' => 'the requirement of short_us is no id, as AREA-NAME-nnn; ',
    '[{"name": null, "value": 1000, "requirement": "A-01"}]' => 'the name nil of a limit is none; ',
    '[{"name": "a", "value": 1, "requirement": "A-01"}, {"name": "a", "value": 2, "requirement": "A-01"}]' =>
      'the limit a stands twice; ',
    "[\"\xFF\"]" => 'the file is no JSON; '
  }.freeze

  def test_SWR_CHART_042_limits_that_mean_nothing_are_named
    WRONG_LIMITS.each do |content, words|
      Dir.mktmpdir do |folder|
        File.write("#{folder}/limits.json", content)
        _output, errors, status = chartc(File.join(CHARTS, 'base.scxml'), '--limits', "#{folder}/limits.json", '--out', folder)
        assert_equal 1, status.exitstatus, errors
        assert_match(/\A\S+limits\.json:1: CHART-R15 #{words}[^\n]*\n\z/, errors)
      end
    end
  end

  # What is no time is not what a chart should say.
  def test_SWR_CHART_042_no_advice_leads_to_a_time_that_is_none
    { 'cycle_us' => -1000, 'short_us' => 0 }.each do |name, value|
      limits = Chart::Limits.new(LIMITS.values.merge(name => value), LIMITS.owners)
      refusal = assert_raises(Chart::Refusal) { Chart.compile(File.join(CHARTS, 'base_timer.scxml'), limits) }
      assert_match(/CHART-R15 #{name} is #{value} us, which is no time; correct the limit\z/, refusal.message)
    end
  end

  def test_SWR_CHART_036_limits_that_are_none_are_named
    Dir.mktmpdir do |folder|
      File.write("#{folder}/limits.json", '{}')
      _output, errors, status = chartc(File.join(CHARTS, 'base.scxml'), '--limits', "#{folder}/limits.json", '--out', folder)
      assert_equal 1, status.exitstatus
      assert_match(/\A\S+limits\.json:1: CHART-R15 the file is no list of limits[^\n]*\n\z/, errors)
    end
  end

  private

  # Of the test functions of generated files.
  def names(tests)
    tests.values.join.scan(/^void (test_\w+)/).flatten
  end

  def ruby_files
    Dir.glob('{app,bsp,core,tools,verification}/**/*.rb', base: ROOT).grep_v(%r{node_modules/|\A#{HOUSE}})
  end

  def read(file)
    File.read(File.join(ROOT, file), encoding: 'UTF-8')
  end

  # Files of the house that are required, from the root, without ending.
  def required(file, text)
    text.scan(/\brequire(?:_relative)?\b[ (]*(["'])(.+?)\1/).map { |_quote, path| inside(file, path) }.grep(/\A#{HOUSE}/)
  end

  def inside(file, path)
    from = path.start_with?('.') || !path.start_with?(HOUSE) ? File.join('/', File.dirname(file)) : '/'
    File.expand_path(path, from).delete_prefix('/').delete_suffix('.rb')
  end

  # However they are loaded: what is required, and paths that are written out.
  def strays(file, text)
    named = text.scan(%r{#{HOUSE}(?:lib|proof|test|conformance|faults)\b[^'"\s]*}).map { |path| path.delete_suffix('.rb') }
    ((required(file, text) + named).uniq - [INTERFACE]).map { |path| "#{file}: #{path}" }
  end

  def closed(file, text)
    named = text.gsub(/^\s*#.*$/, '').scan(/(?<![\w:])Chart(?:::|\.)\w+/).uniq
    (named - OPEN).map { |name| "#{file}: #{name}" }
  end

  def blocks(language)
    README.scan(/^```#{language}\n(.*?)^```$/m).flatten
  end

  # Of the table, those that an accepted chart has.
  def files_in_readme
    README[/^## What stands in the folder\n.*?^## /m].scan(/`([\w\/]+\.\w+)`/).flatten.grep_v(/chart\.rb/).uniq.sort
  end

  def call(folder, *command)
    output, status = Open3.capture2e({ 'BORESIGHT' => ROOT }, *command, chdir: folder)
    assert status.success?, output
    output
  end

  def chartc(*arguments)
    Open3.capture3(CHARTC, *arguments)
  end
end
