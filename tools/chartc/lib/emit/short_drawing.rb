# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

module Chart
  # A drawing in fewer letters, for a page that holds all of them: places to a tenth of a point, a path by the ways from
  # one point to the next, so that what looks alike is written alike, and no font, which the page has.
  module ShortDrawing
    NUMBER = /-?\d+(?:\.\d+)?/.freeze
    CURVES = /(?<= d=")(M#{NUMBER},#{NUMBER}C(?:#{NUMBER}[, ]?)+)(?=")/.freeze
    PLACES = /(?<= (?:x|y)="| (?:cx|cy|rx|ry)="| points=")([^"]+)(?=")/.freeze
    FONT = / text-anchor="start"| font-family="[^"]*"| font-size="[^"]*"/.freeze

    class << self
      def of(svg)
        svg.gsub(FONT, '').gsub(PLACES) { |places| places.gsub(NUMBER) { |number| text(tenths(number)) } }
           .gsub(CURVES) { |path| path_of(path) }
      end

      private

      def path_of(path)
        here, *points = path.scan(NUMBER).map { |number| tenths(number) }.each_slice(2).to_a
        points.each_slice(3).inject("M#{pair(here)}") do |short, bends|
          ways = bends.map { |point| [point[0] - here[0], point[1] - here[1]] }
          here = bends.last
          short + leg(ways)
        end
      end

      def leg(ways)
        first, second, whole = ways
        return "c#{ways.map { |way| pair(way) }.join(' ')}" unless first == [0, 0] && second == whole

        across, down = whole
        return down.zero? ? '' : "v#{text(down)}" if across.zero?

        down.zero? ? "h#{text(across)}" : "l#{pair(whole)}"
      end

      def pair(point)
        point.map { |one| text(one) }.join(',')
      end

      def tenths(number)
        (Rational(number) * 10).round
      end

      def text(tenths)
        (tenths % 10).zero? ? (tenths / 10).to_s : (tenths / 10.0).to_s
      end
    end
  end
end
