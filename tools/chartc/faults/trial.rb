# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../conformance/compiled'
require_relative '../conformance/judge'
require_relative '../proof/chart_misra'
require_relative 'workshop'

module Faults
  # One version of a chart's code before every check that fits the chart. A check answers why it rejects the version, or
  # nil.
  class Trial
    BEHAVIOUR = ['walk test', 'path test', 'back to back', 'own case'].freeze
    CHECKS = ['C compiler', *BEHAVIOUR, 'MISRA'].freeze

    def initialize(subject, code, workshop)
      @subject = subject
      @code = code
      @workshop = workshop
      @name = "#{subject.document.name}_chart"
    end

    # check => reason or nil, for each check that was asked.
    def verdicts
      Dir.mktmpdir('trial') do |folder|
        @folder = folder
        found = { 'C compiler' => compile }
        found = found.merge(behaviour) if File.exist?(library)
        found['MISRA'] = misra if misra?(found)
        found
      end
    end

    private

    def path(*names)
      File.join(@folder, *names)
    end

    def library
      path(Workshop::LIBRARY)
    end

    # Code with a warning is compiled all the same, for the other checks.
    def compile
      File.write(path("#{@name}.h"), @code.header)
      File.write(path("#{@name}.c"), @code.source)
      arguments = [*Workshop::SHARED, path("#{@name}.c"), '-I', @folder, '-I', Workshop::CORE, '-o', library]
      refused = Workshop.gcc(*CompiledChart::FLAGS, *arguments)
      Workshop.gcc('-std=c99', '-w', *arguments) if refused
      refused
    end

    def behaviour
      programs = @workshop.programs(@code.header, library)
      driver = Linked.new(programs.fetch('driver'), @folder)
      tests = programs.except('driver')
      found = tests.transform_values { |program| Linked.new(program, @folder).complaint }
      found['back to back'] = answer { @subject.pairs.compare(driver.run(@subject.pairs.commands)) }
      found['own case'] = answer { own_case(driver) } if @subject.scenario
      found
    end

    def answer
      yield.first&.to_s
    rescue CompiledChart::Failed => e
      e.message
    end

    def own_case(driver)
      steps = @subject.scenario.steps
      Conformance::Judge.golden(steps, Conformance::Compiled.new(@subject.scenario).run(steps, driver))
    end

    # It takes seconds, so it is asked about what all others accept; and it is promised for product charts.
    def misra?(found)
      found.values.none? && @subject.scenario.nil?
    end

    def misra
      ChartMisra.findings(@subject.document.name, @code.header, @code.source).first&.to_s
    end
  end
end
