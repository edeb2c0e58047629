# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: the rows of the generated tests hold every transition, both outcomes of every guard and every pair of
# successive transitions of every product chart. The pairs are counted here once more, on the walk alone, where timers
# expire in any order. The numbers are printed.

require 'minitest/autorun'
require_relative 'product_charts'

class TestPaths < Minitest::Test
  NUMBERS = {}
  TABLE = /^static const step_t (\w+)_(taken|followed)_\d+\[\] = \{\n(.*?)^\};/m
  ROW = /\d+U, \{ ([\dU, ]+) \} \},$/

  # One table: the steps of its way and its rows, each as the numbers of the transitions that it takes.
  Table = Struct.new(:stem, :kind, :way, :rows)

  ProductCharts::ALL.each_value do |chart|
    define_method("test_SWR_CHART_009_the_paths_of_#{chart.document.name}_are_complete") do
      tables = tables_of(chart.tests.fetch("test_#{chart.document.name}_paths.c"))
      chart.document.transitions.each { |transition| check(transition, tables) }
      pairs = pairs_of(tables)
      assert_equal successors(chart.walk), pairs
      NUMBERS[chart.document.name] = [chart.document.transitions.length,
                                      chart.document.transitions.count(&:guard), pairs.length]
    end
  end

  Minitest.after_run do
    NUMBERS.sort.each do |name, (transitions, guards, pairs)|
      puts format('%-15<name>s %3<transitions>d transitions, %3<guards>d guards, %5<pairs>d pairs of successive ' \
                  'transitions from the start', name: name, transitions: transitions, guards: guards, pairs: pairs)
    end
  end

  private

  def tables_of(text)
    text.scan(TABLE).map do |stem, kind, body|
      way, rows = body.split(%r{^ +/\* (?:From|After) .*?\*/\n}m, 2).map do |part|
        part.scan(ROW).map { |(numbers)| numbers.split(', ').map(&:to_i) - [0] }
      end
      Table.new(stem, kind, way, rows)
    end
  end

  def check(transition, tables)
    stem = transition.id.downcase.tr('-', '_')
    rows = tables.select { |table| table.stem == stem && table.kind == 'taken' }.flat_map(&:rows)
    outcomes = rows.map { |numbers| numbers.include?(transition.number) }.uniq
    assert_equal transition.guard ? [false, true] : [true], outcomes.sort_by(&:to_s), transition.id
  end

  def pairs_of(tables)
    tables.select { |table| table.kind == 'followed' }.flat_map do |table|
      before = table.way.reject(&:empty?).last || []
      table.rows.flat_map { |numbers| before.product(numbers) + numbers.each_cons(2).to_a }
    end.uniq.sort
  end

  # Every transition of one step with every one of the next, and neighbours within a step.
  def successors(walk)
    outcomes = walk.reachable_pairs.group_by(&:before).transform_values { |pairs| pairs.flat_map(&:outcomes).uniq }
    places = [[walk.start.after, walk.start.taken]]
    pairs = places.each_with_object([]) do |(snapshot, last), found|
      outcomes.fetch(snapshot).each do |outcome|
        found.concat(last.product(outcome.taken), outcome.taken.each_cons(2).to_a)
        after = [outcome.after, outcome.taken.empty? ? last : outcome.taken]
        places << after unless places.include?(after)
      end
    end
    pairs.map { |pair| pair.map(&:number) }.uniq.sort
  end
end
