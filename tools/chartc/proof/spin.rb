# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../lib/emit/promela'
require_relative 'spin_verifier'

# Runs SPIN on the Promela of a chart and compares every step that it executes with the walk of the chart.
class Spin
  # configurations and pairs: what SPIN executed. stored and errors: its own count of states, the one before the start
  # included, and of violated assertions, from a run with the properties. violation and trail: the first property that
  # is violated, and the stimuli that lead there, in words.
  Comparison = Struct.new(:configurations, :pairs, :stored, :errors, :violation, :trail, :differences,
                          keyword_init: true)
  # More differences than anybody reads.
  MOST = 1000

  def compare(document, walk, model = Chart::Promela.new(document).emit)
    begin_comparison(document, walk)
    SpinVerifier.open(model) do |verifier|
      verifier.steps { |line| compare_line(line) }
      compare_completeness
      comparison(verifier.verify)
    end
  end

  private

  def begin_comparison(document, walk)
    @document = document
    @walk = walk
    @vector = Chart::Promela::Vector.new(document)
    @steps = Chart::Promela::Steps.new(document)
    @differences = []
    @lines = 0
    @reached = {}
    @executed = Hash.new(0).compare_by_identity
    @texts = {}.compare_by_identity
    @pairs = walk.reachable_pairs.group_by(&:before).to_h do |before, pairs|
      [@vector.text(before), pairs.to_h { |pair| [@steps.stimulus(pair.stimulus), pair] }]
    end
    @start = @steps.stimulus([:start])
  end

  def compare_line(line)
    before, stimulus, expiring, inputs, found = line.split(';', 5)
    @reached[@steps.after(found)] = true
    which = "#{stimulus};#{expiring}"
    return compare_outcome(line, @walk.start, found) if which == @start

    @lines += 1
    pair = @pairs.fetch(before) { return note("#{place(line)}: only SPIN comes here") }[which]
    return note("#{place(line)}: only SPIN has this stimulus") unless pair

    @executed[pair] |= 1 << inputs.to_i
    compare_outcome(line, pair.outcomes.fetch(inputs.to_i), found)
  end

  def compare_outcome(line, outcome, found)
    expected = @texts[outcome] ||= @steps.outcome(outcome)
    return if found == expected

    others = @steps.read_outcome(found)
    @steps.read_outcome(expected).each do |part, value|
      next if value == others.fetch(part)

      note("#{place(line)}: #{part} is #{value.inspect} here and #{others.fetch(part).inspect} with SPIN")
    end
  end

  def place(line)
    before, *stimulus = line.split(';', 5).first(4)
    [@vector.describe(before), @steps.read_stimulus(*stimulus)].reject(&:empty?).join(', ')
  end

  # Every stimulus in every configuration with every valuation.
  def compare_completeness
    same = @reached.length == @walk.reached.length
    note("SPIN reaches #{@reached.length} configurations, the walk #{@walk.reached.length}") unless same
    all = (1 << @walk.valuations.length) - 1
    @walk.reachable_pairs.each do |pair|
      next if @executed[pair] == all

      note("#{pair.before.leaves.join(' ')}, #{pair.stimulus.join(' ')}: SPIN did not execute this with all inputs")
    end
  end

  def note(difference)
    @differences << difference if @differences.length < MOST
  end

  def comparison(report)
    unless report.stored == @reached.length + 1 || report.errors.positive?
      note("SPIN stores #{report.stored} states for #{@reached.length} configurations and the one before the start")
    end
    Comparison.new(configurations: @reached.length, pairs: @lines, stored: report.stored, errors: report.errors,
                   violation: property(report.violation), trail: words(report.trail), differences: @differences)
  end

  # The id of the property that an assertion stands for, or the assertion itself.
  def property(assertion)
    names = Chart::Promela::Names.new(@document)
    @document.properties.find { |property| names.holds(property) == assertion }&.id || assertion
  end

  def words(trail)
    trail.map { |line| @steps.read_stimulus(*line.split(';', 5)[1..3]) }
  end
end
