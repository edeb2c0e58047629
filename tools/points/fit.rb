# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

module Points
  # The rigid motion that takes the targets nearest to where they were measured, by least squares: by Horn's quaternions
  # (J. Opt. Soc. Am. A 4, 629, 1987), which give the rotation of Kabsch and Umeyama and never a reflection.
  #
  # It does not turn where a turn would only fit the noise: with fewer than three points, or where the targets lie near a
  # line for what they are measured wrong by.
  #
  # @satisfies SWR-POINTS-003
  class Fit
    # How many times as far from their best line as they are measured wrong by the targets have to lie.
    FROM_LINE = 3

    attr_reader :rotation, :translation

    def initialize(points)
      @points = points
      @target, @measured = %i[target measured].map { |which| mean(points.map(&which)) }
      turn(best_rotation)
      @turns = known?
      turn(Matrix.identity(3)) unless @turns
    end

    def turns?
      @turns
    end

    def angle_deg
      half = skew(@rotation).norm / 2
      Math.atan2(half, (@rotation.trace - 1) / 2) * 180 / Math::PI
    end

    # Remainder of each error.
    def residuals
      @points.map { |point| point.measured - ((@rotation * point.target) + @translation) }
    end

    private

    def mean(vectors)
      vectors.sum(Vector.zero(3)) / vectors.size
    end

    def pairs
      @points.map { |point| [point.target - @target, point.measured - @measured] }
    end

    def turn(rotation)
      @rotation = rotation
      @translation = @measured - (rotation * @target)
    end

    # @satisfies SWR-POINTS-004
    def known?
      @points.size >= 3 && distance_from_line > [FROM_LINE * noise, 1e-6].max
    end

    # Root mean square of what a point is measured wrong by; the fit has taken up six of the coordinates.
    def noise
      Math.sqrt(residuals.sum { |rest| rest.norm**2 } / (@points.size - 2))
    end

    # Root mean square of how far the targets lie from their best line.
    def distance_from_line
      across = products { |target, _| [target, target] }.eigen.eigenvalues.min(2).sum
      Math.sqrt([across, 0].max / @points.size)
    end

    def products
      pairs.sum(Matrix.zero(3)) do |pair|
        left, right = yield pair
        Matrix.column_vector(left) * Matrix.row_vector(right)
      end
    end

    # The antisymmetric part, as a vector.
    def skew(matrix)
      Vector[matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1]]
    end

    def best_rotation
      sums = products(&:itself)
      turn = -skew(sums)
      rest = sums + sums.transpose - (Matrix.identity(3) * sums.trace)
      eigen = Matrix.rows([[sums.trace, *turn], *turn.to_a.zip(rest.to_a).map(&:flatten)]).eigen
      of_quaternion(*eigen.eigenvectors[eigen.eigenvalues.each_with_index.max.last].normalize)
    end

    def of_quaternion(real, *imaginary)
      axis = Vector[*imaginary]
      cross = Matrix[[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]]
      along = Matrix.column_vector(axis) * Matrix.row_vector(axis)
      (Matrix.identity(3) * ((real**2) - axis.dot(axis))) + (along * 2) + (cross * (2 * real))
    end
  end
end
