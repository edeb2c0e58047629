#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Runs a test runner that is not ours, says how far it is, and leaves what its report holds for tools/trace.rb.
#
#   ruby tools/results.rb vitest REPORT.json COMMAND...
#
# Each runner leaves its results by `Results.leave`: in build/results/<name of the gate>.json, as
#
#   run    where they come from, see origin.rb
#   tests  test, file, result (pass, fail or ignore), assertions if counted; line and message unless it passed
#
# Without the name of a gate in RESULT_NAME nothing is left, so that running a test by hand disturbs nothing.

require 'fileutils'
require 'json'
require 'pathname'
require_relative 'origin'

# Results of tests.
module Results
  NAME = 'RESULT_NAME'
  FOLDER = 'build/results'
  # Line that a runner prints once for each of its files, and these files.
  STEPS = { 'vitest' => [/\A\s*\S \S+\.test\.tsx? /, 'app/console/src/**/*.test.{ts,tsx}'] }.freeze

  class << self
    def file(name)
      "#{FOLDER}/#{name}.json"
    end

    # Results of a gate that is gone prove nothing.
    #
    # @satisfies SWR-GATE-490
    def keep_only(names)
      FileUtils.rm_f(Dir["#{FOLDER}/*.json"] - names.map { |name| file(name) })
    end

    # @satisfies SWR-TRACE-002
    def leave(rows)
      name = ENV.fetch(NAME, '')
      return if name.empty?

      FileUtils.mkdir_p(FOLDER)
      run = Origin.of_run.merge('time' => Time.now.utc.iso8601)
      File.write(file(name), "#{JSON.pretty_generate(run: run, tests: rows.map(&:compact))}\n")
    end

    # The tests of a gate; none if it left none.
    def read(name)
      File.exist?(file(name)) ? JSON.parse(File.read(file(name))).fetch('tests') : []
    end

    # Runs the command; true if it ended well and left its report.
    def run(runner, report, command)
      FileUtils.rm_f(report)
      IO.popen(command, err: %i[child out]) { |output| count(output, *STEPS.fetch(runner)) }
      status = Process.last_status
      leave(public_send(runner, JSON.parse(File.read(report))))
      status.success?
    rescue Errno::ENOENT
      abort "#{command.first} left no #{report}"
    end

    def vitest(report)
      report.fetch('testResults').flat_map do |file|
        name = relative(file.fetch('name'))
        rows = file.fetch('assertionResults').map { |test| vitest_row(test, name) }
        # A file that cannot be loaded has failed without a single test.
        broken = file['status'] == 'failed' && rows.none? { |row| row[:result] == 'fail' }
        message = file['message'].to_s
        broken ? rows << { test: message.lines.first.to_s.strip, file: name, result: 'fail', message: message } : rows
      end
    end

    private

    VERDICTS = { 'passed' => 'pass', 'failed' => 'fail' }.freeze

    def vitest_row(test, file)
      message = test.fetch('failureMessages', []).join("\n")
      { test: test.fetch('fullName').strip, file: file, line: message[/#{Regexp.escape(file)}:(\d+)/, 1]&.to_i,
        result: VERDICTS.fetch(test.fetch('status'), 'ignore'),
        message: message.empty? ? nil : message.lines(chomp: true).grep_v(/\A\s+at /).join("\n") }
    end

    def count(output, step, files)
      total = Dir[files].size
      done = 0
      output.each_line do |line|
        print(line.scrub.match?(step) ? "[#{done}/#{total}] #{line}" : line)
        done += 1 if line.scrub.match?(step)
        $stdout.flush
      end
    end

    def relative(path)
      path = Pathname.new(path)
      path.absolute? ? path.relative_path_from(Pathname.pwd).to_s : path.to_s
    end
  end
end

if $PROGRAM_NAME == __FILE__
  runner, report, *command = ARGV
  abort 'usage: results.rb vitest REPORT.json COMMAND...' unless Results::STEPS.key?(runner) && command.any?
  begin
    exit(Results.run(runner, report, command) ? 0 : 1)
  rescue JSON::ParserError, KeyError => e
    abort "#{report}: #{e.message.lines.first.strip}"
  end
end
