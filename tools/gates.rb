#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Runs the gates of verification/gates.yml one after the other and says, last, `N passed, N failed`.
#
#   ruby tools/gates.rb            all gates
#   ruby tools/gates.rb NAME ...   only these
#
# A gate passes when its command ends with 0; its output is kept in build/log/NAME.log. The tests that a gate
# leaves in build/results/NAME.json are counted one by one, and a gate without such a file counts as one.

require 'fileutils'
require 'json'
require 'yaml'

# One gate: a name, a sentence for the user, a command, a time limit.
Gate = Struct.new(:name, :says, :run, :seconds, keyword_init: true) do
  def log
    "build/log/#{name}.log"
  end

  def results
    "build/results/#{name}.json"
  end

  def passes?
    pid = Process.spawn('timeout', '--kill-after=10', seconds.to_s, 'bash', '-euo', 'pipefail', '-c', run,
                        %i[out err] => [log, 'w'], in: '/dev/null')
    Process.wait(pid)
    $CHILD_STATUS.success?
  end

  # Passed and failed tests; a gate that failed without naming a test counts as one failure.
  def count(is_passed)
    verdicts = File.exist?(results) ? JSON.parse(File.read(results)).map { |test| test['result'] } : []
    passed = verdicts.count('pass')
    failed = verdicts.size - passed
    passed += 1 if is_passed && verdicts.empty?
    failed = 1 if !is_passed && failed.zero?
    [passed, failed]
  end
end

# The run as a whole.
class Gates
  def initialize(file, wanted)
    @gates = YAML.safe_load_file(file).map { |row| Gate.new(**row.transform_keys(&:to_sym)) }
    unknown = wanted - @gates.map(&:name)
    abort "gates: unknown gate #{unknown.join(', ')}; there are: #{@gates.map(&:name).join(', ')}" if unknown.any?

    @gates.select! { |gate| wanted.include?(gate.name) } if wanted.any?
  end

  def run
    FileUtils.mkdir_p(%w[build/log build/results])
    counts = @gates.each_with_index.map { |gate, index| run_one(gate, index + 1) }
    passed, failed = counts.transpose.map(&:sum)
    puts "#{passed} passed, #{failed} failed"
    failed.zero?
  end

  private

  def run_one(gate, number)
    FileUtils.rm_f(gate.results)
    print "[#{number}/#{@gates.size}] #{gate.says} ... "
    $stdout.flush
    start = Process.clock_gettime(Process::CLOCK_MONOTONIC)
    is_passed = gate.passes?
    seconds = Process.clock_gettime(Process::CLOCK_MONOTONIC) - start
    passed, failed = gate.count(is_passed)
    puts format('%<verdict>s (%<passed>d passed, %<failed>d failed, %<seconds>d s)',
                verdict: is_passed && failed.zero? ? 'ok' : 'FAILED', passed: passed, failed: failed, seconds: seconds)
    tell_failure(gate) unless is_passed
    [passed, failed]
  end

  def tell_failure(gate)
    puts "--- the end of #{gate.log}:"
    puts File.readlines(gate.log).last(40)
    puts "--- repeat this gate alone with: make gate NAME=#{gate.name}"
  end
end

require 'English'
Dir.chdir(File.expand_path('..', __dir__))
exit(Gates.new('verification/gates.yml', ARGV).run ? 0 : 1)
