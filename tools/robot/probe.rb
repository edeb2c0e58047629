# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'document'

module Robot
  # The lengths of the probe or needle: those to start with, and from where to where each may be changed.
  #
  # @satisfies SWR-PROBE-001
  class Probe
    MOST_LENGTHS = 4 # ROBOT_PROBE_LENGTHS of core/robot/robot.h

    # In mm, by name in the order of the kinematics.
    attr_reader :values, :minimum, :maximum

    def initialize(node, kinematics)
      ranges = kinematics.lengths('probe')
      node.refuse("has #{ranges.size} lengths; expected at most #{MOST_LENGTHS}") if ranges.size > MOST_LENGTHS
      @node = node
      @within = kinematics.probe_within
      @values, @minimum, @maximum = {}, {}, {}
      lengths = node.mapping(ranges.keys)
      ranges.each { |name, range| read(name, lengths[name], range) }
      check_within
    end

    # As people and C call them.
    def names
      @values.keys.map { |name| name.delete_suffix('_mm') }
    end

    # For each length 1 + the place of the one that it may not exceed, or 0.
    def within
      @values.keys.map { |name| @within.key?(name) ? @values.keys.index(@within[name]) + 1 : 0 }
    end

    private

    def read(name, node, range)
      nodes = node.mapping(%w[value minimum maximum])
      @values[name], @minimum[name], @maximum[name] = %w[value minimum maximum].map { |key| nodes[key].decimal(range) }
      return if @values[name].between?(@minimum[name], @maximum[name])

      value, least, most = [@values, @minimum, @maximum].map { |lengths| lengths[name].to_f.to_s.delete_suffix('.0') }
      nodes['value'].refuse("is #{value}; expected #{least} to #{most}")
    end

    def check_within
      @within.each do |name, other|
        next if @values[name] <= @values[other]

        @node.refuse("has a longer #{name} than #{other}; expected at most the same")
      end
    end
  end
end
