# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'socket'
require_relative 'browser_run'
require_relative 'system_test'

# Commands START_UP whenever its address is asked for. The peer stays connected: control stops what the peer has
# armed when it leaves.
class StartUpService
  def initialize(port)
    @peer = WorkphasePeer.new(port)
    @server = TCPServer.new('127.0.0.1', 0)
    @thread = Thread.new { serve }
  end

  def url
    "http://127.0.0.1:#{@server.addr[1]}/"
  end

  def close
    @thread.kill
    @server.close
    @peer.close
  end

  private

  def serve
    1.step do |number|
      client = @server.accept
      nil until client.gets.to_s.strip.empty?
      @peer.command(format('CMD_%04d', number), 'START_UP')
      client.write("HTTP/1.1 204 No Content\r\nConnection: close\r\n\r\n")
      client.close
    end
  end
end

# For a test of the console in a real browser: one run of its FILE of app/console/e2e against one system.
module ConsoleRun
  # Time passes so much more slowly that homing does not end while a slow machine waits with the pedal pressed. START_UP
  # would arm nothing in a homed robot.
  SLOW = %w[--slow 8].freeze

  # Results of the run.
  def results
    @results ||= with_system { |boresight, service| BrowserRun.results(self::FILE, environment(boresight, service)) }
  end

  private

  def with_system
    boresight = Boresight.start(arguments: SLOW)
    service = StartUpService.new(boresight.brp_port)
    yield boresight, service
  ensure
    service&.close
    boresight&.kill_all
  end

  def environment(boresight, service)
    { 'BORESIGHT_URL' => "http://127.0.0.1:#{boresight.http_port}/",
      'BORESIGHT_LOGIN_CODE' => boresight.output[/^Login: +([A-Z2-9-]{14}) /, 1],
      'BORESIGHT_HTTP_PID' => boresight.pid_of('http').to_s,
      'BORESIGHT_SIMCTL' => "#{Boresight.program('boresight-simctl')} --box #{boresight.box}",
      'BORESIGHT_START_UP' => service.url }
  end
end
