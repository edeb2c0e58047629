# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../lib/emit/vector'
require_relative '../proof/compiled_chart'
require_relative 'scenario'

module Conformance
  # A chart as compiled C, driven through its driver.
  class Compiled
    FOLDER = File.expand_path('../../../build/conformance', __dir__)
    WARNINGS = %w[-std=c99 -Wall -Wextra -Werror].freeze

    def initialize(scenario)
      @scenario = scenario
      @document = scenario.chart.document
      @folder = File.join(FOLDER, scenario.name)
    end

    # Sentences of the compiler, if it refuses.
    def build
      CompiledChart.write(@folder, ::Chart::Compiled.new(@document, @scenario.chart.walk))
      @program = CompiledChart.build(@folder, @document.name, optimise: '-O1', warnings: WARNINGS)
      []
    rescue CompiledChart::Failed => e
      [e.message]
    end

    # One Seen for each step; nothing can be seen of a :corrupt. program: the one that was built, or another of the
    # same chart.
    def run(steps, program = @program)
      answers = program.run(steps.map { |step| command(step) })
      steps.map { |step| step.kind == :corrupt ? Seen.new : seen(answers.shift, step) }
    end

    private

    def command(step)
      case step.kind
      when :start then 'init'
      when :event then "event #{number(step.value)} #{bits(step.inputs)}"
      when :advance then "advance #{step.value} #{bits(step.inputs)}"
      when :corrupt then "corrupt #{step.value.join(' ')}"
      when :check then 'check'
      end
    end

    def number(event)
      event.is_a?(Integer) ? event : @document.events.index(event)
    end

    def bits(inputs)
      @document.inputs.each_with_index.sum { |input, bit| inputs[input.name] ? 1 << bit : 0 }
    end

    # A check answers whether it repaired; the others, which actions they ask for.
    def seen(line, step)
      vector, result, taken, sound = line.split('|').map(&:strip)
      snapshot = (@vector ||= ::Chart::Vector.new(@document)).decode(vector.split.map(&:to_i))
      actions, repaired = step.kind == :check ? [[], result == '1'] : [names(result.to_i), nil]
      Seen.new(**snapshot.to_h, actions: actions, taken: taken.split(',').map(&:to_i), sound: sound == '1',
                                repaired: repaired)
    end

    def names(bits)
      @document.actions.each_with_index.filter_map { |action, bit| action if bits[bit] == 1 }
    end
  end
end
