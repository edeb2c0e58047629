# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'io/console'

module Gates
  # Output for the user: a line for each gate that has ended, the running gates, and at the end why a gate is red.
  class Progress
    # Between two lines of progress where no line can be written anew.
    QUIET_SECONDS = 30
    LOG_LINES = 40
    COMPLAINTS = 10

    def initialize(out, count)
      @out = out
      @count = count
      @ended = 0
      @began = @reported = Gates.now
    end

    def gate_ended(verdict)
      @ended += 1
      word = verdict.passed? ? 'ok' : 'FAILED'
      say format('[%<ended>d/%<count>d] %<says>s ... %<word>s (%<passed>d passed, %<failed>d failed, %<seconds>d s)',
                 ended: @ended, count: @count, says: verdict.gate.says, word: word,
                 **verdict.to_h.slice(:passed, :failed, :seconds))
      show_log(verdict.gate) unless verdict.passed?
    end

    def gate_left_out(gate, because_of)
      @ended += 1
      say "[#{@ended}/#{@count}] #{gate.says} ... NOT RUN (#{because_of.join(', ')} failed)"
    end

    # Running gates, their progress, and the remaining time of all.
    #
    # @satisfies SWR-GATE-003
    def progress(jobs, seconds_left)
      return unless @out.tty? || Gates.now - @reported >= QUIET_SECONDS

      @reported = Gates.now
      left = seconds_left < 1 ? 'longer than expected' : "about #{clock(seconds_left)} left"
      text = "#{clock(@reported - @began)} gone, #{left}: #{jobs.map { |job| running(job) }.join(', ')}"
      @out.tty? ? @out.print("\r\e[K", text[0, width - 1]) : @out.puts(text)
      @out.flush
    end

    # The last words: why each red gate is red, the first of them last, how to repeat it, and the count.
    #
    # @satisfies SWR-GATE-004
    def finish(verdicts)
      left_out, red = verdicts.reject(&:passed?).partition { |verdict| verdict.complaints.empty? }
      say "\nnot run: #{left_out.map { |verdict| verdict.gate.name }.join(', ')}" if left_out.any?
      red.reverse_each { |verdict| explain(verdict) }
      say "#{verdicts.sum(&:passed)} passed, #{verdicts.sum(&:failed)} failed"
    end

    def interrupted(jobs)
      say "interrupted; ended: #{jobs.map { |job| job.gate.name }.join(', ')}"
    end

    private

    def say(*lines)
      @out.print("\r\e[K") if @out.tty?
      @out.puts(lines)
      @out.flush
    end

    def show_log(gate)
      return unless File.exist?(gate.log)

      say "--- the end of #{gate.log}:", File.readlines(gate.log, chomp: true).last(LOG_LINES), '---'
    end

    def explain(verdict)
      more = verdict.complaints.size - COMPLAINTS
      say('', *verdict.complaints.first(COMPLAINTS).map { |complaint| "#{verdict.gate.name}: #{complaint}" })
      say "#{verdict.gate.name}: and #{more} more; see #{verdict.gate.log}" if more.positive?
      say "    repeat: make gate NAME=#{verdict.gate.name}"
    end

    def running(job)
      [job.gate.name, job.progress&.join('/'), "(#{clock(job.seconds)})"].compact.join(' ')
    end

    def clock(seconds)
      minutes, seconds = seconds.round.divmod(60)
      format('%<minutes>d:%<seconds>02d', minutes: minutes, seconds: seconds)
    end

    def width
      columns = @out.winsize.last
      columns.positive? ? columns : 80
    end
  end
end
