# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'limit'

module Robot
  # A pose with a name: where each axis stands, in ticks.
  #
  # @satisfies SWR-ROBOT-023
  class Pose
    NAMES = %w[home].freeze # pose_name_t of core/robot/robot.h

    attr_reader :ticks

    def initialize(node, axes)
      nodes = node.mapping(axes.map { |axis| axis['name'] })
      @ticks = axes.map { |axis| read(axis, nodes[axis['name']]) }
    end

    private

    def read(axis, node)
      value, unit = node.quantity(['ticks', axis.linear? ? 'mm' : 'rad'])
      ticks = unit == 'ticks' ? value.to_i : (value * axis['ticks_per_unit']).round
      low, high = axis.targets.values_at('target_minimum_ticks', 'target_maximum_ticks')
      high = [high, axis['home_ticks'] + needle_out_ticks(axis)].min if axis.needle?
      node.refuse("is #{ticks} ticks; expected #{low} to #{high}") unless ticks.between?(low, high)
      ticks
    end

    # As needle_out_ticks() of core/safety/needle.h.
    def needle_out_ticks(axis)
      (Limit.of('needle_out_nm') * axis['ticks_per_unit'] / 1_000_000).floor
    end
  end
end
