# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'open3'
require 'tempfile'

# A generated Unity test as objects, to be linked with any version of its chart's code.
class GeneratedTest
  ROOT = File.expand_path('../../..', __dir__)
  UNITY = File.join(Gem::Specification.find_by_name('ceedling').gem_dir, 'vendor', 'unity')
  DEFINES = %w[-D_GNU_SOURCE -DUNITY_INCLUDE_DOUBLE -DUNITY_SUPPORT_64 -DUNITY_INT_WIDTH=32].freeze
  INCLUDES = ["#{UNITY}/src", "#{ROOT}/core", "#{ROOT}/verification"].map { |folder| "-I#{folder}" }.freeze
  require "#{UNITY}/auto/generate_test_runner"

  # All that a program needs beside the chart.
  attr_reader :objects

  # What is the same in every test, compiled once by each compiler.
  module Framework
    SOURCES = ["#{UNITY}/src/unity.c", "#{ROOT}/verification/unit/support/contract_trap.c"].freeze
    LOCK = Mutex.new

    def self.objects(compiler)
      @objects ||= {}
      LOCK.synchronize { @objects[compiler] ||= SOURCES.map { |source| object(compiler, source) } }.map(&:path)
    end

    def self.object(compiler, source)
      Tempfile.new(%w[unity .o]).tap { |file| GeneratedTest.compile(compiler, source, file.path) }
    end
    private_class_method :object
  end

  def self.compile(compiler, source, object, *flags)
    call(compiler, '-std=c99', '-O0', *DEFINES, *INCLUDES, *flags, '-c', source, '-o', object)
  end

  def self.call(*command)
    output, status = Open3.capture2e(*command)
    raise "#{command.first}: #{output}" unless status.success?
  end

  # test: the C file, charts: the folder of the chart's header, folder: where the objects go.
  def initialize(test, charts, folder, compiler: 'gcc')
    @compiler = compiler
    @charts = charts
    @name = File.join(folder, File.basename(test, '.c'))
    runner = "#{@name}_runner.c"
    UnityTestRunnerGenerator.new(use_param_tests: true).run(test, runner)
    @objects = [test, runner].map { |source| compile(source) } + Framework.objects(compiler)
  end

  # flags are for the code of the chart and for linking.
  def program(code, flags = [])
    GeneratedTest.call(@compiler, *flags, *@objects, compile(code, *flags), '-o', @name)
    @name
  end

  private

  def compile(source, *flags)
    object = "#{@name}_#{File.basename(source, '.c')}.o"
    GeneratedTest.compile(@compiler, source, object, "-I#{@charts}", *flags)
    object
  end
end
