# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'fileutils'
require 'tmpdir'
require_relative '../lib/emit/driver'
require_relative '../lib/emit/tests/paths_test'
require_relative '../lib/emit/tests/walk_test'
require_relative '../proof/generated_test'
require_relative '../proof/compiled_chart'

module Faults
  # A program that finds the code of its chart in a folder.
  Linked = Struct.new(:program, :folder) do
    # The answers to a list of commands, as of CompiledChart.
    def run(commands)
      output, errors, status = call("#{commands.join("\n")}\n")
      raise CompiledChart::Failed, "#{program} ended early: #{output.lines.last}#{errors}" unless status.success?

      output.lines(chomp: true)
    end

    # What a test says if it fails.
    def complaint
      output, errors, status = call('')
      status.success? ? nil : output + errors
    end

    private

    def call(input)
      Open3.capture3({ 'LD_LIBRARY_PATH' => folder }, program, stdin_data: input)
    end
  end

  # What is compiled once for all versions of a chart's code, which are shared libraries: the driver and the tests that
  # the untouched compiler generates. They include the version's header, which is the same for nearly all.
  class Workshop
    CORE = File.join(CompiledChart::ROOT, 'core')
    LIBRARY = 'chart.so'.freeze
    SHARED = ['-shared', '-fPIC', '-nostdlib', "-Wl,-soname,#{LIBRARY}"].freeze
    TESTS = { 'walk test' => Chart::WalkTest, 'path test' => Chart::PathsTest }.freeze

    # What the compiler says if it refuses.
    def self.gcc(*arguments)
      output, status = Open3.capture2e('gcc', '-O0', *arguments)
      status.success? ? nil : output
    end

    def self.gcc!(*arguments)
      refused = gcc(*arguments)
      raise refused if refused
    end

    def initialize(subject)
      @subject = subject
      @folder = Dir.mktmpdir('faults')
      @made = {}
      @lock = Mutex.new
    end

    def close
      FileUtils.remove_entry(@folder)
    end

    # Names of the generated tests, and 'driver', to the program of each. library: a version with this header.
    def programs(header, library)
      @lock.synchronize { @made[header] ||= make(header, library, File.join(@folder, @made.length.to_s)) }
    end

    private

    def make(header, library, folder)
      FileUtils.mkdir_p(folder)
      File.write(File.join(folder, "#{@subject.document.name}_chart.h"), header)
      tests = @subject.scenario ? {} : TESTS
      objects = tests.transform_values { |test| test_objects(test, folder) }.merge('driver' => [driver(folder)])
      objects.to_h { |name, all| [name, link(File.join(folder, name.tr(' ', '_')), all, library)] }
    end

    # A chart calls back when its contract is broken.
    def link(program, objects, library)
      Workshop.gcc!('-rdynamic', *objects, library, '-o', program)
      program
    end

    def test_objects(test, folder)
      file = File.join(folder, "#{test.name.split('::').last}.c")
      File.write(file, test.new(@subject.document, @subject.walk).emit)
      GeneratedTest.new(file, folder, folder).objects
    end

    def driver(folder)
      file = File.join(folder, 'driver.c')
      File.write(file, Chart::Driver.new(@subject.document, @subject.walk).emit)
      Workshop.gcc!('-std=c99', '-c', file, '-I', folder, '-I', CORE, '-o', "#{file}.o")
      "#{file}.o"
    end
  end
end
