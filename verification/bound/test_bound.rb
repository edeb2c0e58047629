# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: verification/bound/bound.yml states an upper bound of the instructions of a cycle that no counted
# cycle passes, every loop has a bound of a named origin, and code that is not understood is refused.

require 'minitest/autorun'
require_relative 'bound'
require_relative 'counted_paths'
require_relative '../bench/scene'

class TestBound < Minitest::Test
  COUNTED = YAML.safe_load_file(File.join(LoopBounds::ROOT, 'verification/bench/cost.yml')).fetch('robots')
  MEASURED = Hash.new { |all, robot| all[robot] = Bound.rows(robot) }

  Bound.table['robots'].each_key do |robot|
    define_method("test_SWR_COST_420_no_counted_cycle_of_#{robot}_nor_a_stage_of_it_is_above_the_bound") do
      counted = COUNTED.fetch(robot).transform_values { |row| row.fetch('worst') }
      counted.each { |stage, count| assert_operator MEASURED[robot].fetch('one_command').fetch(stage), :>=, count, stage }
    end

    # Every twelfth cycle of the scene, and the largest.
    define_method("test_SWR_COST_420_counted_cycles_of_#{robot}_keep_each_loop_bound_and_fact") do
      scene = Scene.new(robot)
      largest = scene.samples.index { |sample| COUNTED[robot]['all']['worst_in'].start_with?("cycle #{sample.cycle}") }
      bound = Bound.of(robot, 4, 'controller_step')
      paths = CountedPaths.new(bound.graphs).paths(scene.file, [largest, *scene.numbers.select { |number| (number % 12).zero? }])
      assert_operator paths.length, :>, 20
      assert_empty paths.flat_map { |path| bound.complaints(path) }.uniq
    end

    define_method("test_SWR_COST_420_the_bound_of_#{robot}_is_the_approved_one") do
      assert_equal Bound.approved.fetch(robot), MEASURED[robot]
    end
  end

  def test_SWR_COST_420_every_entry_of_the_table_is_of_use_for_a_robot
    MEASURED.values_at(*Bound.table['robots'].keys)
    assert_empty Bound.idle
  end
end

