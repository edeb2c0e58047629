# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Control loops of others on this machine: each has the same core and priority as the one that is measured. Systems that
# this program started are not among them, also while they end.
class Neighbours
  REMARK = 'Another Boresight ran on this machine meanwhile; measure again without it.'
  CONTROL = 'boresight-contr' # So much of a name the kernel keeps.

  # `ours`: what the instances of this program begin with.
  def initialize(ours: "test-#{Process.pid}-", proc: '/proc')
    @ours = ours
    @proc = proc
  end

  # @satisfies SWR-TOOL-022
  def any?
    Dir.glob(File.join(@proc, '[0-9]*')).any? { |folder| other_control?(folder) }
  end

  private

  # A process that has ended has no command line any more.
  def other_control?(folder)
    return false unless File.read(File.join(folder, 'comm')).chomp == CONTROL

    words = File.binread(File.join(folder, 'cmdline')).split("\0")
    words.any? && !instance(words).start_with?(@ours)
  rescue SystemCallError
    false
  end

  def instance(words)
    words.each_cons(2).find { |option, _| option == '--instance' }.to_a.last.to_s
  end
end
