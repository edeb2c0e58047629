# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The few matrices that the demonstration needs: 3x3 rotations as rows, points and translations in mm.
module Geometry
  # Axes of the remote centre of motion in the z-frame at home (docs/architecture.md): the needle points down.
  HOME = [[-1, 0, 0], [0, 0, -1], [0, -1, 0]].freeze

  module_function

  def about_x(angle)
    c = Math.cos(angle)
    s = Math.sin(angle)
    [[1, 0, 0], [0, c, -s], [0, s, c]]
  end

  def about_y(angle)
    c = Math.cos(angle)
    s = Math.sin(angle)
    [[c, 0, s], [0, 1, 0], [-s, 0, c]]
  end

  def about_z(angle)
    c = Math.cos(angle)
    s = Math.sin(angle)
    [[c, -s, 0], [s, c, 0], [0, 0, 1]]
  end

  def multiply(left, right)
    left.map { |row| right.transpose.map { |column| row.zip(column).sum { |a, b| a * b } } }
  end

  # Orientation of the treatment frame in the z-frame.
  def treatment(yaw, pitch, roll)
    [about_x(yaw), about_y(pitch), about_z(roll)].reduce(HOME) { |left, right| multiply(left, right) }
  end

  # 12 numbers, row by row, as a client sends them.
  def rows(rotation, translation)
    rotation.zip(translation).flat_map { |row, offset| [*row, offset] }
  end

  def distance(one, other)
    Math.sqrt(one.zip(other).sum { |a, b| (a - b)**2 })
  end
end
