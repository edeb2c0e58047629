# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'crc'

module Robot
  # The kind of a robot in C: its name and its number, which no other robot changes.
  module Kind
    def self.name(kinematics)
      "ROBOT_KIND_#{kinematics.upcase}"
    end

    def self.number(kinematics)
      Crc.of(kinematics)
    end
  end
end
