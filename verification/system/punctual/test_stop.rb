# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: a stop is carried out in its time: of everything by the supervisor, of all motion by the console.

require 'socket'
require_relative '../support/pauses'
require_relative '../support/system_test'
require_relative '../../bench/crowd'

class TestStop < SystemTest
  STOP_SECONDS = 2.0 # stop_time_us
  ANSWER_SECONDS = 1.0
  LEAVES_SECONDS = 1.0 # stop_leaves_us
  SLOW_CLIENTS = 600
  HALVES = 300 # crowd_halves
  CROWD_STOP_MS = 100
  FLOOD = 64 # crowd_flood
  FLOOD_STOPS = 300 # Three pauses of the machine lie above the 99th of 100.
  MEDIAN = FLOOD_STOPS / 2
  P99 = (FLOOD_STOPS * 99 / 100) - 1
  CONSOLE_TIMES = 3 # console_stop_percent

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

  # The slow clients come first and hold their places; then the stop is asked for at the port that is there for it.
  # Returns how long it took, and that less the machine's pauses.
  def stop_seconds_among(count, port)
    stop_port = boresight.stop_port
    slow = Array.new(count) do
      TCPSocket.new('127.0.0.1', port).tap { |socket| socket.write("POST /api/v1/stop HTTP/1.1\r\nHost: ") }
    end
    pauses = Pauses.new(boresight.pids.values)
    began = Boresight.now
    net = pauses.net_seconds { assert_equal '200', boresight.post_stop(stop_port).code }
    [Boresight.now - began, net]
  ensure
    slow&.each(&:close)
  end

  def test_SWR_HTTP_007_a_stop_leaves_among_six_hundred_slow_clients
    { 'of the console' => boresight.http_port, 'for stops' => boresight.stop_port }.each do |name, port|
      all, net = Array.new(10) { stop_seconds_among(SLOW_CLIENTS, port) }.transpose.map(&:sort)
      assert_operator net.last, :<, LEAVES_SECONDS
      puts format('SWR-HTTP-007: %d slow clients at the port %s: stopped after %.3f s (median), %.3f s (worst of 10), ' \
                  '%.3f s without the pauses', SLOW_CLIENTS, name, all[5], all.last, net.last)
    end
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

  def test_SWR_LOAD_009_half_requests_that_come_again_and_again_delay_a_stop_by_less_than_100_ms
    pauses = Pauses.new(boresight.pids.values)
    Crowd.around(boresight.http_port, halves: HALVES) do
      ms = Array.new(100) { pauses.net_seconds { assert_equal '200', boresight.post_stop.code } * 1000 }.sort
      puts format('SWR-LOAD-009: stops at the port of the console take %.0f ms (median), %.0f ms (99 of 100)', ms[49], ms[98])
      assert_operator ms[98], :<, CROWD_STOP_MS
    end
  end

  def stop_ms(port)
    began = Boresight.now
    assert_equal '200', boresight.post_stop(port).code
    (Boresight.now - began) * 1000
  end

  # Both ports in turns, in the same flood.
  def test_SWR_LOAD_011_a_stop_in_a_flood_is_as_soon_at_the_port_of_the_console
    ports = [boresight.http_port, boresight.stop_port]
    times = []
    Crowd.around(boresight.http_port, comers: FLOOD) do
      FLOOD_STOPS.times { times << ports.map { |port| stop_ms(port) } }
    end
    console, own = times.transpose.map(&:sort)
    puts format('SWR-LOAD-011: a stop takes %.1f ms (median) and %.1f ms (99 of 100) at the port of the console, %.1f ms ' \
                'and %.1f ms at the port for stops', *[console, own].flat_map { |all| all.values_at(MEDIAN, P99) })
    assert_operator console[P99], :<=, own[P99] * CONSOLE_TIMES
  end
end
