# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'etc'

# Share of the world's time that the machine took, and not the programs: a program could have run and something else ran on
# its core (/proc/PID/schedstat), or the hypervisor ran another machine (/proc/stat). A time is judged by the test only
# after these pauses of the same seconds were taken off. An act passes from program to program, so their waits add up,
# of the threads of one only the longest; on a machine that is left to them there is next to none.
#
#   pauses = Pauses.new(boresight.pids.values)
#   net = pauses.net_seconds { boresight.post_stop }
class Pauses
  TICKS_PER_S = 100.0
  NS_PER_S = 1e9
  STEAL = 8 # Word of the line "cpu" in /proc/stat.

  def initialize(pids)
    @pids = [Process.pid, *pids]
    @delays = {}
    @first = {}
    look
    @first = @delays.dup
    @begun = seconds_since_boot
  end

  # Takes note of the delays; a process that ends takes its own away.
  def look
    @pids.each do |pid|
      Dir.glob("/proc/#{pid}/task/*/schedstat").each do |path|
        @delays[path] = File.read(path).split[1].to_i / NS_PER_S
      rescue SystemCallError
        next
      end
    end
  end

  # Since this was made.
  def seconds
    look
    seconds_since_boot - @begun
  end

  # How long the block took, less the pauses meanwhile.
  def net_seconds
    paused = seconds
    began = Boresight.now
    yield
    [Boresight.now - began - (seconds - paused), 0].max
  end

  private

  def seconds_since_boot
    waits = @delays.group_by { |path, _| path[%r{\A/proc/\d+}] }.values
    steal = File.read('/proc/stat')[/^cpu .*/].split[STEAL].to_i / TICKS_PER_S
    waits.sum { |threads| threads.map { |path, delay| delay - @first.fetch(path, 0) }.max } + (steal / Etc.nprocessors)
  end
end
