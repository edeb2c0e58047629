# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

module Points
  # The table of thesis 5.2: each error by axis, total and in the plane; their means, the bias and the spread; and what is
  # left once they are corrected.
  class Report
    AXES = %w[x y z].freeze

    PLANES = %w[xy xz yz].freeze

    # `plane`: one of PLANES.
    def initialize(points, plane)
      @points = points
      @plane = plane
      @across = plane.chars.map { |name| AXES.index(name) }
      @errors = points.map(&:error)
      @fit = Fit.new(points)
    end

    def to_s
      [head, *rows, '', *summary, '', *corrections, '', *matrix].map(&:rstrip).join("\n")
    end

    private

    def head
      vector = ->(name) { format('%-30s', "#{name} (#{AXES.join(', ')}), mm") }
      "#{format('%-4s', 'No')}#{%w[target measured error].map(&vector).join}#{columns('total', "in #{@plane}")}"
    end

    def rows
      @points.each.with_index(1).map do |point, number|
        vectors = [point.target, point.measured, point.error].map { |vector| triple(vector) }
        "#{format('%-4d', number)}#{vectors.join}#{columns(*sizes(point.error))}"
      end
    end

    # @satisfies SWR-POINTS-002
    def summary
      values = @errors.map { |error| [*error, *sizes(error)] }.transpose
      { 'mean, without signs' => values.map { |column| mean(column.map(&:abs)) },
        'bias: mean with signs' => values.first(3).map { |column| mean(column) },
        'standard error of the bias' => values.first(3).map { |column| deviation(column)&./(Math.sqrt(column.size)) },
        'standard deviation' => values.map { |column| deviation(column) },
        'worst' => values.map { |column| column.map(&:abs).max } }.map { |name, columns| summary_line(name, *columns) }
    end

    def summary_line(name, x, y, z, *sizes)
      format('%-64s', name) + triple([x, y, z]) + columns(*sizes)
    end

    def corrections
      shifted = @errors.map { |error| error - (@errors.sum(Vector.zero(3)) / @errors.size) }
      lines = [left('with the bias taken out', shifted)]
      return lines << no_turn unless @fit.turns?

      lines << left("with the best rigid correction (it turns by #{format('%.3f', @fit.angle_deg)} deg)", @fit.residuals)
    end

    def left(name, errors)
      means = errors.map { |error| sizes(error) }.transpose.map { |column| mean(column) }
      format('%-94s', "mean error #{name}") + columns(*means)
    end

    def no_turn
      "No turn is fitted: that takes three targets, #{Fit::FROM_LINE} times as far from a line as they are measured wrong by."
    end

    def matrix
      ['This takes the targets to where they were measured. Points of the scanner: new registration = this x registration;',
       'of the base: new registration = registration x this.',
       *@fit.rotation.to_a.zip(@fit.translation).map { |turn, shift| format('%10.6f %10.6f %10.6f %10.3f', *turn, shift) },
       format('%10d %10d %10d %10d', 0, 0, 0, 1)]
    end

    # Total and in the plane.
    def sizes(error)
      [error.norm, Math.hypot(*@across.map { |axis| error[axis] })]
    end

    def triple(values)
      format('%-30s', columns(*values))
    end

    def columns(*values)
      values.map { |value| value.is_a?(Numeric) ? number(value) : format('%8s', value || '-') }.join(' ')
    end

    # Without a sign before zero.
    def number(value)
      format('%8.3f', value.round(3) + 0.0)
    end

    def mean(values)
      values.sum / values.size
    end

    # Deviation of a sample; a single point has none.
    def deviation(values)
      return if values.size < 2

      middle = mean(values)
      Math.sqrt(values.sum { |value| (value - middle)**2 } / (values.size - 1))
    end
  end
end
