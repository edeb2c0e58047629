# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'crc'
require_relative 'description'
require_relative 'formula'
require_relative 'kinematics'

module Robot
  # How a robot is drawn, for the console: what its kinematics.yml says under `drawing`, with the numbers of its robot.yml.
  # Formulas may name lengths, axes that go straight, NAME_minimum and NAME_maximum of these, and each value of `where`
  # that stands before. A length of the probe and an axis are asked for when it is drawn.
  #
  # @satisfies SWR-CON-029
  class Drawing
    # drawing: in place of that of the robot's kinematics.
    def initialize(path, text, drawing = nil)
      @robot = Description.new(path, text)
      @crc = Crc.of(text)
      @kinematics = Kinematics.new(@robot.kinematics)
      @drawing = drawing || @kinematics.drawing
      check
    end

    def script
      <<~SCRIPT
        #{@robot.name}: {
          checksum: "#{format('%08x', @crc)}",
          shape: (at) => {
        #{where.keys.map { |name| "    const #{name} = #{formula(where[name])};" }.join("\n")}
            return {
              parts: [
        #{parts.map { |name, points| part(name, points) }.join("\n")}
              ],
              rear: #{formula(needle('rear'))},
              tip: #{formula(needle('tip'))},
            };
          },
        },
      SCRIPT
    end

    private

    def where
      @drawing.fetch('where', {})
    end

    def parts
      @drawing.fetch('parts', {})
    end

    def needle(end_of_it)
      @drawing.fetch('needle', {}).fetch(end_of_it, 0)
    end

    def part(name, points)
      places = points.map { |point| "            [#{point.map { |value| formula(value) }.join(', ')}]," }
      "        {\n          name: \"#{name}\",\n          points: [\n#{places.join("\n")}\n          ],\n        },"
    end

    def formula(text)
      Formula.new(text.to_s).script { |name| word(name) }
    end

    def word(name)
      return name if where.key?(name)

      constants.key?(name) ? "(#{constants[name].to_f})" : "at(\"#{name}\")"
    end

    def constants
      @constants ||= straight.each_with_object(@robot.geometry.dup) do |axis, values|
        %w[minimum maximum].each { |limit| values["#{axis['name']}_#{limit}"] = axis.units(axis["#{limit}_ticks"]) }
      end
    end

    def straight
      @robot.axes.select(&:linear?)
    end

    # At a pose of its file, or at home, each formula has a value.
    def check
      ticks = @robot.poses.values.first || @robot.axes.map { |axis| axis['home_ticks'] }
      values = constants.merge(@robot.probe.values)
      @robot.axes.zip(ticks).each { |axis, place| values[axis['name']] = axis.units(place) if axis.linear? }
      where.each { |name, text| values[name] = value("where.#{name}", text, values) }
      parts.each { |name, points| points.flatten.each { |text| value("parts.#{name}", text, values) } }
      %w[rear tip].each { |name| value("needle.#{name}", needle(name), values) }
    end

    def value(field, text, values)
      Formula.new(text.to_s).value(values)
    rescue ArgumentError => e
      @kinematics.refuse("drawing.#{field}", e.message)
    end
  end
end
