#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Turns the report of a test runner into the list of results that trace.rb reads.
#
#   ruby tools/results.rb ceedling   REPORT.json > build/results/unit.json
#   ruby tools/results.rb vitest     REPORT.json > build/results/console.json
#   ruby tools/results.rb playwright REPORT.json > build/results/browser.json
#
# Minitest needs no converter: tools/test/result_reporter.rb writes the list itself.

require 'json'
require 'pathname'

# One converter per runner; each gives rows of test, file and result.
module Results
  class ReportError < StandardError; end

  def self.ceedling(report)
    rows = { 'PassedTests' => 'pass', 'FailedTests' => 'fail', 'IgnoredTests' => 'ignore' }.flat_map do |list, result|
      report.fetch(list).map { |entry| { test: entry['test'], file: entry['file'], result: result } }
    end
    total = report.fetch('Summary').fetch('total_tests')
    raise ReportError, "the summary counts #{total} tests, the lists hold #{rows.size}" unless total == rows.size

    rows
  end

  VITEST = { 'passed' => 'pass', 'failed' => 'fail' }.freeze

  def self.vitest(report)
    report.fetch('testResults').flat_map do |file|
      name = relative(file.fetch('name'))
      rows = file.fetch('assertionResults').map do |test|
        { test: test.fetch('fullName').strip, file: name, result: VITEST.fetch(test.fetch('status'), 'ignore') }
      end
      # A file that cannot be loaded has failed without a single test.
      broken = file['status'] == 'failed' && rows.none? { |row| row[:result] == 'fail' }
      broken ? rows << { test: file['message'].to_s.lines.first.to_s.strip, file: name, result: 'fail' } : rows
    end
  end

  PLAYWRIGHT = { 'expected' => 'pass', 'skipped' => 'ignore' }.freeze

  # A flaky test is a failed test.
  def self.playwright(report)
    folder = report.dig('config', 'rootDir').to_s
    rows = report.fetch('suites').flat_map { |suite| playwright_suite(suite, folder) }
    report.fetch('errors', []).each do |error|
      rows << { test: error['message'].to_s.lines.first.to_s.strip, file: relative(folder), result: 'fail' }
    end
    rows
  end

  def self.playwright_suite(suite, folder)
    rows = suite.fetch('specs', []).flat_map do |spec|
      spec.fetch('tests').map do |test|
        { test: spec.fetch('title'), file: relative(File.join(folder, spec.fetch('file'))),
          result: PLAYWRIGHT.fetch(test.fetch('status'), 'fail') }
      end
    end
    rows + suite.fetch('suites', []).flat_map { |inner| playwright_suite(inner, folder) }
  end

  def self.relative(path)
    path = Pathname.new(path)
    path.absolute? ? path.relative_path_from(Pathname.pwd).to_s : path.to_s
  end
end

if $PROGRAM_NAME == __FILE__
  runner, file = ARGV
  abort 'usage: results.rb ceedling|vitest|playwright REPORT.json' \
    unless %w[ceedling vitest playwright].include?(runner) && ARGV.size == 2
  begin
    rows = Results.public_send(runner, JSON.parse(File.read(file)))
  rescue Results::ReportError, JSON::ParserError, KeyError, SystemCallError => e
    abort "#{file}: #{e.message.lines.first.strip}"
  end
  puts JSON.pretty_generate(rows)
end
