#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Follows the controller with Frama-C's Eva and compares its alarms with verification/eva/alarms.yml.
#
#   ruby tools/eva/run.rb ROBOT...           exit 1 on an alarm that is not listed, or is listed and gone
#   ruby tools/eva/run.rb --write ROBOT...   writes the list anew; reasons of alarms that are still there stay
#
# For the robot of verification/proof/proved.yml the proofs of each function are compared with that, or added to it.
#
# The report of each robot is kept in build/eva.

require_relative 'alarm_list'
require_relative 'analysis'
require_relative 'reasons'
require_relative '../proof/coverage'
require_relative '../proof/proved_list'

if $PROGRAM_NAME == __FILE__
  write = ARGV.delete('--write')
  abort 'usage: run.rb [--write] ROBOT...' if ARGV.empty?
  robots = Dir.glob('core/robot/*/robot.yml').map { |file| File.basename(File.dirname(file)) }.sort
  unknown = ARGV - robots
  abort "eva: there is no robot #{unknown.join(', ')}; there are: #{robots.join(', ')}" if unknown.any?
  list = Eva::AlarmList.read(Eva::AlarmList::FILE)
  proved = Proof::ProvedList.read
  problems = ARGV.flat_map do |robot|
    analysis = Eva::Analysis.of_controller(robot).run
    puts "eva: #{robot}: #{analysis.figures}"
    list.replace(robot, analysis.alarms) if write
    found = list.problems(robot, analysis.alarms) + Eva::Reasons.new.problems(list.reasons(robot))
    next found unless robot == Proof::ProvedList::ROBOT

    states = Proof::Coverage.new(reached: analysis.functions, with_open: list.open_functions(robot)).states
    proved.replace(states) if write
    found + proved.problems(states)
  end
  [list, proved].each(&:save) if write
  puts problems, "eva: #{problems.size} problems"
  exit(problems.empty? ? 0 : 1)
end
