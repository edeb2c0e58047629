# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'compiled'
require_relative 'framework'
require_relative 'judge'
require_relative 'own_cases'

module Conformance
  # Everything that is to be run, compiled beforehand on two processors.
  class Suite
    PROCESSORS = 2

    attr_reader :own, :framework

    def initialize
      @own = OwnCases.scenarios
      @framework = Framework.new
      @programs = scenarios.to_h { |scenario| [scenario, Compiled.new(scenario)] }
      build
    end

    def scenarios
      own + framework.scenarios
    end

    # Sentences on what went wrong; none is good.
    def faults(scenario)
      interpreted = scenario.interpretable? ? Interpreted.new(scenario.chart.document).run(scenario.steps) : nil
      of_interpreter = interpreted ? named('interpreter', Judge.golden(scenario.steps, interpreted)) : []
      of_interpreter + named('code', program_faults(@programs.fetch(scenario), scenario.steps, interpreted))
    end

    # What SCION does otherwise in a case of our own.
    def scion_faults(scenario)
      document = scenario.chart.document
      @session ||= Scion::Session.new
      machine = Interpreted.new(document, ScionStepper.new(@session, document))
      Judge.golden(scenario.steps, machine.run(scenario.steps))
    end

    private

    def build
      queue = Queue.new
      @programs.each_value { |program| queue << program }
      queue.close
      workers = Array.new(PROCESSORS) { Thread.new { build_all(queue) } }
      @refusals = workers.map(&:value).reduce(:merge)
    end

    def build_all(queue)
      refusals = {}
      while (program = queue.pop)
        refusals[program] = program.build
      end
      refusals
    end

    def program_faults(program, steps, interpreted)
      refused = @refusals.fetch(program)
      return refused if refused.any?

      seen = program.run(steps)
      Judge.golden(steps, seen) + (interpreted ? Judge.same(steps, seen, interpreted) : [])
    rescue CompiledChart::Failed => e
      [e.message]
    end

    def named(machine, sentences)
      sentences.map { |sentence| "#{machine}: #{sentence}" }
    end
  end
end
