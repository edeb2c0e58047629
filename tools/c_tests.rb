#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Runs the C tests, compiled in one of several ways, with the Unity and the CMock that come with Ceedling.
#
#   ruby tools/c_tests.rb asan      all of them, under AddressSanitizer and UndefinedBehaviorSanitizer, counting what they reach of
#                                   core and charts
#   ruby tools/c_tests.rb gcov      all of them, counting the same in gcc's code
#   ruby tools/c_tests.rb arm       those of core and simulated box, as Cortex-A9 code under qemu
#   ruby tools/c_tests.rb gcc       those with long scenes, whole, on the code of the product
#   ruby tools/c_tests.rb gcc FILE...   these
#
# With gcov, asan and arm every test runs, a long one with a tenth of its scenes (verification/unit/support/scenes.h).
# `make` has compiled the code under test before: into build/<way>/libtest.a; with gcov the core into build/gcov/libcore.a, and what
# is not counted, as the product has it, into build/gcc/libaround.a.

require 'etc'
require 'fileutils'
require 'open3'
require 'yaml'
require_relative 'results'

# One way to compile and run.
class CTests
  UNITY = Dir['.tools/gems/gems/ceedling-*/vendor/unity'].first
  CMOCK = Dir['.tools/gems/gems/ceedling-*/vendor/cmock'].first
  # Flags, libraries, mocks and runners of Ceedling's project.yml hold for whole runs too.
  PROJECT = YAML.safe_load_file(File.expand_path('../project.yml', __dir__), permitted_classes: [Symbol])
  COMPILE, LINK = PROJECT.fetch(:flags).fetch(:test).values_at(:compile, :link)
  DEFINES = [*PROJECT.fetch(:defines).fetch(:test), *PROJECT.fetch(:unity).fetch(:defines)].map { |name| "-D#{name}" }
  # Tests and what they share have levels of their own; a debugger is asked for lines only.
  FLAGS = [*COMPILE.grep_v(/\A-(?:W|O|g\z)/), '-g1', *DEFINES].freeze
  WARNINGS = COMPILE.grep(/\A-W/).freeze
  LIBRARIES = [*LINK, *PROJECT.fetch(:libraries).fetch(:system).map { |name| "-l#{name}" }].freeze
  # Half of the time of the default linker.
  LINKER = '-fuse-ld=gold'
  # The cache of `make test`, or none.
  CACHE = ENV.fetch('COMPILER_CACHE', '').split.freeze
  TENTH = '-DSCENE_DIVISOR=10U'
  # A program leaves its counts when it ends; a test counts too, as it may call functions of headers that the core does not call.
  COUNTED = %w[-fprofile-instr-generate -fcoverage-mapping].freeze
  WAYS = {
    'asan' => { compiler: %W[clang-19 #{TENTH} -fsanitize=address,undefined -fno-sanitize-recover=all] + COUNTED + WARNINGS,
                runner: [], libraries: LIBRARIES },
    'arm' => { compiler: %W[arm-linux-gnueabihf-gcc #{TENTH} -mcpu=cortex-a9 -mfpu=vfpv3-d16 -static] + WARNINGS,
               runner: %w[qemu-arm], libraries: %w[-lm] },
    'gcc' => { compiler: %w[gcc] + WARNINGS, runner: [], libraries: LIBRARIES },
    'gcov' => { compiler: %W[gcc #{TENTH} --coverage] + WARNINGS, runner: [], libraries: LIBRARIES,
                code: %w[-Wl,--start-group build/gcov/libcore.a build/gcc/libaround.a -Wl,--end-group] }
  }.freeze
  # A test that includes one of these has long scenes.
  SCENES = %w[unit/support/scenes integration/support/recorded scenes recorded].freeze
  # The tests of a chart are as generated: beside it.
  FOLDERS = %w[core app bsp bsp/include build/gen build/gen/charts verification].freeze
  ROBOT_TESTS = 'core/robot/*/test'
  FILES = ['verification/{unit,integration}/*/test_*.c', "#{ROBOT_TESTS}/test_*.c", 'build/gen/tests/test_*.c'].freeze
  SUPPORT = Dir['verification/*/support/*.c'] + Dir["#{ROBOT_TESTS}/*.c"].grep_v(%r{/test_\w+\.c\z}) +
            ["#{UNITY}/src/unity.c", "#{CMOCK}/src/cmock.c"]
  PART = /^#include "([^"]+\.inc)"$/
  ALWAYS = %w[contract_trap unity cmock].freeze
  RUNNER = PROJECT.fetch(:unity).slice(:use_param_tests)
                  .merge(PROJECT.fetch(:cmock).slice(:mock_prefix, :enforce_strict_ordering)).freeze
  # A test may have a table of the name that the runner gives to an argument.
  NO_SHADOW = %(#pragma GCC diagnostic ignored "-Wshadow"\n)
  MOCK = /\A#{RUNNER.fetch(:mock_prefix)}/
  # Report of Unity on each test.
  VERDICT = /^(?<file>\S+\.c):(?<line>\d+):(?<test>test_.+?):(?<word>PASS|FAIL|IGNORE)(?:: ?(?<message>.*))?$/
  WORDS = { 'PASS' => 'pass', 'FAIL' => 'fail', 'IGNORE' => 'ignore' }.freeze
  LAST_LINES = 25
  # No program takes a tenth of it; one that never ends would take the whole run with it.
  LONGEST_S = 900
  TIMED_OUT = 124

  # A compiler or a program did not end well.
  class Failed < StandardError; end

  # One row for each test that a program speaks of, and one more if it did not end as they say.
  def self.rows(file, output, success)
    rows = output.lines(chomp: true).filter_map { |line| VERDICT.match(line) }.map do |match|
      line = match[:line].to_i unless match[:word] == 'PASS'
      { test: match[:test], file: match[:file], line: line, result: WORDS.fetch(match[:word]), message: match[:message] }
    end
    return rows if rows.any? && success == rows.all? { |row| row[:result] == 'pass' }

    rows << { test: File.basename(file, '.c'), file: file, result: 'fail', message: output.lines.last(LAST_LINES).join }
  end

  def initialize(way, wanted)
    @options = WAYS.fetch(way)
    @out = "build/#{way}/tests"
    @code = @options.fetch(:code, ["build/#{way}/libtest.a"])
    # Counts of an earlier run, and lines that it could count, would stand in for tests that are gone.
    FileUtils.rm_f(Dir["build/#{way}/**/*.gcda", "#{@out}/*.{gcno,o}", "build/#{way}/profiles/*"])
    @profiles = { 'LLVM_PROFILE_FILE' => File.expand_path("build/#{way}/profiles/%p.profraw") }
    @mocks = "build/#{way}/mocks"
    @tests = wanted.any? ? every_test & wanted : tests(way)
    @done = 0
    FileUtils.mkdir_p([@out, @mocks])
    require File.expand_path("#{UNITY}/auto/generate_test_runner")
  end

  # True if every test passed.
  def run
    @support = parallel(SUPPORT + make_mocks) { |source| object(source) }.to_h
    rows = parallel(@tests) { |test| rows_of(test) }.flatten
    Results.leave(rows)
    failed = rows.reject { |row| row[:result] == 'pass' }
    failed.each { |row| puts "#{row[:file]}:#{row[:line]}: #{row[:test]}: #{row[:message]}" }
    puts "#{rows.size - failed.size} tests of #{@tests.size} programs passed, #{failed.size} failed"
    failed.empty? && rows.any?
  end

  private

  def every_test
    Dir[*FILES].sort
  end

  def tests(way)
    case way
    when 'arm' then every_test.reject { |file| needs_more?(file) }
    when 'gcc' then every_test.select { |file| (headers_of(file) & SCENES).any? }
    else every_test
    end
  end

  # More than core and simulated box.
  def needs_more?(file)
    headers_of(file).any? do |header|
      File.exist?("app/#{header}.h") || (File.exist?("bsp/#{header}.h") && !header.start_with?('sim/'))
    end
  end

  # Those of a part that it shares with another test (*.inc) are its own.
  def headers_of(file)
    text = File.read(file)
    text.scan(/#include "([^"]+)\.[ch]"/).flatten + text.scan(PART).flatten.flat_map { |part| headers_of(Dir["{verification,core}/#{part}"].first) }
  end

  def parallel(items, &work)
    queue = Queue.new(items).close
    Array.new(Etc.nprocessors) { Thread.new { drain(queue, &work) } }.flat_map(&:value)
  end

  def drain(queue)
    results = []
    while (item = queue.pop)
      results << yield(item)
    end
    results
  end

  def rows_of(test)
    output, status = Open3.capture2e(@profiles, 'timeout', LONGEST_S.to_s, *@options[:runner], build(test))
    output << "\nIt was ended after #{LONGEST_S} s.\n" if status.exitstatus == TIMED_OUT
    CTests.rows(test, output.scrub, status.success?)
  rescue Failed => e
    CTests.rows(test, e.message.scrub, false)
  ensure
    puts "[#{@done += 1}/#{@tests.size}] #{test}"
    $stdout.flush
  end

  # The runner and its test are compiled as one: a header that both include is read once.
  def build(test)
    program = File.join(@out, File.basename(test, '.c'))
    UnityTestRunnerGenerator.new(RUNNER).run(test, "#{program}_runner.c")
    File.write("#{program}_runner.c", NO_SHADOW + File.read("#{program}_runner.c"))
    compile('-O0', '-include', test, '-c', "#{program}_runner.c", '-o', "#{program}_runner.o")
    call(*@options[:compiler], LINKER, "#{program}_runner.o", *@support.values_at(*sources(test)), *@code, *@options[:libraries],
         '-o', program)
    program
  end

  # Sources that a test brings along by including their header.
  def sources(test)
    @support.keys.select { |source| [*headers_of(test).map { |header| File.basename(header) }, *ALWAYS].include?(File.basename(source, '.c')) }
  end

  # A mock has every function of its header, so that the library's own stay out; it includes that by its bare name.
  # @return their sources
  def make_mocks
    names = @tests.flat_map { |test| headers_of(test) }.grep(MOCK).uniq
    headers = names.map { |name| Dir["{core/*,core/*/*,app/*,app/*/*,bsp/include,/usr/include}/#{name.sub(MOCK, '')}.h"].fetch(0) }
    @mocked = headers.map { |header| File.dirname(header) }.uniq
    call('ruby', "#{CMOCK}/lib/cmock.rb", '-oproject.yml', "--mock_path=#{@mocks}", *headers)
    names.map { |name| "#{@mocks}/#{name}.c" }
  end

  # Its source and its object. It is compiled once and runs in many tests; a test is compiled for one run.
  def object(source)
    object = File.join(@out, "#{File.basename(source, '.c')}.o")
    compile('-O1', '-c', source, '-o', object)
    [source, object]
  end

  def compile(*arguments)
    folders = ["#{UNITY}/src", "#{CMOCK}/src", @mocks, *FOLDERS, *@mocked]
    call(*CACHE, *@options[:compiler], *FLAGS, *folders.map { |folder| "-I#{folder}" }, *arguments)
  end

  def call(*command)
    output, status = Open3.capture2e(*command)
    raise Failed, output unless status.success?
  end
end

exit(CTests.new(ARGV.fetch(0), ARGV.drop(1)).run ? 0 : 1) if $PROGRAM_NAME == __FILE__
