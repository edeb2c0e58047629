#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Draws the lengths of each robot's probe to scale, from core/robot/*/robot.yml: ruby tools/documents/probe_picture.rb FILE.svg
#
# @satisfies SWR-TOOL-039

require 'psych'

# Lengths are in mm; along the needle a robot's reference is at 0, and its tip points to the right.
class ProbePicture
  ROOT = File.expand_path('../..', __dir__)
  WIDTH = 720
  MARGIN = 40
  LINE = 30

  # For each robot: the points along the needle while it is out, where each lies, and the lengths with both ends.
  ROBOTS = {
    'neuro' => {
      says: 'NeuroRobot: along the needle, which is out',
      points: {
        'robot' => ->(_) { 0 },
        'entry point' => ->(mm) { mm.fetch('robot_to_entry_mm') },
        'end of the cannula' => ->(mm) { mm.fetch('robot_to_treatment_mm') - mm.fetch('cannula_to_treatment_mm') },
        'treatment point' => ->(mm) { mm.fetch('robot_to_treatment_mm') },
        'tip' => ->(mm) { mm.fetch('robot_to_treatment_mm') + mm.fetch('treatment_to_tip_mm') }
      },
      lengths: {
        'treatment_to_tip_mm' => ['treatment point', 'tip'],
        'robot_to_entry_mm' => ['robot', 'entry point'],
        'cannula_to_treatment_mm' => ['end of the cannula', 'treatment point'],
        'robot_to_treatment_mm' => ['robot', 'treatment point']
      }
    },
    'prostate' => {
      says: 'ProstateRobot: along the needle, which is out',
      points: { 'front pivot' => ->(_) { 0 }, 'tip' => ->(mm) { mm.fetch('needle_tip_mm') } },
      lengths: { 'needle_tip_mm' => ['front pivot', 'tip'] },
      heights: { 'needle_height_mm' => 'height of the needle above the pivots' }
    }
  }.freeze

  def initialize(robots = ROBOTS.keys.to_h { |name| [name, read(name)] })
    @robots = robots
  end

  def svg
    @parts = []
    @top = LINE
    @robots.each { |name, mm| draw(ROBOTS.fetch(name), mm) }
    <<~SVG
      <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 #{WIDTH} #{@top}" font-family="sans-serif" font-size="13">
      <rect width="#{WIDTH}" height="#{@top}" fill="white"/>
      #{@parts.join("\n")}
      </svg>
    SVG
  end

  private

  def read(name)
    table = Psych.safe_load_file(File.join(ROOT, 'core', 'robot', name, 'robot.yml'))
    table.fetch('probe').transform_values { |length| length.fetch('value') }
  end

  def draw(robot, millimetres)
    places = robot[:points].transform_values { |place| place.call(millimetres) }
    @scale = (WIDTH - (2.0 * MARGIN)) / places.values.max
    text(MARGIN, @top, robot[:says], weight: 'bold')
    @top += LINE
    robot.fetch(:heights, {}).each do |name, says|
      text(MARGIN, @top - 9, "#{name}: #{millimetres.fetch(name)} (#{says})")
      @top += LINE
    end
    robot[:lengths].each { |name, ends| dimension(name, millimetres.fetch(name), places.values_at(*ends)) }
    needle(places)
  end

  def dimension(name, millimetres, ends)
    from, to = ends.map { |place| along(place) }
    line(from, to, 'stroke="#005a8c" stroke-width="2"')
    [from, to].each { |place| tick(place) }
    label(from, to, -9, "#{name}: #{millimetres}")
    @top += LINE
  end

  def needle(places)
    line(along(0), along(places.values.max), 'stroke="black" stroke-width="5"')
    places.each_value { |place| tick(along(place)) }
    places.each_with_index do |(name, place), row|
      label(along(place), along(place), 20 + (16 * row), name)
    end
    @top += LINE + (16 * places.size) + 14
  end

  def along(millimetres)
    (MARGIN + (millimetres * @scale)).round(1)
  end

  def line(from, to, style)
    @parts << %(<line x1="#{from}" y1="#{@top}" x2="#{to}" y2="#{@top}" #{style}/>)
  end

  def tick(place)
    @parts << %(<line x1="#{place}" y1="#{@top - 6}" x2="#{place}" y2="#{@top + 6}" stroke="black"/>)
  end

  # It begins at `from` in the left half of the picture, and ends at `to` in the right one.
  def label(from, to, below, words)
    is_left = from < WIDTH / 2
    text(is_left ? from : to, @top + below, words, anchor: is_left ? 'start' : 'end')
  end

  def text(place, bottom, words, weight: 'normal', anchor: 'start')
    @parts << %(<text x="#{place}" y="#{bottom}" font-weight="#{weight}" text-anchor="#{anchor}">#{words}</text>)
  end
end

if $PROGRAM_NAME == __FILE__
  abort "usage: #{$PROGRAM_NAME} FILE.svg" unless ARGV.size == 1
  File.write(ARGV.first, ProbePicture.new.svg)
end
