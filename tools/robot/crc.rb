# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

module Robot
  # CRC-32C, as core/base/crc.c computes it.
  module Crc
    POLYNOMIAL = 0x82F63B78

    def self.of(bytes)
      crc = bytes.each_byte.inject(0xFFFFFFFF) { |sum, byte| divide(sum ^ byte) }
      crc ^ 0xFFFFFFFF
    end

    def self.divide(sum)
      8.times { sum = sum.odd? ? (sum >> 1) ^ POLYNOMIAL : sum >> 1 }
      sum
    end
  end
end
