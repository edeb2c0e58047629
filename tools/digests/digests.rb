# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Compares two builds by random scenes: a text file has a line for each scene, which ends in a digest of all frames, answers and events of
# its cycles.
#
#   ruby tools/digests/digests.rb FILE [SCENES]          plays the scenes by build/gcc/bin/digests; a FILE that was begun
#                                                                is continued
#   ruby tools/digests/digests.rb --compare BEFORE AFTER  names the scenes whose digests differ
#
# Ends with 1 when scenes differ or are in one file only.

require 'open3'

# The scenes and their digests.
#
# @satisfies SWR-TOOL-482
module Digests
  PROGRAM = File.expand_path('../../build/gcc/bin/digests', __dir__)
  SCENES = 10_000
  CYCLES = 4000
  CHUNK = 50
  # Share of each robot.
  ROBOTS = { 'neuro' => 0.6, 'bench2' => 0.2, 'prostate' => 0.2 }.freeze
  PLAYS = %w[random rivals modes jogs programs late].freeze

  module_function

  # [robot, play, first, count] of each chunk, together as many scenes as asked for or a few more.
  def plan(scenes)
    ROBOTS.flat_map do |robot, share|
      each = (scenes * share / PLAYS.size).ceil
      PLAYS.flat_map do |play|
        (0...each).step(CHUNK).map { |first| [robot, play, first + 1, [CHUNK, each - first].min] }
      end
    end
  end

  # Adds the lines of all `chunks` that `file` does not have.
  def play(file, chunks)
    played = File.exist?(file) ? read(file) : {}
    chunks.each do |robot, play, first, count|
      next if played.key?("#{robot} #{play} #{first + count - 1} #{CYCLES}")

      lines, status = Open3.capture2(PROGRAM, robot, play, first.to_s, count.to_s, CYCLES.to_s)
      raise "#{PROGRAM} #{robot} #{play} #{first} ends with #{status.exitstatus}" unless status.success?

      File.write(file, lines, mode: 'a')
    end
  end

  # Scene => digest.
  def read(file)
    File.readlines(file, chomp: true).to_h { |line| line.rpartition(' ').values_at(0, 2) }
  end

  # A sentence for each scene that differs.
  def differences(before, after)
    (before.keys | after.keys).filter_map do |scene|
      if !after.key?(scene) || !before.key?(scene)
        "#{scene} is in one file only"
      elsif before[scene] != after[scene]
        "#{scene} differs"
      end
    end
  end

  def run(arguments)
    if arguments.first == '--compare'
      before, after = arguments.drop(1).map { |file| read(file) }
      found = differences(before, after)
      puts found, "#{after.size} scenes, #{found.size} differ"
      return found.empty? ? 0 : 1
    end
    play(arguments.fetch(0), plan(Integer(arguments[1] || SCENES)))
    0
  end
end

exit Digests.run(ARGV) if $PROGRAM_NAME == __FILE__
