# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The few matrices that the demonstration needs: 3x3 rotations as rows, points and translations in mm.
module Geometry
  IDENTITY = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].freeze

  module_function

  # `rotation` turned about its own axes, one after the other: {x: radians, y: ...}, or nil.
  def turned(rotation, turns)
    (turns || {}).reduce(rotation) { |frame, (axis, angle)| multiply(frame, about(axis, angle)) }
  end

  def about(axis, angle)
    c = Math.cos(angle)
    s = Math.sin(angle)
    { x: [[1, 0, 0], [0, c, -s], [0, s, c]],
      y: [[c, 0, s], [0, 1, 0], [-s, 0, c]],
      z: [[c, -s, 0], [s, c, 0], [0, 0, 1]] }.fetch(axis)
  end

  def multiply(left, right)
    left.map { |row| right.transpose.map { |column| row.zip(column).sum { |a, b| a * b } } }
  end

  # 12 numbers, row by row, as a client sends them.
  def rows(rotation, translation)
    rotation.zip(translation).flat_map { |row, offset| [*row, offset] }
  end

  def distance(one, other)
    Math.sqrt(one.zip(other).sum { |a, b| (a - b)**2 })
  end
end
