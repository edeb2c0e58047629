#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Two pages of the console and two connections of OpenIGTLink compete for authority over the bench, while a hand presses
# pedal and button and the processes between them are killed. An oracle (message_oracle.h) then replays the recording.
#
#   ruby verification/authority_stress/authority_stress.rb MINUTES [SEED]      exits 1 if a rule was broken; its recording is kept
#
# The order of the acts depends on the machine; a recording is judged again alike, wherever it is replayed.

require 'json'
require 'open3'
require_relative 'players'
require_relative '../bench/crowd'

# One run of clients that compete.
class AuthorityStress
  ORACLE = File.expand_path('../../build/gcc/bin/authority-stress-oracle', __dir__)
  LOSSES = 3
  Verdict = Struct.new(:counts, :broken, :is_good)

  # Returns the oracle's verdict on clients that compete for at least so many seconds. The recording of a broken rule is kept.
  def self.judge(seconds, seed, accounts)
    kept = File.expand_path("../../build/authority_stress/#{seed}", __dir__)
    FileUtils.rm_rf(kept)
    robot = Boresight.start(arguments: ['--robot', TargetMove::ROBOT, '--accounts', accounts], recordings: kept)
    verdict = record(robot, seconds, Random.new(seed))
    FileUtils.rm_rf(kept) if verdict.is_good
    verdict
  ensure
    robot&.kill_all
  end

  def self.record(robot, seconds, random)
    target_move = TargetMove.new(robot)
    target_move.prepare
    target_move.move
    robot.client.close
    new(robot, random).run(seconds)
    Process.kill('TERM', robot.pid)
    robot.wait_for_end
    text, status = Open3.capture2e(ORACLE, *robot.recording_files)
    raise text unless text.start_with?('{')

    Verdict.new(JSON.parse(text.lines.first), text.lines.drop(1).join, status.success?)
  end
  private_class_method :record

  def initialize(robot, random)
    @robot = robot
    @players = [Connection, Connection, Page, Page, Hand, Reaper].map do |kind|
      kind.new(robot, Random.new(random.rand(1 << 32)))
    end
  end

  def run(seconds)
    ends = Boresight.now + seconds
    threads = @players.map { |player| Thread.new { player.play } }
    @robot.wait_until('authority was lost often enough') { Boresight.now >= ends && competed? }
  ensure
    @players.each(&:leave)
    threads&.each(&:join)
  end

  private

  # It was taken again and again, refused, and lost in more than one way.
  def competed?
    lines = @robot.event_lines
    lost = lines.filter_map { |line| line[/ AUTHORITY_LOST .*: (\w+)\./, 1] }
    lost.size >= LOSSES && lost.uniq.size >= 2 && lines.any? { |line| line.include?(' AUTHORITY_REFUSED ') }
  end
end

# Returns whether all rules were kept.
def stress(minutes, seed)
  verdict = Dir.mktmpdir("authority_stress") { |folder| AuthorityStress.judge(minutes * 60, seed, Accounts.make(File.join(folder, 'accounts'))) }
  puts "Seed #{seed}: #{verdict.counts}", verdict.broken
  verdict.is_good
end

exit(stress(Float(ARGV.fetch(0)), Integer(ARGV.fetch(1, Random.new_seed % 1_000_000)))) if $PROGRAM_NAME == __FILE__
