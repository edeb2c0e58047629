# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Runs minitest files and leaves their results for tools/trace.rb, saying how many tests are done:
#
#   ruby tools/test/result_reporter.rb tools/test/test_*.rb tools/test/*/test_*.rb
#
# They run in the same order each time, so that what is red is red again when it is repeated; `--seed N` takes another.

require 'minitest/autorun'
require_relative '../results'

# Collects one row per test.
class ResultReporter < Minitest::AbstractReporter
  ROOT = Pathname.new(File.expand_path('../..', __dir__))

  def initialize
    super
    @total = Minitest::Runnable.runnables.sum { |group| group.runnable_methods.size }
    @rows = []
  end

  def prerecord(group, name)
    puts "[#{@rows.size}/#{@total}] #{group}##{name}"
    $stdout.flush
  end

  def record(result)
    file, line = result.source_location
    row = { test: result.name, file: relative(file), result: verdict(result), assertions: result.assertions }
    row.merge!(line: line_in(file, result.failure) || line, message: result.failure.message) unless result.passed?
    @rows << row
  end

  def report
    Results.leave(@rows.sort_by { |row| [row[:file], row[:test]] })
  end

  private

  def relative(file)
    Pathname.new(File.expand_path(file)).relative_path_from(ROOT).to_s
  end

  # Where in the test's own file it failed.
  def line_in(file, failure)
    place = failure.backtrace.to_a.find { |line| File.expand_path(line[/\A[^:]+/]) == File.expand_path(file) }
    place && place[/:(\d+)/, 1].to_i
  end

  def verdict(result)
    return 'ignore' if result.skipped?

    result.passed? ? 'pass' : 'fail'
  end
end

# Minitest's way to add a reporter; it says more than the dots.
module Minitest
  def self.plugin_result_file_init(_options)
    reporter.reporters.reject! { |one| one.is_a?(ProgressReporter) }
    reporter << ResultReporter.new
  end

  extensions << 'result_file'
end

ARGV.push('--seed', '1') unless ARGV.include?('--seed')
ARGV.shift.then { |file| require File.expand_path(file) } while ARGV.first&.end_with?('.rb')
