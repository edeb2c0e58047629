# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'etc'
require 'fileutils'
require 'json'
require_relative 'job'
require_relative 'plan'
require_relative 'progress'

module Gates
  def self.now
    Process.clock_gettime(Process::CLOCK_MONOTONIC)
  end

  # One run of gates: starts what the plan allows, until all have ended.
  #
  # @satisfies SWR-GATE-001
  class Run
    # Seconds of each gate when it last passed here.
    SECONDS = 'build/log/seconds.json'
    # The seconds in which the gate kept a core busy.
    CORE_SECONDS = 'build/log/core_seconds.json'
    POLL_SECONDS = 0.1
    SIGNALS = %w[INT TERM HUP QUIT].freeze
    LOCK = 'build/.gates'

    def initialize(gates, out, cores: Etc.nprocessors)
      FileUtils.mkdir_p([File.dirname(SECONDS), Results::FOLDER])
      @lock = File.open(LOCK, File::RDWR | File::CREAT)
      @lock.flock(File::LOCK_EX | File::LOCK_NB) || raise(Refused, 'gates run in this folder already; wait for them')
      @waiting = gates
      @jobs = []
      @verdicts = []
      @expected = gates.to_h { |gate| [gate.name, gate.seconds] }.merge(measured)
      @plan = Plan.new(cores, @expected)
      @reporter = Progress.new(out, gates.size)
    end

    # True if every gate has passed.
    def call
      Processes.adopt_orphans
      SIGNALS.each { |signal| trap(signal) { @signal = signal } }
      @origin = Origin.here
      step while !@signal && (@waiting.any? || @jobs.any?)
      return interrupted if @signal

      @reporter.finish(@verdicts)
      @verdicts.all?(&:passed?)
    ensure
      Processes.end_tree(Process.pid)
    end

    private

    def step
      leave_out
      @plan.startable(passed, @jobs.map(&:gate), @waiting).each { |gate| start(gate) }
      raise Refused, "#{@waiting.map(&:name).join(', ')}: what they need never comes" if @jobs.empty? && @waiting.any?

      reap
      @jobs.each(&:watch)
      @reporter.progress(@jobs, seconds_left) if @jobs.any?
      sleep POLL_SECONDS
    end

    def passed
      @verdicts.select(&:passed?).map(&:gate)
    end

    def start(gate)
      @waiting -= [gate]
      @jobs << Job.new(gate, @origin)
    end

    # A gate that needs a red one cannot run.
    def leave_out
      red = (@verdicts.map(&:gate) - passed).map(&:name)
      gate = @waiting.find { |one| (one.needs & red).any? } || return
      @waiting -= [gate]
      @verdicts << Verdict.new(gate: gate, passed: 0, failed: 1, seconds: 0, complaints: [])
      @reporter.gate_left_out(gate, gate.needs & red)
      leave_out
    end

    # Adopted processes end here too; the seconds of a gate are those of the processes that it has waited for.
    def reap
      before = core_seconds
      while (pid, status = Process.wait2(-1, Process::WNOHANG))
        after = core_seconds
        job = @jobs.find { |one| one.pid == pid }
        ended(job, job.verdict(status), after - before) if job
        before = after
      end
    rescue Errno::ECHILD
      nil
    end

    # The core seconds of all processes that have ended here.
    #
    # @satisfies SWR-GATE-361
    def core_seconds
      Process.times.then { |times| times.cutime + times.cstime }
    end

    def ended(job, verdict, core_seconds)
      @jobs -= [job]
      @verdicts << verdict
      @reporter.gate_ended(verdict)
      return unless verdict.passed?

      note(SECONDS, job.gate.name => [verdict.seconds.round(1), 0.1].max)
      note(CORE_SECONDS, job.gate.name => core_seconds.round(1))
    end

    def note(file, row)
      File.write("#{file}.new", JSON.generate(measured(file).merge(row)))
      File.rename("#{file}.new", file)
    end

    def measured(file = SECONDS)
      File.exist?(file) ? JSON.parse(File.read(file)) : {}
    rescue JSON::ParserError
      {}
    end

    def seconds_left
      pace = self.pace
      running = @jobs.to_h { |job| [job.gate, [@expected[job.gate.name] - (job.seconds / pace), 0].max] }
      @plan.seconds_left(passed, running, @waiting) * pace
    end

    # Share by which it takes longer than expected: an ended or overdue gate counts as it was, the rest as expected.
    def pace
      known = @verdicts + @jobs.select { |job| job.seconds > @expected[job.gate.name] }
      late = known.sum { |one| one.seconds - @expected[one.gate.name] }
      all = @expected.values.sum
      (all + late) / all
    end

    def interrupted
      @reporter.interrupted(@jobs)
      false
    end
  end
end
