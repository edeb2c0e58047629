# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: a stop is carried out in its time: of everything by the supervisor, of all motion by the console.

require 'socket'
require_relative '../support/pauses'
require_relative '../support/system_test'

class TestStop < SystemTest
  STOP_SECONDS = 2.0 # stop_time_us
  ANSWER_SECONDS = 1.0

  def setup
    boresight(arguments: ['--real-time'])
  end

  # Stops it and returns how long that took, less the machine's pauses.
  def stop(signal)
    pauses = Pauses.new([boresight.pid, *boresight.pids.values])
    pauses.net_seconds do
      Process.kill(signal, boresight.pid)
      wait_until('the supervisor ends') do
        pauses.look
        boresight.ended?
      end
    end
  end

  def test_SWR_SUP_001_everything_stops_within_its_time
    seconds = stop('INT')
    assert_operator seconds, :<, STOP_SECONDS
    puts format('SWR-SUP-001: stopped in %.3f s', seconds)
  end

  def test_SWR_SUP_001_a_stopped_program_does_not_delay_the_end
    boresight.kill('http', 'STOP')
    boresight.kill('recorder', 'STOP')
    assert_operator stop('TERM'), :<, STOP_SECONDS
  end

  def test_SWR_HTTP_004_sixty_half_requests_do_not_delay_a_stop
    slow = Array.new(60) do
      TCPSocket.new('127.0.0.1', boresight.http_port).tap { |socket| socket.write("POST /api/v1/stop HTTP/1.1\r\nHost: ") }
    end
    seconds = Pauses.new(boresight.pids.values).net_seconds { assert_equal '200', boresight.post_stop.code }
    assert_operator seconds, :<, ANSWER_SECONDS
  ensure
    slow&.each(&:close)
  end
end
