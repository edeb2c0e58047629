# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'fileutils'
require 'tmpdir'
require_relative '../../tools/chart/emit/driver'
require_relative '../../tools/chart/emit/tests/paths_test'
require_relative '../../tools/chart/emit/tests/walk_test'
require_relative '../../tools/test/generated_test'
require_relative '../model/compiled_chart'

module Faults
  # What is compiled once for all versions of a chart's code: the driver and the tests that the untouched compiler
  # generates. They include the version's header, which is the same for nearly all.
  class Workshop
    BASE = File.join(CompiledChart::ROOT, 'core/base')
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

    # Names of the generated tests, and 'driver', to the objects of each.
    def objects(header)
      @lock.synchronize { @made[header] ||= make(header, File.join(@folder, @made.length.to_s)) }
    end

    private

    def make(header, folder)
      FileUtils.mkdir_p(folder)
      File.write(File.join(folder, "#{@subject.document.name}_chart.h"), header)
      tests = @subject.scenario ? {} : TESTS
      tests.transform_values { |test| test_objects(test, folder) }.merge('driver' => [driver(folder)])
    end

    def test_objects(test, folder)
      file = File.join(folder, "#{test.name.split('::').last}.c")
      File.write(file, test.new(@subject.document, @subject.walk).emit)
      GeneratedTest.new(file, folder, folder).objects
    end

    def driver(folder)
      file = File.join(folder, 'driver.c')
      File.write(file, Chart::Driver.new(@subject.document, @subject.walk).emit)
      Workshop.gcc!('-std=c99', '-c', file, '-I', folder, '-I', BASE, '-o', "#{file}.o")
      "#{file}.o"
    end
  end
end
