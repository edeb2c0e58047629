# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'json'
require 'open3'
require_relative '../system/support/boresight'

# Fifteen clients (clients.c) that ask a running system as fast as they are answered, while it moves.
class Load
  PROGRAM = File.expand_path('../../build/gcc/bin/bench-clients', __dir__)

  # Report of the clients on `seconds` in which the workphase `phase` moves under the pedal; what has been prepared by others is
  # there, and no client commands. `was_moving`: STOP has ended the move, not its target.
  def self.measure(robot, phase, seconds)
    Open3.popen2(PROGRAM, robot.brp_port.to_s, robot.igtl_port.to_s, phase, seconds.to_s) do |input, output, thread|
      raise Failed, 'the clients could not begin' unless output.gets == "armed\n"

      robot.simctl('pedal', 'press')
      robot.wait_until('an axis is driven') { robot.moving? }
      input.puts('go')
      said = output.read
      raise Failed, 'a client was not served, see above' unless thread.value.success?

      JSON.parse(said).merge('was_moving' => robot.log.any? { |event| event['name'] == 'ORDER_DISCARDED' })
    end
  end

  # A sentence for people.
  class Failed < StandardError; end
end
