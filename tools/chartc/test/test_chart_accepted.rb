# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# The rule under test: what the compiler accepts compiles, whatever the chart calls its parts and says in its comments,
# and a chart too large is refused before it is walked.

require 'minitest/autorun'
require 'minitest/mock'
require 'tmpdir'
require_relative '../lib/compiled'
require_relative '../lib/command'
require_relative '../proof/generated_test'

class TestChartAccepted < Minitest::Test
  FOLDER = File.join(__dir__, 'charts')
  CORE = File.expand_path('../../../core', __dir__)
  LIMITS = { 'short_us' => 1000, 'cycle_us' => 1000 }.freeze
  MARGIN = 1.2
  Refused = Struct.new(:message, :objects) # What a refusal says, and how many objects it took.
  WARNINGS = %w[-std=c99 -pedantic -Wall -Wextra -Werror -Wconversion -Wsign-conversion -Wshadow -Wswitch-enum
                -Wcast-qual -Wmissing-prototypes].freeze
  ENGINE = 'xmlns="http://www.w3.org/2005/07/scxml" xmlns:bs="urn:boresight:chart" version="1.0" datamodel="ecmascript"'

  def test_SWR_CHART_016_names_and_comments_do_not_break_the_code
    assert_empty warnings(awkward)
  end

  def test_SWR_CHART_016_names_and_comments_do_not_break_staged_code
    of = Chart::Shape.method(:new)
    Chart::Shape.stub(:new, ->(*parts) { of.call(*parts).tap { |one| one.define_singleton_method(:chosen) { :staged } } }) do
      assert_includes Chart::C::Source.new(awkward.document, awkward.walk).emit, '_claim('
      assert_empty warnings(awkward)
    end
  end

  def test_SWR_CHART_016_names_do_not_break_the_generated_tests
    Dir.mktmpdir do |folder|
      source = written(awkward, folder)
      { 'walk' => Chart::WalkTest, 'paths' => Chart::PathsTest }.each do |name, kind|
        test = File.join(folder, "test_#{name}.c")
        File.write(test, kind.new(awkward.document, awkward.walk).emit)
        output, status = Open3.capture2e(GeneratedTest.new(test, folder, folder).program(source))
        assert status.success?, output
      end
    end
  end

  # No step of the walk comes to the raise: the state is left by nothing, or never reached.
  def test_SWR_CHART_016_a_raise_that_never_happens_compiles
    ['<state id="a"><transition event="go"/></state><state id="b"><onexit><raise event="go"/></onexit>
      <transition event="go" target="a"/></state>',
     '<state id="a"><transition event="done.state.p"/></state><parallel id="p"><state id="b"><final id="c"/></state>
      <state id="d"/></parallel>'].each do |states|
      assert_empty warnings(engine(states)), states
    end
  end

  def test_SWR_CHART_016_charts_whose_headers_say_the_same_name_are_refused
    Dir.mktmpdir do |folder|
      text = File.read(File.join(FOLDER, 'base.scxml'))
      File.write(File.join(folder, 'base_x.scxml'), text.sub('name="base"', 'name="base_x"').gsub('T-T', 'X-T'))
      text = text.sub('initial="off" bs:safe="off"', 'initial="all" bs:safe="off fast"')
                 .sub('<state', '<parallel id="all"><state id="x_state" initial="off"><state')
      File.write(File.join(folder, 'base.scxml'),
                 text.sub('</scxml>', '</state><state id="fast" bs:req="SWR-CHART-003"/></parallel></scxml>'))
      status = nil
      _output, errors = capture_io { status = Chart::Command.run(['page', folder, File.join(folder, 'out')]) }
      assert_equal 1, status
      assert_match(/base_x\.scxml:1: CHART-R06 base_x_state_t comes of .*base\.scxml too; choose/, errors)
    end
  end

  # What a message calls a timer, a state or a transition stands in the file.
  def test_SWR_CHART_016_a_message_names_only_what_the_file_contains
    sends = '<send event="late" delay="1s"/>'
    refusal = assert_raises(Chart::Refusal) do
      engine("<state id=\"a\">\n<transition event=\"go\">\n#{sends}</transition></state>")
    end
    assert_match(/:3: CHART-R33 timer "send of line 3" is started while it runs, reached by: go, go;/, refusal.message)
  end

  def test_SWR_CHART_017_more_than_400_states_are_refused_at_once
    assert_equal 400, engine(ring(400)).document.states.length
    few, many = [401, 20_000].map { |count| refused_before_walk { engine(ring(count)) } }
    assert_match(/CHART-R19 more than 400 states; split/, many.message)
    assert_operator many.objects, :<, few.objects * 20_000 / 401 * MARGIN
  end

  def test_SWR_CHART_017_more_configurations_than_can_be_walked_are_refused_at_once
    regions = (1..12).map { |n| "<state id=\"r#{n}\">#{(1..3).map { |leaf| leaf_of(n, leaf) }.join}</state>" }
    refused = refused_before_walk { engine("<parallel id=\"all\">#{regions.join}</parallel>") }
    assert_match(/CHART-R19 the regions allow 531441 configurations; at most 200000 fit, split/, refused.message)
    assert_operator refused.objects, :<, 531_441
  end

  # Each transition is stepped once, and half the chart takes no less than a third of the work.
  def test_SWR_CHART_017_400_states_with_2000_transitions_are_walked_in_2000_steps
    chart = nil
    half, all = [200, 400].map { |count| objects { chart = engine(web(count)) } }
    assert_equal [400, 2000], [chart.walk.reached.length, chart.walk.pairs.length]
    assert_operator all, :<, half * 3
  end

  private

  # States with five transitions each.
  def web(count)
    (1..count).map { |n| "<state id=\"s#{n}\">#{(1..5).map { |way| way_of(n, way, count) }.join}</state>" }.join
  end

  def way_of(state, way, count)
    "<transition event=\"next_#{way}\" target=\"s#{((state + way) % count) + 1}\"/>"
  end

  def awkward
    @awkward ||= Chart::Compiled.from(File.join(FOLDER, 'awkward_names.scxml'),
                                      File.read(File.join(FOLDER, 'awkward_names.scxml')), LIMITS)
  end

  def engine(states)
    Chart::Compiled.from('small.scxml', "<scxml #{ENGINE}>#{states}</scxml>", {}, mode: :engine)
  end

  def ring(length)
    (1..length).map { |n| leaf(n, (n % length) + 1) }.join
  end

  def leaf(number, target)
    "<state id=\"s#{number}\"><transition event=\"next\" target=\"s#{target}\"/></state>"
  end

  def leaf_of(region, number)
    leaf("#{region}_#{number}", "#{region}_#{(number % 3) + 1}")
  end

  # How many objects the block makes.
  def objects
    before = GC.stat(:total_allocated_objects)
    yield
    GC.stat(:total_allocated_objects) - before
  end

  def refused_before_walk(&block)
    refusal = nil
    made = Chart::Walk.stub(:new, ->(*) { flunk 'It is walked.' }) { objects { refusal = assert_raises(Chart::Refusal, &block) } }
    Refused.new(refusal.message, made)
  end

  def written(chart, folder)
    name = chart.document.name
    File.write(File.join(folder, "#{name}_chart.h"), Chart::C::Header.new(chart.document, chart.walk).emit)
    File.join(folder, "#{name}_chart.c").tap do |file|
      File.write(file, Chart::C::Source.new(chart.document, chart.walk).emit)
    end
  end

  # What gcc says of the code.
  def warnings(chart)
    Dir.mktmpdir do |folder|
      source = written(chart, folder)
      Open3.capture2e('gcc', *WARNINGS, '-O1', '-I', CORE, '-c', source, '-o', File::NULL).first
    end
  end
end