# Small code in the words of objdump; `body` of seven instructions lies in a loop of the source lines below.
class TestBoundOfSmallCode < Minitest::Test
  SOURCE = ['void step(void)', '{', 'for (uint32_t i = 0U; is_on && (i < robot->axis_count); i++) {', 'work();', '}', '}'].freeze
  LOOP = <<~CODE
    00001000 <step>:
    small.c:2
        1000:	push	{r4, lr}
        1002:	movs	r4, #0
    small.c:4
        1004:	bl	2000 <work>
    small.c:3
        1008:	adds	r4, #1
        100a:	cmp	r4, #5
        100c:	bne.n	1004 <step+0x4>
    small.c:6
        100e:	pop	{r4, pc}
  CODE
  WORK = <<~CODE
    00002000 <work>:
    small.c:4
        2000:	cmp	r0, #0
        2002:	beq.n	2008 <work+0x8>
        2004:	adds	r0, #1
        2006:	adds	r0, #1
        2008:	bx	lr
  CODE

  # Two instructions, five rounds beyond the first of 4 and of the 5 of work, and the return.
  def test_SWR_COST_420_the_bound_is_the_longest_path_with_every_round_of_its_loops
    assert_equal 2 + (6 * (4 + 5)) + 1, bound(LOOP + WORK).most
    assert_equal 2 + (3 * (4 + 5)) + 1, bound(LOOP + WORK, axes: 2).most
  end

  def test_SWR_COST_420_a_fact_about_the_number_of_calls_lowers_the_bound
    assert_equal 2 + (2 * (4 + 5)) + 1, bound(LOOP + WORK, at_most: { 'work' => 2 }).most
  end

  def test_SWR_COST_420_the_calls_and_the_instructions_of_each_function_are_named
    found = bound(LOOP + WORK)
    assert_equal [1, 6], found.calls.values_at('step', 'work')
    assert_equal [27, 30], found.own.values_at('step', 'work')
  end

  def test_SWR_COST_420_a_loop_without_a_bound_is_refused
    error = assert_raises(LoopBounds::Refused) { bound(LOOP + WORK, part: 'i < robot->other_count') }
    assert_match(/\Ano bound of the loop .*i < robot->axis_count.* of step, small.c\z/, error.message)
    error = assert_raises(LoopBounds::Refused) { bound((LOOP + WORK).gsub('small.c:3', 'small.c:4')) }
    assert_equal 'no bound of the loop of step at small.c:4', error.message
  end

  def test_SWR_COST_420_a_bound_by_the_rows_of_an_array_is_their_number
    source = ['static const remedy_t remedies[] = {', '    {1, {2}}, {3, {4}},', '    {5,', '     {6}}, /* {Seldom.} */', '};', 'while (left_for(remedies)) {']
    bound = ->(array) { rows_bound(source, array).of_function('step', [loop_at('small.c:6')]).first.last }
    assert_equal 3, bound.call('remedies')
    assert_equal 'no array others in small.c', assert_raises(LoopBounds::Refused) { bound.call('others') }.message
  end

  def test_SWR_COST_420_a_bound_that_fits_no_loop_is_named
    bounds = loop_bounds
    CycleBound.new(MachineCode.new("#{WORK}\n"), 'work', bounds)
    assert_equal ['i < robot->axis_count'], (bounds.idle.map { |entry| entry['part'] })
  end

  def test_SWR_COST_420_the_way_into_a_broken_contract_is_no_way_of_a_cycle
    way = WORK.sub("    2006:\tadds\tr0, #1", "    2006:\tbl\t3000 <contract_broken>")
    assert_equal 3, bound(way, start: 'work').most
  end

  def test_SWR_COST_420_a_return_on_condition_and_a_jump_table_have_each_of_their_ways
    code = <<~CODE
      00002000 <work>:
          2000:	cmp	r0, #1
          2002:	it	cc
          2004:	bxcc	lr
          2006:	tbb	[pc, r0]
          200a:	.short	0x0401
          200c:	nop
          200e:	nop
          2010:	b.n	2014 <work+0x14>
          2012:	adds	r0, #1
          2014:	bx	lr
    CODE
    assert_equal 4 + 4, bound(code, start: 'work').most
  end

  def test_SWR_COST_420_a_pointer_that_is_called_and_a_computed_jump_are_refused
    ['blx	r3', 'bx	r3', 'mov	pc, r3', 'add	pc, r3'].each do |code|
      error = assert_raises(MachineCode::Unknown) { bound(WORK.sub('adds	r0, #1', code), start: 'work') }
      assert_match(/\Awork computes where it goes at small.c:4: /, error.message)
    end
  end

  def test_SWR_COST_420_a_function_that_calls_itself_is_refused
    error = assert_raises(CycleBound::Failed) { bound(WORK.sub('adds	r0, #1', 'bl	2000 <work>'), start: 'work') }
    assert_match(/work calls itself/, error.message)
  end

  private

  def bound(text, start: 'step', part: 'i < robot->axis_count', axes: 5, at_most: {})
    CycleBound.new(MachineCode.new(text), start, loop_bounds(part, axes), at_most: at_most)
  end

  def loop_at(place)
    Struct.new(:places, :blocks).new([place], Set[1])
  end

  def rows_bound(source, array)
    @root ||= Dir.mktmpdir.tap { |folder| File.write(File.join(folder, 'small.c'), source.join("\n")) }
    table = { 'conditions' => [{ 'part' => 'left_for(remedies)', 'rows' => array }], 'outer' => [], 'machine' => [] }
    LoopBounds.new(table, {}, root: @root)
  end

  def loop_bounds(part = 'i < robot->axis_count', axes = 5)
    @root ||= Dir.mktmpdir.tap { |folder| File.write(File.join(folder, 'small.c'), SOURCE.join("\n")) }
    table = { 'conditions' => [{ 'part' => part, 'most' => 'axes', 'from' => 'table' }], 'outer' => [], 'machine' => [] }
    LoopBounds.new(table, { 'axes' => axes }, root: @root)
  end

  def teardown
    FileUtils.remove_entry(@root) if @root
  end
end
