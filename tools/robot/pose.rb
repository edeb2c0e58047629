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

    def initialize(node, axes, coupled_limits)
      @axes = axes
      @nodes = node.mapping(axes.map { |axis| axis['name'] })
      @ticks = axes.map { |axis| read(axis, @nodes[axis['name']]) }
      coupled_limits.each { |limit| check_coupled(node, limit) }
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

    # A little inside, as any target.
    def check_coupled(node, limit)
      margin = Rational(Limit.of('coupled_margin_nm'), 1_000_000)
      low, high = limit.range_mm
      first, second = [limit.first, limit.second].map { |index| @axes[index].units(@ticks[index]) }
      return if (first - second).between?(low + margin, high - margin)

      node.refuse("misses the coupled limit #{limit.name}; expected #{(low + margin).to_f} to " \
                  "#{(high - margin).to_f} mm from #{@axes[limit.second]['name']} to #{@axes[limit.first]['name']}")
    end
  end
end
