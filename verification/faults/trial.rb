# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../conformance/compiled'
require_relative '../conformance/judge'
require_relative '../model/chart_misra'
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
        found = found.merge(behaviour) if File.exist?(object)
        found['MISRA'] = misra if misra?(found)
        found
      end
    end

    private

    def path(*names)
      File.join(@folder, *names)
    end

    def object
      path("#{@name}.o")
    end

    # Code with a warning is compiled all the same, for the other checks.
    def compile
      File.write(path("#{@name}.h"), @code.header)
      File.write(path("#{@name}.c"), @code.source)
      arguments = ['-c', path("#{@name}.c"), '-I', @folder, '-I', Workshop::BASE, '-o', object]
      refused = Workshop.gcc(*CompiledChart::FLAGS, *arguments)
      Workshop.gcc('-std=c99', '-w', *arguments) if refused
      refused
    end

    def behaviour
      programs = @workshop.objects(@code.header).to_h { |name, objects| [name, link(name, objects)] }
      driver = CompiledChart.new(programs.delete('driver'), 'gcc')
      found = programs.transform_values { |program| passes?(program) }
      found['back to back'] = answer { @subject.pairs.compare(driver.run(@subject.pairs.commands)) }
      found['own case'] = answer { own_case(driver) } if @subject.scenario
      found
    end

    def link(name, objects)
      program = path(name.tr(' ', '_'))
      Workshop.gcc!(object, *objects, '-o', program)
      program
    end

    def passes?(program)
      output, status = Open3.capture2e(program)
      status.success? ? nil : output
    end

    def answer
      yield.first&.to_s
    rescue CompiledChart::Failed => e
      e.message
    end

    def own_case(driver)
      steps = @subject.scenario.steps
      Conformance::Judge.golden(steps, Conformance::Compiled.new(@subject.scenario, nil).run(steps, driver))
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
