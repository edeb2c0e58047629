#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Proves the sentences of verification/proof for every input, and refutes the faults that are seeded beside them.
#
#   ruby tools/proof/proof.rb [--night] [WORD]   all that has the word in its name; at night the long ones, too
#
# Two run beside each other. A proof whose sentence does not hold, that cannot fail, or beside which a fault is not
# refuted is red.

require_relative 'jobs'
require_relative '../results'

module Proof
  # All of them, the longest known ones first as the list has them.
  class Run
    BESIDE = 2

    def initialize(harnesses, out, at_night:, word: '')
      @out = out
      @word = word
      @jobs = harnesses.flat_map { |harness| jobs_of(harness, at_night) }.select { |job| job.name.include?(word) }
      raise Refused, "there is no proof with '#{word}' in its name" if @jobs.empty?
    end

    # True if all passed.
    def call
      verdicts = run_beside
      Results.leave(verdicts.map { |verdict| row(verdict) }.sort_by { |row| [row[:file], row[:test]] })
      proved, refuted = verdicts.partition { |verdict| verdict.job.is_a?(Proved) }
      @out.puts "#{proved.count(&:passed?)} of #{proved.size} proofs hold with #{proved.sum(&:count)} properties, " \
                "#{refuted.count(&:passed?)} of #{refuted.size} mutants are refuted"
      verdicts.all?(&:passed?) && (@word != '' || covered?(proved))
    end

    private

    # What proofs.yml says to be proved is looked at by a proof of its harness.
    #
    # @satisfies SWR-TOOL-204
    def covered?(verdicts)
      missing = verdicts.group_by { |verdict| verdict.job.harness }.flat_map do |harness, same|
        (harness.functions_proved - same.flat_map { |verdict| verdict.functions.to_a }).map { |name| "#{name} is in no proof of #{harness.file}" }
      end
      @out.puts missing
      missing.empty?
    end

    def jobs_of(harness, at_night)
      functions = harness.functions(at_night: at_night)
      mutants = harness.mutants.select { |mutant| functions.key?(mutant.by) }
      functions.map { |function, line| Proved.new(harness, function, line) } +
        mutants.map { |mutant| Refuted.new(harness, mutant, @number = @number.to_i + 1) }
    end

    def run_beside
      waiting = Queue.new(@jobs).close
      done = []
      lock = Mutex.new
      Array.new(BESIDE) do
        Thread.new do
          while (job = waiting.pop)
            verdict = job.run
            lock.synchronize { say(done.push(verdict).size, verdict) }
          end
        end
      end.each(&:join)
      done
    end

    def say(done, verdict)
      word = verdict.passed? ? 'ok ' : 'RED'
      @out.puts format('[%d/%d] %s %s: %d properties, %.1f s', done, @jobs.size, word, verdict.job.name, verdict.count, verdict.seconds)
      verdict.complaints.each { |complaint| @out.puts "    #{complaint}" }
      @out.flush
    end

    def row(verdict)
      result = verdict.passed? ? 'pass' : 'fail'
      message = verdict.complaints.join("\n") unless verdict.passed?
      verdict.job.row.merge(result: result, assertions: verdict.count, message: message)
    end
  end
end

if $PROGRAM_NAME == __FILE__
  Dir.chdir(File.expand_path('../..', __dir__))
  begin
    words = ARGV - ['--night']
    exit(Proof::Run.new(Proof::Harness.all, $stdout, at_night: ARGV.include?('--night'), word: words.first.to_s).call ? 0 : 1)
  rescue Proof::Refused => e
    abort "proof: #{e.message}"
  end
end
