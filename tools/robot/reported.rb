# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

module Robot
  # Data of a robot for planning clients: its joints in their order, and lengths by names.
  #
  # @satisfies SWR-IGTL-038
  # @satisfies SWR-IGTL-039
  class Reported
    MOST_LENGTHS = 4 # ROBOT_REPORTED_LENGTHS of core/robot/robot.h
    LONGEST_NAME = 20 # Letters of a device's name in OpenIGTLink.

    Length = Struct.new(:millimetres, :probe) # probe: 1 + its place there, or 0

    # Places of the axes in the order of lists; lengths by name.
    attr_reader :joints, :lengths

    # `node`: nil without. `axes`: their names in the robot's order. `geometry`: its lengths by name; `probe`: Probe.
    def initialize(node, axes, geometry, probe)
      nodes = node ? node.mapping([], %w[joints lengths]) : {}
      @joints = nodes.key?('joints') ? read_joints(nodes['joints'], axes) : axes.each_index.to_a
      @lengths = nodes.key?('lengths') ? read_lengths(nodes['lengths'], geometry, probe.values) : {}
    end

    private

    def read_joints(node, axes)
      names = node.sequence.map { |joint| joint.choice(axes) }
      node.refuse("are #{names.join(', ')}; expected each of #{axes.join(', ')} once") unless names.sort == axes.sort
      names.map { |name| axes.index(name) }
    end

    def read_lengths(node, geometry, probe)
      entries = node.sequence.map { |entry| entry.mapping(%w[name length]) }
      node.refuse("are #{entries.size}; expected at most #{MOST_LENGTHS}") if entries.size > MOST_LENGTHS
      entries.each_with_object({}) do |entry, lengths|
        name = entry['name'].name(LONGEST_NAME)
        entry['name'].refuse("is #{name}, which another has; expected another") if lengths.key?(name)
        length = entry['length'].choice(geometry.keys + probe.keys)
        lengths[name] = Length.new(geometry.merge(probe).fetch(length), (probe.keys.index(length) || -1) + 1)
      end
    end
  end
end
