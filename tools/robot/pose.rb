# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'psych'
require_relative 'limit'

module Robot
  # A pose with a name: where each axis stands, in ticks. Only that where START_UP ends has a place for the needle.
  #
  # @satisfies SWR-ROBOT-023
  # @satisfies SWR-POSE-005
  class Pose
    INTERFACE = File.expand_path('../../core/interface/poses.yml', __dir__)
    NAMES = Psych.safe_load_file(INTERFACE).dig('enumerations', 0, 'values').map { |value| value['name'].downcase }.freeze
    HOME = 'home'

    # By axis; 0 for a needle that has no part.
    attr_reader :ticks

    def initialize(name, node, axes)
      @node = node
      @axes = axes
      taking = axes.select { |axis| name == HOME || !axis.needle? }
      nodes = node.mapping(taking.map { |axis| axis['name'] })
      @ticks = axes.map { |axis| nodes.key?(axis['name']) ? read(axis, nodes[axis['name']]) : 0 }
    end

    # `geometry`: lengths in mm by name. A motion may end so far inside a limit that axes share, no nearer.
    def check(coupled_limits, geometry)
      values = geometry.merge(@axes.zip(@ticks).to_h { |axis, ticks| [axis['name'], axis.units(ticks)] })
      coupled_limits.each do |limit|
        value = measure(limit, values)
        low, high = limit.minimum + limit.margin, limit.maximum - limit.margin
        next if value >= low && value <= high

        @node.refuse(format('has %<name>s at %<value>.3f; expected %<low>.3f to %<high>.3f',
                            name: limit.name, value: value, low: low, high: high))
      end
    end

    private

    def measure(limit, values)
      limit.formula.value(values)
    rescue ArgumentError
      @node.refuse("has no #{limit.name}; expected axes that can be there together")
    end

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
