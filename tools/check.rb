#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Looks at a change in about two minutes: its form, types and rooms, the tests that reach its files, and the trace of
# the requirements. A change that passes here may still fail in `make test`, which looks at the whole.
#
#   ruby tools/check.rb [COMMIT]   what differs from COMMIT, the last one unless said; new files too. `make check` calls
#                                  it, with the pinned Node in PATH
#
# Exit code 0: nothing found. 1: a step failed; its output is shown.

require 'open3'
require_relative 'c_tests'

# Files that differ, and the tests that reach them.
class Change
  TOOLS_TESTS = %w[tools/test/test_*.rb tools/test/*/test_*.rb tools/*/test/test_*.rb].freeze
  MOST_C_TESTS = 24

  attr_reader :files

  # Check of files by their names in `root`.
  def initialize(files, root)
    @root = root
    @files = files
  end

  def of(*extensions)
    @files.select { |file| extensions.include?(File.extname(file)) }
  end

  def in?(folder)
    @files.any? { |file| file.start_with?("#{folder}/") }
  end

  # Tests that changed, those of a module that changed, and those that include it; of these not more than a check has time for.
  def c_tests
    changed = @files & Dir.glob(CTests::FILES, base: @root)
    own, others = reached.partition { |test| modules.include?(File.basename(test, '.c').delete_prefix('test_')) }
    (changed | own | others).first([MOST_C_TESTS, changed.size].max)
  end

  # Tests of tools that changed, and those of the tool that changed.
  def ruby_tests
    names = of('.rb').map { |file| "test_#{File.basename(file, '.rb').delete_prefix('test_')}.rb" }
    Dir.glob(TOOLS_TESTS, base: @root).select { |test| names.include?(File.basename(test)) }
  end

  private

  def modules
    of('.c', '.h').map { |file| File.basename(file, '.*') }
  end

  def reached
    headers = of('.c', '.h').map { |file| "#{file.delete_suffix(File.extname(file))}.h" } + of('.inc')
    Dir.glob(CTests::FILES, base: @root).sort.select { |test| includes(test).any? { |one| headers.any? { |header| header.end_with?("/#{one}") } } }
  end

  def includes(test)
    @includes ||= {}
    @includes[test] ||= File.read(File.join(@root, test)).scan(/^#include "(.+)"/).flatten.flat_map { |one| [one, *of_part(one)] }
  end

  # Includes of a part that tests share.
  def of_part(name)
    name.end_with?('.inc') ? Dir.glob("{verification,core}/#{name}", base: @root).flat_map { |file| includes(file) } : []
  end
end

# The steps, one after the other.
#
# @satisfies SWR-TOOL-040
# @satisfies SWR-TOOL-041
class Check
  CONSOLE = 'app/console'

  def initialize(change)
    @change = change
    @failed = []
  end

  def run
    steps.each { |name, command| step(name, command) unless command.empty? }
    puts(@failed.empty? ? 'check: nothing found; `make test` looks at the whole' : "check: failed: #{@failed.join(', ')}")
    @failed.empty?
  end

  private

  def steps
    { 'form of C' => listed(%w[clang-format --dry-run --Werror], @change.of('.c', '.h', '.cpp')),
      'form of Ruby' => listed(%w[rubocop --format emacs], @change.of('.rb')),
      'programs' => %w[make --no-print-directory -j2 programs build/gcc/libtest.a],
      'rooms' => %w[ruby tools/rooms.rb],
      'functions' => @change.of('.c', '.h').empty? ? [] : %w[ruby tools/functions.rb],
      'tables' => %w[ruby tools/tables.rb --check],
      'trace' => %w[ruby tools/trace.rb check --static],
      'tests in C' => listed(%w[ruby tools/c_tests.rb gcc], @change.c_tests),
      'tests in Ruby' => listed(%w[ruby tools/test/result_reporter.rb], @change.ruby_tests),
      **console }
  end

  def console
    return {} unless @change.in?(CONSOLE)

    sources = @change.of('.ts', '.tsx').map { |file| file.delete_prefix("#{CONSOLE}/") }
    npm = %w[npm --silent --prefix] << CONSOLE
    { 'types of the console' => [*npm, 'run', 'typecheck'], 'its rules' => [*npm, 'run', 'lint'],
      'its form' => [*npm, 'run', 'format:check'],
      'its tests' => listed([*npm, 'exec', '--', 'vitest', 'related', '--run', '--root', CONSOLE], sources) }
  end

  def listed(command, files)
    files.empty? ? [] : command + files
  end

  def step(name, command)
    began = Process.clock_gettime(Process::CLOCK_MONOTONIC)
    said, status = Open3.capture2e(*command)
    seconds = (Process.clock_gettime(Process::CLOCK_MONOTONIC) - began).round
    puts "check: #{name}: #{status.success? ? 'ok' : 'failed'} (#{seconds} s)"
    return if status.success?

    puts said
    @failed << name
  end
end

if $PROGRAM_NAME == __FILE__
  Dir.chdir(File.expand_path('..', __dir__))
  listed = [['git', 'diff', '--name-only', '--diff-filter=d', '-z', ARGV.fetch(0, 'HEAD')],
            %w[git ls-files --others --exclude-standard -z]].map do |command|
    said, status = Open3.capture2(*command)
    abort 'check: git does not know what has changed' unless status.success?
    said.split("\0")
  end
  exit(Check.new(Change.new(listed.flatten.uniq, Dir.pwd)).run ? 0 : 1)
end
