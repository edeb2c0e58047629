# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../lib/emit/vector'

# The complete list of a walk's pairs as commands for a driver, with the answers that the interpreter gives.
class Pairs
  Difference = Struct.new(:command, :expected, :found)

  def initialize(document, walk)
    @document = document
    @walk = walk
    @vector = Chart::Vector.new(document)
    @actions = document.actions.each_with_index.to_h { |action, bit| [action, 1 << bit] }
  end

  def commands
    @commands ||= ['init'] + @walk.pairs.flat_map do |pair|
      place = "set #{@vector.encode(pair.before).join(' ')}"
      pair.outcomes.each_index.flat_map { |inputs| [place, "#{stimulus(pair.stimulus)} #{inputs}"] }
    end
  end

  # One line per command that answers: configuration, actions, transitions taken.
  def expected
    @expected ||= [words(@walk.start, with_trace: false)] + @walk.pairs.flat_map do |pair|
      pair.outcomes.map { |outcome| words(outcome) }
    end
  end

  def compare(answers)
    raise "#{answers.length} answers to #{expected.length} commands" unless answers.length == expected.length

    asked = commands.reject { |command| command.start_with?('set') }
    answers.each_index.filter_map do |index|
      found = read(answers[index], with_trace: index.positive?)
      Difference.new(asked[index], expected[index], found) unless found == expected[index]
    end
  end

  private

  def stimulus(stimulus)
    kind, what = stimulus
    return "event #{@document.events.index(what)}" if kind == :event

    "expire #{@document.timers.each_with_index.sum { |timer, bit| what.include?(timer.id) ? 1 << bit : 0 }}"
  end

  def words(outcome, with_trace: true)
    actions = outcome.actions.sum { |action| @actions.fetch(action) }
    taken = with_trace ? outcome.taken.map(&:number).last(8) : []
    [outcome.after, with_trace ? actions : 0, taken, true]
  end

  def read(answer, with_trace:)
    vector, actions, taken, sound = answer.split('|').map(&:strip)
    numbers = with_trace ? taken.split(',').map(&:to_i) : []
    [@vector.decode(vector.split.map(&:to_i)), with_trace ? actions.to_i : 0, numbers, sound == '1']
  end
end
