# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the file of ports alone says who may connect and who is called, the ports are shown, and a client that
# does not read while its order runs has lost it.

require_relative '../support/igtl_client'
require_relative '../support/system_test'

class TestIgtlPorts < SystemTest
  SAMPLE = File.expand_path('../../../docs/openigtlink-ports.ini', __dir__)
  TIMEOUT = Boresight::TIMEOUT_SECONDS

  # The sample with free ports in place of its own, in their order: called, workphases, displays.
  def with_file(text = File.read(SAMPLE))
    Dir.mktmpdir do |directory|
      ports = Boresight.free_ports(3)
      left = ports.dup
      file = File.join(directory, 'ports.ini')
      File.write(file, text.gsub(/^(connect|listen)( = [\d.]+):\d+$/) { "#{$1}#{$2}:#{left.shift}" })
      yield file, ports
    end
  end

  def row(name)
    boresight.status['ports'].find { |port| port['name'] == name }
  end

  def test_SWR_IGTL_025_peer_that_listens_is_called_and_commands_only_when_it_says_so
    with_file do |file, (called, *)|
      boresight(arguments: ['--igtl-file', file])
      wait_until('the vain call is shown') { row('slicer')['state'] == 'waiting' }
      server = TCPServer.new('127.0.0.1', called)
      assert server.wait_readable(TIMEOUT), 'it is called again'
      slicer = server.accept
      wait_until('it is shown as connected') { row('slicer').values_at('state', 'peers') == ['connected', 1] }
      assert_nil boresight.status['authority']['source']
      slicer.write(RawIgtl.string('CMD_1', 'STOP') + RawIgtl.string('CMD_2', 'PLANNING'))
      wait_until('it commands') { boresight.status['authority']['source'] == 'IGTL' }
      assert_equal '1', boresight.status['authority']['peer'].to_s[-1], 'its number ends with the place of its port'
      slicer.close
      wait_until('its end is shown') { row('slicer')['peers'].zero? }
      assert server.wait_readable(TIMEOUT), 'it is called again after its end'
      server.close
    end
  end

  def test_SWR_IGTL_028_ports_are_shown_as_the_file_names_them
    with_file do |file, ports|
      boresight(arguments: ['--igtl-file', file])
      wait_until('they are shown') { boresight.status['ports'].size == 3 }
      shown = boresight.status['ports'].map { |port| port.values_at('name', 'dialect', 'address') }
      assert_equal [['slicer', 'brp-2021', "127.0.0.1:#{ports[0]}"], ['scripts', 'brp-2013', "127.0.0.1:#{ports[1]}"],
                    ['displays', 'crtk', "0.0.0.0:#{ports[2]}"]], shown
      TCPSocket.open('127.0.0.1', ports[2]) { wait_until('it is counted') { row('displays')['peers'] == 1 } }
    end
  end

  def test_SWR_SUP_010_the_line_of_status_names_a_peer_that_is_not_reached
    with_file do |file, (called, *)|
      boresight(arguments: ['--igtl-file', file])
      missing = "slicer 127.0.0.1:#{called} not connected"
      wait_until('it is named') { boresight.output.lines.grep(/links/).last.to_s.include?(missing) }
      server = TCPServer.new('127.0.0.1', called)
      assert server.wait_readable(TIMEOUT), 'it is called again'
      wait_until('it is named no more') { !boresight.output.lines.grep(/links/).last.include?(missing) }
      server.close
    end
  end

  def test_SWR_SUP_009_a_wrong_file_is_refused_with_its_line_before_anything_starts
    with_file("[slicer]\ndialect = brp\n") { |file, _| assert_refused(file, 2, "#{file}, line 2: \"brp\" is no dialect") }
    assert_refused('/nowhere', 2, 'The file of ports /nowhere cannot be read')
    _, status = Open3.capture2e(Boresight.program('boresight-igtl'), '--instance', 'x', '--igtl-file', '/nowhere')
    assert_equal 2, status.exitstatus
  end

  def test_SWR_SUP_009_a_port_of_the_file_in_use_is_named_before_anything_starts
    with_file do |file, (_, listening, _)|
      server = TCPServer.new('127.0.0.1', listening)
      assert_refused(file, 3, "[scripts] cannot listen on 127.0.0.1:#{listening} (Address already in use)")
      server.close
    end
  end

  # It asks and asks, and reads nothing: its machine has no room left for the answers.
  def test_SWR_IGTL_027_client_that_hangs_while_the_robot_homes_stops_it
    client = Socket.new(:INET, :STREAM)
    client.setsockopt(:SOCKET, :RCVBUF, 1)
    client.connect(Addrinfo.tcp('127.0.0.1', boresight.brp_port))
    client.write(RawIgtl.string('CMD_1', 'START_UP'))
    wait_until('START_UP is armed') { boresight.status['order'] != 'none' }
    boresight.simctl('pedal', 'press')
    wait_until('an axis is driven') { boresight.moving? }
    60.times { client.write(RawIgtl.string('CURRENT_STATUS', 'CURRENT_STATUS')) }
    wait_until('its order has ended') { boresight.status['order'] == 'none' }
    wait_until('nothing moves under the pedal') { !boresight.moving? }
    refute boresight.status['is_homed'], 'it was stopped on the way'
    wait_until('the reason is reported') { boresight.output.include?('its order ran and it did not read') }
    client.close
  end

  def home_under_the_pedal
    boresight.press_and_command('START_UP')
    wait_until('an axis is driven') { boresight.moving? }
  end

  def assert_motion_ended(loss)
    wait_until('its order has ended') { boresight.status['order'] == 'none' }
    wait_until('nothing moves under the pedal') { !boresight.moving? }
    refute boresight.status['is_homed'], 'it was stopped on the way'
    lost = boresight.log.find { |event| event['name'] == 'AUTHORITY_LOST' }
    assert_includes lost['text'], loss
  end

  # The pedal would go on with it, and no client would know.
  def test_SWR_IGTL_052_an_order_that_waits_ends_with_the_server_that_it_came_by
    boresight.command('START_UP')
    wait_until('START_UP is armed') { boresight.status['order'] == 'waiting' }
    boresight.kill('igtl', 'KILL')
    wait_until('its order has ended') { boresight.status['order'] == 'none' }
  end

  def test_SWR_IGTL_052_a_motion_ends_with_the_server_that_it_was_commanded_by
    home_under_the_pedal
    boresight.kill('igtl', 'KILL')
    assert_motion_ended('RELEASED')
  end

  def test_SWR_AUTH_010_a_motion_ends_when_the_server_that_it_was_commanded_by_hangs
    home_under_the_pedal
    boresight.while_stopped('igtl') { assert_motion_ended('SILENT') }
  end

  private

  def assert_refused(file, code, sentence)
    instance = Boresight.new(arguments: ['--igtl-file', file])
    instance.launch
    assert_equal code, instance.wait_for_end, instance.output
    assert_includes instance.output, sentence
    assert_equal 1, instance.output.lines.size, instance.output
    assert_empty processes_of(instance.instance)
  end
end
