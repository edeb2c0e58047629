# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'fiddle'

module Gates
  # The processes below this one, also those that left their group or lost their parent.
  #
  # @satisfies SWR-GATE-006
  module Processes
    PR_SET_CHILD_SUBREAPER = 36
    GRACE_SECONDS = 5
    POLL_SECONDS = 0.05

    class << self
      # From now on this process is the parent of all below it that lose theirs.
      def adopt_orphans
        prctl = Fiddle::Function.new(Fiddle.dlopen(nil)['prctl'], [Fiddle::TYPE_INT] + ([Fiddle::TYPE_LONG] * 4),
                                     Fiddle::TYPE_INT)
        prctl.call(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
      end

      # Ends `pid` and all below it, first politely, then by force; never this process itself.
      def end_tree(pid)
        found = tree(pid)
        send('TERM', found)
        deadline = Gates.now + GRACE_SECONDS
        until (found = (found | tree(pid)) & parents.keys).empty?
          send('KILL', found) if Gates.now > deadline
          sleep POLL_SECONDS
        end
      end

      private

      def tree(pid)
        children = parents.group_by(&:last).transform_values { |pairs| pairs.map(&:first) }
        found = [pid]
        found.each { |parent| found.concat(children.fetch(parent, [])) }
        found - [Process.pid]
      end

      # The parent of every living process.
      def parents
        Dir.glob('/proc/[0-9]*/stat').filter_map do |path|
          state, parent = File.read(path)[/.*\) (.*)/m, 1].split.first(2)
          [path[/\d+/].to_i, parent.to_i] unless state == 'Z'
        rescue SystemCallError
          nil
        end.to_h
      end

      def send(signal, pids)
        pids.each do |pid|
          Process.kill(signal, pid)
        rescue Errno::ESRCH
          next
        end
      end
    end
  end
end
