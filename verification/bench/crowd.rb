# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'json'
require_relative '../demo/targets'
require_relative '../demo/workflow'
require_relative '../system/support/boresight'

# Clients that crowd the HTTP server of a running system (crowd.c).
module Crowd
  PROGRAM = File.expand_path('../../build/gcc/bin/bench-crowd', __dir__)
  KINDS = %i[consoles lazy comers halves guessers stoppers].freeze

  TURN_SECONDS = 1 # Age of a crowd before its stops are counted.

  # Returns what became of the stops once at least `count` of them were answered.
  def self.until_answered(port, count, **counts)
    total = Hash.new(0)
    while total['answered'] < count
      around(port, **counts) { sleep TURN_SECONDS }['stoppers'].each { |fate, number| total[fate] += number }
    end
    total
  end

  # Yields once all have come; returns what they saw until the block's end. `counts`: how many of each kind.
  def self.around(port, **counts)
    IO.popen([PROGRAM, port.to_s, *KINDS.map { |kind| counts.fetch(kind, 0).to_s }], 'r+') do |crowd|
      raise 'the crowd could not come' unless crowd.gets == "begun\n"

      yield
      crowd.close_write
      JSON.parse(crowd.read)
    end
  end
end

# Motion of the bench meanwhile: it homes, and moves from one target to the other under the pedal.
class TargetMove
  ROBOT = 'bench2'
  NM_PER_MM = 1_000_000

  # The farthest that an axis has truly been from its target at the end of a move.
  attr_reader :off_nm

  def initialize(robot)
    @robot = robot
    @workflow = Workflow.new(robot)
    targets = Targets.new(File.expand_path("../../core/robot//#{ROBOT}/targets.yml", __dir__))
    @registration = targets.registration
    @poses = targets.each_target.map { |target| Geometry.rows(target.rotation, target.point) }.cycle
    @off_nm = 0
  end

  def prepare
    @workflow.home
    @workflow.register(@registration)
  end

  def move
    @workflow.move(@poses.next)
    @off_nm = [@off_nm, present_off_nm].max
  end

  # Returns while it moves.
  def begin_move
    @workflow.begin_move(@poses.next)
    @robot.wait_until('an axis is driven') { @robot.moving? }
  end

  private

  # The box knows where its axes truly stand.
  def present_off_nm
    true_mm = @robot.box_axes.to_h { |words| [words[1], Float(words[2])] }
    @robot.motors['axes'].map { |axis| ((true_mm.fetch(axis['name']) - axis['target']).abs * NM_PER_MM).round }.max
  end
end
