# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'digest'
require 'minitest/autorun'
require_relative 'boresight'

Minitest.after_run { Boresight.running.dup.each(&:kill_all) }

# A test of real processes. `boresight` starts one when first asked for it; everything ends with the test.
class SystemTest < Minitest::Test
  def boresight(...)
    @boresight ||= Boresight.start(...)
  end

  def teardown
    warn "\n#{name}: Boresight said:\n#{@boresight.output}" if @boresight && !passed?
    Boresight.running.dup.each(&:kill_all)
  end

  # Each condition that was waited for is an assertion: it fails the test when it does not come true.
  def wait_until(reason, &)
    self.assertions += 1
    Boresight.wait_until(reason, &)
  end

  # Runs the replay; returns its output and its exit code.
  def replay(*words)
    text, status = Open3.capture2e(Boresight.program('boresight-replay'), *words)
    [text, status.exitstatus]
  end

  # The checksum of a recording's fields, written a second time on purpose.
  def crc32c(bytes)
    bytes.each_byte.reduce(0xFFFFFFFF) do |crc, byte|
      crc ^= byte
      8.times { crc = crc[0] == 1 ? (crc >> 1) ^ 0x82F63B78 : crc >> 1 }
      crc
    end ^ 0xFFFFFFFF
  end

  # A block of a recording, or its trailer, behind the hash `before` it: 28 bytes of fields, and what stands behind the hash.
  def sealed(before, fields, rest)
    fields += [crc32c(fields)].pack('V')
    fields + Digest::SHA256.digest(before + fields + rest) + rest
  end

  # A stopped instance leaves no process and no shared memory behind.
  def assert_nothing_left(instance)
    wait_until("nothing of #{instance} is left") do
      Dir.glob("/dev/shm/*#{instance}*").empty? && processes_of(instance).empty?
    end
  end

  def processes_of(instance)
    Dir.glob('/proc/[0-9]*/cmdline').select do |path|
      words = File.binread(path).split("\0")
      words.first.to_s.include?('boresight') && words.any? { |word| word.include?(instance) }
    rescue SystemCallError
      false
    end
  end
end
