# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'fileutils'
require_relative '../results'
require_relative 'compiler_cache'
require_relative 'complaint'
require_relative 'processes'

module Gates
  # How a gate ended, in tests, and why it is red; one that was left out has nothing to complain about. A gate without
  # tests counts as one.
  Verdict = Struct.new(:gate, :passed, :failed, :seconds, :complaints, keyword_init: true) do
    def passed?
      failed.zero?
    end
  end

  # A gate that runs. Its output is its log, and reports its progress by lines that begin with `[done/total]`.
  class Job
    # No load makes a gate keep silent for that long; only one that hangs does.
    SILENCE_SECONDS = 1800
    PROGRESS = %r{^\[(\d+)/(\d+)\] }
    TAIL_BYTES = 16_384
    # Variables that an outer `make gate NAME=...` would pass to each make of a gate.
    OUTER_MAKE = %w[MAKEFLAGS MFLAGS MAKEOVERRIDES MAKELEVEL NAME].to_h { |name| [name, nil] }.freeze

    attr_reader :gate, :pid

    # silence: after how many seconds without a word it counts as hanging.
    def initialize(gate, origin, silence: SILENCE_SECONDS)
      @gate = gate
      @silence = silence
      @began = @heard = Gates.now
      @size = 0
      FileUtils.rm_f(Results.file(gate.name))
      environment = OUTER_MAKE.merge(Results::NAME => gate.name, Origin::ENVIRONMENT => JSON.generate(origin), **CompilerCache.environment)
      @pid = Process.spawn(environment, *priority, 'bash', '-euo', 'pipefail', '-c', gate.run,
                           %i[out err] => [gate.log, 'w'], in: '/dev/null', pgroup: true)
    end

    def seconds
      Gates.now - @began
    end

    # Tests that are done and tests in all; nil as long as it says nothing of them.
    def progress
      File.open(gate.log) do |file|
        file.seek([file.size - TAIL_BYTES, 0].max)
        file.read.scrub.scan(PROGRESS).last&.map(&:to_i)
      end
    end

    # Ends it when it hangs.
    #
    # @satisfies SWR-GATE-007
    def watch
      size = File.size(gate.log)
      @heard = Gates.now if size != @size
      @size = size
      return if Gates.now - @heard < @silence

      @hung = Complaint.new(gate.log, ["It had said nothing for #{@silence} seconds and was ended."])
      Processes.end_tree(pid)
    end

    def verdict(status)
      passed, bad = results.partition { |test| test['result'] == 'pass' }
      complaints = bad.map { |test| Complaint.of_test(test) } + @unread.to_a
      complaints << (@hung || Complaint.of_log(gate.log)) if bad.empty? && !status.success?
      count = passed.empty? && complaints.empty? ? 1 : passed.size
      Verdict.new(gate: gate, passed: count, failed: complaints.size, seconds: seconds, complaints: complaints)
    end

    private

    # One that computes leaves a core to one that waits, as soon as that goes on.
    #
    # @satisfies SWR-GATE-290
    def priority
      gate.waits || gate.alone ? [] : %w[nice -n 10]
    end

    # A runner that ran no test, or could not say what it ran, has not passed.
    def results
      tests = Results.read(gate.name)
      raise KeyError, 'it holds no test' if tests.empty? && File.exist?(Results.file(gate.name))

      tests
    rescue JSON::ParserError, KeyError, NoMethodError => e
      @unread = [Complaint.new(Results.file(gate.name), [e.message.lines.first.to_s.strip])]
      []
    end
  end
end
