# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: every workphase command is acknowledged in its time, whatever control and the other peers do.

require 'socket'
require_relative '../support/igtl_client'
require_relative '../support/pauses'
require_relative '../support/system_test'

class TestAcknowledgement < SystemTest
  ACK_MS = 100 # igtl_ack_us

  def setup
    boresight(arguments: ['--real-time'])
  end

  # Yields a client that commands workphases and judges the time of each acknowledgement.
  def judged
    IgtlClient.open(boresight.brp_port) do |client|
      pauses = Pauses.new([client.pid, *boresight.pids.values])
      yield(lambda do |name|
        paused = pauses.seconds
        ms = client.phase(name)
        assert_operator ms - ((pauses.seconds - paused) * 1000), :<, ACK_MS
        ms
      end, client)
    end
  end

  def test_SWR_IGTL_006_every_command_is_acknowledged_within_its_time
    judged do |phase|
      times = %w[STOP MANUAL PLANNING CALIBRATION].cycle.first(200).map { |name| phase.call(name) }.sort
      puts format('SWR-IGTL-006: acknowledged after %.2f ms (median), %.2f ms (worst of 200)', times[100], times.last)
    end
  end

  def test_SWR_IGTL_006_command_is_acknowledged_while_control_does_not_answer
    judged do |phase, client|
      boresight.while_stopped('control') do
        phase.call('MANUAL')
        assert_equal [7, 'NO_ANSWER'], client.status('MANUAL').values_at('code', 'error_name')
      end
    end
  end

  def test_SWR_IGTL_006_client_that_reads_nothing_delays_nobody
    TCPSocket.open('127.0.0.1', boresight.brp_port) do |flood|
      2000.times { flood.write_nonblock(RawIgtl.string('CURRENT_POSITION', ''), exception: false) }
    rescue Errno::EPIPE, Errno::ECONNRESET
      nil # It was dropped, which is as good.
    ensure
      judged { |phase| 50.times { phase.call('STOP') } }
    end
  end

  def test_SWR_IGTL_006_stop_of_another_is_obeyed_while_the_commanding_client_floods
    flooding do
      judged do |phase, client|
        20.times do
          phase.call('STOP')
          client.run('expect STATUS STOP 1')
        end
      end
    end
  end

  # Meanwhile the commanding client sends commands as fast as it can, and reads the answers.
  def flooding
    TCPSocket.open('127.0.0.1', boresight.brp_port) do |socket|
      reader = Thread.new { loop { socket.readpartial(65_536) } }
      writer = Thread.new do
        (1..).each { |id| socket.write(RawIgtl.string("CMD_F#{id}", %w[MANUAL PLANNING][id % 2])) }
      end
      reader.report_on_exception = writer.report_on_exception = false
      yield
    ensure
      [reader, writer].each { |thread| thread&.kill }
    end
  end
end
