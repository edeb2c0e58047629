# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'yaml'
require_relative 'geometry'

# The targets of a robot, core/robot/NAME/targets.yml, which says what the fields mean. Scanner coordinates, mm.
class Targets
  # Where the treatment frame shall be: rotation as rows, and point; the entry point or nil; the thesis' error or nil;
  # how it is reached: nil, 'halves', 'hand' or 'cooperation', and with what helpers.
  Target = Struct.new(:rotation, :point, :entry, :thesis, :by, :membranes, :steer)

  attr_reader :note, :close_up, :images, :poses

  def initialize(file)
    @file = YAML.safe_load_file(file, symbolize_names: true)
    @note = @file[:note]
    @close_up = @file[:close_up]
    @images = @file[:images]
    @poses = @file[:poses]
  end

  # 12 numbers: from the z-frame to the scanner.
  def registration
    Geometry.rows(base, @file[:registration][:translation])
  end

  def each_target
    @file[:targets].map { |target| placed(target) }
  end

  private

  def base
    Geometry.turned(Geometry::IDENTITY, @file[:registration][:turns])
  end

  def placed(target)
    rotation = Geometry.turned(Geometry.multiply(base, @file[:frame]), target[:turns])
    Target.new(rotation, target[:point], before(target, rotation), *target.values_at(:thesis, :by, :membranes, :steer))
  end

  # On the needle's line, which is the frame's z axis.
  def before(target, rotation)
    return unless target[:entry]

    target[:point].zip(rotation.map(&:last)).map { |value, direction| value - (target[:entry] * direction) }
  end
end
