# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

module Robot
  # Which axis follows which while that homes.
  #
  # @satisfies SWR-ROBOT-022
  class Followers
    STAGES = (1..4) # ROBOT_HOME_STAGES of core/robot/robot.h

    # The leaders that the file gives for one axis: nodes by stage.
    def self.read(node)
      node ? node.mapping([], STAGES.map(&:to_s)).transform_keys(&:to_i) : {}
    end

    def initialize(axes)
      @axes = axes
      axes.each { |axis| axis['follows'].each { |stage, node| check(axis, stage, node) } }
    end

    # As axis_config_t has them.
    def leaders(axis)
      STAGES.map { |stage| axis['follows'].key?(stage) ? @axes.index(leader(axis['follows'][stage])) + 1 : 0 }
    end

    private

    def leader(node)
      @axes.find { |axis| axis['name'] == node.name } ||
        node.refuse("is #{node.name}; expected an axis of this robot")
    end

    # A leader of a stage homes in it, and a follower does not: so there are no chains and no circles.
    def check(axis, stage, node)
      leader = leader(node)
      node.refuse("follows in stage #{stage}, in which #{axis['name']} homes itself; expected another stage") \
        if axis['home_stage'] == stage
      node.refuse("is #{leader['name']}; expected an axis that homes in stage #{stage} by its switch") \
        unless leader['home_stage'] == stage && leader['home'] == 'switch'
      check_motion(axis, leader, node)
    end

    # The needle neither carries nor is carried.
    def check_motion(axis, leader, node)
      node.refuse("ties #{axis['name']} to #{leader['name']}; expected two axes across the needle") \
        unless [axis, leader].all? { |one| one['needle'] == 'across' }
      node.refuse("is #{leader['name']}, whose ticks are others; expected the unit and ticks of #{axis['name']}") \
        unless axis.linear? == leader.linear? && axis['ticks_per_unit'] == leader['ticks_per_unit']
      %w[home_speed_ticks_per_s acceleration_ticks_per_s2].each do |key|
        node.refuse("is #{leader['name']} with #{key} #{leader[key]}; expected at most the #{axis[key]} of " \
                    "#{axis['name']}") if leader[key] > axis[key]
      end
    end
  end
end
