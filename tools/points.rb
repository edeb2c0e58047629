#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# How far a robot missed its targets, from points that something else has measured (motion capture, images).
#
#   ruby tools/points.rb FILE.csv [PLANE]      PLANE is xy unless said: the plane across the needle
#   make points FILE=... PLANE=xz
#
# FILE has the head `target_x,target_y,target_z,measured_x,measured_y,measured_z` and a line for each point, mm, all in the
# frame of the scanner or all in that of the robot's base. An error is measured minus target.

require 'matrix'
require_relative 'points/list'
require_relative 'points/fit'
require_relative 'points/report'

if $PROGRAM_NAME == __FILE__
  file, plane, *more = ARGV
  plane ||= 'xy'
  abort 'usage: points.rb FILE.csv [xy|xz|yz]' if file.to_s.empty? || more.any? || !Points::Report::PLANES.include?(plane)
  begin
    puts Points::Report.new(Points::List.read(file), plane).to_s
  rescue Points::Refused => e
    abort "points: #{e.message}"
  end
end
