# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'open3'
require 'rbconfig'

# A generated Unity test as objects, to be linked with any version of its chart's code.
class GeneratedTest
  ROOT = File.expand_path('../..', __dir__)
  UNITY = File.join(Gem::Specification.find_by_name('ceedling').gem_dir, 'vendor', 'unity')
  SUPPORT = File.join(ROOT, 'verification/unit/support')
  DEFINES = %w[-D_GNU_SOURCE -DUNITY_INCLUDE_DOUBLE -DUNITY_SUPPORT_64 -DUNITY_INT_WIDTH=32].freeze

  # All that a program needs beside the chart.
  attr_reader :objects

  # test: the C file, charts: the folder of the chart's header, folder: where the objects go.
  def initialize(test, charts, folder, compiler: 'gcc')
    @compiler = compiler
    @charts = charts
    @name = File.join(folder, File.basename(test, '.c'))
    call(RbConfig.ruby, "#{UNITY}/auto/generate_test_runner.rb", '--use_param_tests=1', test, "#{@name}_runner.c")
    sources = [test, "#{@name}_runner.c", "#{UNITY}/src/unity.c", "#{SUPPORT}/contract_trap.c"]
    @objects = sources.map { |source| compile(source, []) }
  end

  # flags are for the code of the chart and for linking.
  def program(code, flags = [])
    call(@compiler, *flags, *@objects, compile(code, flags), '-o', @name)
    @name
  end

  private

  def compile(source, flags)
    object = "#{@name}_#{File.basename(source, '.c')}.o"
    includes = [@charts, "#{UNITY}/src", "#{ROOT}/core/base", SUPPORT].map { |folder| "-I#{folder}" }
    call(@compiler, '-std=c99', '-O0', *DEFINES, *includes, *flags, '-c', source, '-o', object)
    object
  end

  def call(*command)
    output, status = Open3.capture2e(*command)
    raise "#{command.first}: #{output}" unless status.success?
  end
end
