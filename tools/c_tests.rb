#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Runs the C tests once more, compiled another way than Ceedling does.
#
#   ruby tools/c_tests.rb asan      all of them, under AddressSanitizer and UndefinedBehaviorSanitizer
#   ruby tools/c_tests.rb arm       those of core and simulated box, as Cortex-A9 code under qemu
#
# `make` has compiled the code under test into build/<way>/libtest.a before.

require 'English'
require 'etc'
require 'fileutils'
require 'json'
require 'open3'

# One way to compile and run.
class CTests
  UNITY = Dir[".tools/gems/gems/ceedling-*/vendor/unity"].first
  DEFINES = %w[-D_GNU_SOURCE -DUNITY_INCLUDE_DOUBLE -DUNITY_SUPPORT_64 -DUNITY_INT_WIDTH=32].freeze
  WAYS = {
    'asan' => { compiler: %w[gcc -fsanitize=address,undefined -fno-sanitize-recover=all], runner: [],
                libraries: %w[-lzstd -lcrypto -lpthread -lrt -lm] },
    'arm' => { compiler: %w[arm-linux-gnueabihf-gcc -mcpu=cortex-a9 -mfpu=vfpv3-d16 -static], runner: %w[qemu-arm],
               libraries: %w[-lm] }
  }.freeze
  FOLDERS = Dir['core/*/'] + %w[build/gen/charts build/gen/limits build/gen/robot build/gen/names bsp/include bsp/sim
                                verification/unit/support verification/integration/support] + Dir['app/*/']

  def initialize(way)
    @way = way
    @options = WAYS.fetch(way)
    @out = "build/#{way}/tests"
    FileUtils.mkdir_p(@out)
  end

  def run
    queue = Queue.new
    tests.each { |test| queue << test }
    results = []
    workers = Array.new(Etc.nprocessors) { Thread.new { results.concat(work(queue)) } }
    workers.each(&:join)
    failed = results.reject { |result| result[:passed] }
    failed.each { |result| puts "FAILED #{result[:test]}", result[:output].lines.last(25) }
    puts "#{results.size - failed.size} test programs passed, #{failed.size} failed (#{@way})"
    failed.empty? && results.any?
  end

  private

  def tests
    files = Dir['verification/{unit,integration}/test_*.c'] + Dir['build/gen/tests/test_*.c']
    files.reject! { |file| File.read(file).include?('#include "mock_') } # Ceedling makes the mocks.
    return files.sort unless @way == 'arm'

    files.reject { |file| needs_app?(file) }.sort
  end

  def needs_app?(file)
    headers = File.read(file).scan(/#include "([^"]+)"/).flatten
    headers.any? { |header| Dir["app/*/#{header}"].any? }
  end

  def work(queue)
    results = []
    while (test = next_of(queue))
      results << run_test(test)
    end
    results
  end

  def next_of(queue)
    queue.pop(true)
  rescue ThreadError
    nil
  end

  def run_test(test)
    program = File.join(@out, File.basename(test, '.c'))
    output, status = Open3.capture2e('ruby', "#{UNITY}/auto/generate_test_runner.rb", '--use_param_tests=1', test, "#{program}_runner.c")
    output, status = Open3.capture2e(*compile(test, program)) if status.success?
    output, status = Open3.capture2e(*@options[:runner], program) if status.success?
    { test: test, passed: status.success?, output: output }
  end

  def compile(test, program)
    [*@options[:compiler], '-std=c99', '-g', '-O1', '-ffp-contract=off', *DEFINES, "-I#{UNITY}/src",
     *FOLDERS.map { |folder| "-I#{folder}" }, test, "#{program}_runner.c", *sources(test), "#{UNITY}/src/unity.c",
     "build/#{@way}/libtest.a", *@options[:libraries], '-o', program]
  end

  # What a test brings along by including its header.
  def sources(test)
    headers = File.read(test).scan(/#include "([^"]+)\.h"/).flatten
    (headers | ['contract_trap']).filter_map { |name| Dir["verification/*/support/#{name}.c"].first }
  end
end

Dir.chdir(File.expand_path('..', __dir__))
exit(CTests.new(ARGV.fetch(0)).run ? 0 : 1)
