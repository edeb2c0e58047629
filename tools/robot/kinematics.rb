# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'psych'
require_relative 'document'

module Robot
  # Assumptions of a kinematics about its robots: kinematics.yml in its folder.
  class Kinematics
    FOLDER = File.expand_path('../../core/robot', __dir__)

    # Names of all kinematics.
    def self.names(folder = FOLDER)
      Dir.glob('*/kinematics.yml', base: folder).map { |path| File.dirname(path) }.sort
    end

    def initialize(name, folder = FOLDER)
      path = File.join(folder, name, 'kinematics.yml')
      @path = path
      @parts = Psych.safe_load_file(path)
      needles = axes.count { |axis| needle(axis) == 'along' }
      refuse('axes', "are #{needles} along the needle; expected 1") unless needles == 1
      check_needle_units
    end

    # Their names, in order.
    def axes
      @parts.fetch('axes').keys
    end

    # mm or rad.
    def unit(axis)
      @parts.fetch('axes').fetch(axis).first
    end

    def needle(axis)
      @parts.fetch('axes').fetch(axis).last
    end

    # Ranges of the lengths of `part`, geometry or probe, in order.
    def lengths(part)
      @parts.fetch(part).transform_values { |least, most| (least..most) }
    end

    # For each length of the probe that may not exceed another one: that one.
    def probe_within
      @parts.fetch('probe_within', {})
    end

    # For each length that lies between others: the one below, and those whose sum is above.
    def between
      @parts.fetch('between')
    end

    # Quantity of each, by its name, in order.
    def coupled_limits
      @parts.fetch('coupled_limits')
    end

    # Bit n: axis n has part in the coupled limit `name`. The needle waits while the others go, so it has none.
    def mask(name)
      others = axes.reject { |axis| needle(axis) == 'along' }
      coupled_limits.fetch(name).fetch('axes').sum do |axis|
        refuse("coupled_limits.#{name}", "is of #{axis}; expected of #{others.join(', ')}") unless others.include?(axis)
        1 << axes.index(axis)
      end
    end

    # The code of the status that says that the coupled limit `name` is missed.
    def refusal(name)
      own = coupled_limits.fetch(name).fetch('refusal')
      found = @parts.fetch('refusals', []).find { |refusal| refusal['name'] == own }
      refuse("coupled_limits.#{name}", "has the refusal #{own}; expected one of refusals") unless found
      found.fetch('code')
    end

    # The direction of a needle whose target is a bare point; all 0 where a point wants an entry point.
    def bare_direction
      @parts.fetch('bare_direction', [0, 0, 0])
    end

    # How a robot is drawn; empty where nothing is said.
    def drawing
      @parts.fetch('drawing', {})
    end

    # Refusal of the value of `field`.
    def refuse(field, reason)
      raise Refused.new(@path, field, reason)
    end

    private

    # Depths are given in mm and angles in degrees, whatever the robot.
    #
    # @satisfies SWR-TOOL-029
    def check_needle_units
      { 'along' => 'mm', 'about' => 'rad' }.each do |motion, expected|
        odd = axes.find { |axis| needle(axis) == motion && unit(axis) != expected }
        refuse("axes.#{odd}", "goes #{motion} the needle in #{unit(odd)}; expected #{expected}") if odd
      end
    end
  end
end
