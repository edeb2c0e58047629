# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: a procedure with a real client is the same conversation every time, and what happens by itself is
# said when it happens. The client is built on the standard's own library.

require 'tempfile'
require_relative '../support/igtl_client'
require_relative '../support/system_test'

class TestIgtlDialects < SystemTest
  TARGET = '-0.719331 -0.593747 -0.360594 11.173943 -0.074838 0.582304 -0.809519 225.277747 ' \
           '0.690625 -0.555326 -0.463305 66.443691'
  FAR = '1 0 0 900 0 1 0 0 0 0 1 0'
  IDENTITY = '1 0 0 0 0 1 0 0 0 0 1 0'
  QUIET = 'listen 300' # Nothing follows.

  # Messages to a client of 2013. The stream of positions counts as one.
  HEARD_2013 = [
    '> phase START_UP', 'STRING ACK_0001', 'STATUS CURRENT_STATUS 1 START_UP',
    'STATUS START_UP 1 START_UP',
    '> phase PLANNING', 'STRING ACK_0002', 'STATUS CURRENT_STATUS 1 PLANNING', 'STATUS PLANNING 1 PLANNING',
    '> phase TARGETING', 'STRING ACK_0003', 'STATUS CURRENT_STATUS 1 TARGETING', 'STATUS TARGETING 13 PLANNING',
    '> phase CALIBRATION', 'STRING ACK_0004', 'STATUS CURRENT_STATUS 1 CALIBRATION', 'STATUS CALIBRATION 1 CALIBRATION',
    '> registration', 'TRANSFORM ACK_0005', 'STATUS CALIBRATION 1 CALIBRATION',
    '> phase TARGETING', 'STRING ACK_0006', 'STATUS CURRENT_STATUS 1 TARGETING', 'STATUS TARGETING 1 TARGETING',
    '> target', 'TRANSFORM ACK_0007', 'STATUS TARGET 10 TARGETING',
    '> target', 'TRANSFORM ACK_0008', 'STATUS TARGET 1 TARGETING', 'TRANSFORM TARGET', 'TRANSFORM REACHABLE_TARGET',
    '> phase MOVE_TO_TARGET', 'STRING ACK_0009', 'STATUS CURRENT_STATUS 1 MOVE_TO_TARGET',
    'TRANSFORM CURRENT_POSITION', 'STATUS MOVE_TO_TARGET 1 MOVE_TO_TARGET', 'TRANSFORM CURRENT_POSITION',
    '> string HAS_REACHED_TARGET', 'STRING HAS_REACHED_TARGET',
    '> string RETRACT_NEEDLE', 'STATUS ACK_RETRACT_NEEDLE 1 MOVE_TO_TARGET',
    'STATUS RETRACT_NEEDLE 1 MOVE_TO_TARGET',
    '> phase MOVE_TO_TARGET', 'STRING ACK_0010', 'STATUS CURRENT_STATUS 1 MOVE_TO_TARGET',
    'TRANSFORM CURRENT_POSITION',
    '> phase STOP', 'STRING ACK_0011', 'STATUS CURRENT_STATUS 1 STOP', 'STATUS STOP 1 STOP',
    '> phase START_UP', 'STRING ACK_0012', 'STATUS CURRENT_STATUS 1 START_UP', 'STATUS START_UP 1 START_UP'
  ].freeze

  # Messages to a client of 2021: armed is entered, and where the needle is it asks.
  HEARD_2021 = [
    '> phase START_UP', 'STRING ACK_0001', 'STATUS CURRENT_STATUS 1 START_UP',
    'STATUS START_UP 1 START_UP',
    '> phase PLANNING', 'STRING ACK_0002', 'STATUS CURRENT_STATUS 1 PLANNING', 'STATUS PLANNING 1 PLANNING',
    '> phase TARGETING', 'STRING ACK_0003', 'STATUS CURRENT_STATUS 1 TARGETING', 'STATUS TARGETING 13 PLANNING',
    '> phase CALIBRATION', 'STRING ACK_0004', 'STATUS CURRENT_STATUS 1 CALIBRATION', 'STATUS CALIBRATION 1 CALIBRATION',
    '> registration', 'TRANSFORM ACK_0005', 'STATUS CALIBRATION 1 CALIBRATION',
    '> phase TARGETING', 'STRING ACK_0006', 'STATUS CURRENT_STATUS 1 TARGETING', 'STATUS TARGETING 1 TARGETING',
    '> target', 'TRANSFORM ACK_0007', 'STATUS TARGET 10 TARGETING',
    '> target', 'TRANSFORM ACK_0008', 'STATUS TARGET 1 TARGETING', 'TRANSFORM REACHABLE_TARGET',
    '> phase MOVE_TO_TARGET', 'STRING ACK_0009', 'STATUS CURRENT_STATUS 1 MOVE_TO_TARGET',
    'STATUS MOVE_TO_TARGET 1 MOVE_TO_TARGET', 'TRANSFORM CURRENT_POSITION',
    '> string HAS_REACHED_TARGET', 'STRING HAS_REACHED_TARGET',
    '> string RETRACT_NEEDLE', 'STATUS ACK_RETRACT_NEEDLE 1 MOVE_TO_TARGET',
    'STATUS RETRACT_NEEDLE 1 MOVE_TO_TARGET',
    '> phase MOVE_TO_TARGET', 'STRING ACK_0010', 'STATUS CURRENT_STATUS 1 MOVE_TO_TARGET',
    'STATUS MOVE_TO_TARGET 1 MOVE_TO_TARGET', 'TRANSFORM CURRENT_POSITION',
    '> phase STOP', 'STRING ACK_0011', 'STATUS CURRENT_STATUS 1 STOP', 'STATUS STOP 1 STOP',
    '> phase START_UP', 'STRING ACK_0012', 'STATUS CURRENT_STATUS 1 START_UP', 'STATUS START_UP 1 START_UP'
  ].freeze

  def test_SWR_IGTL_007_a_procedure_with_a_client_of_2013
    converse(boresight.brp_port) do
      procedure { listen('expect STATUS MOVE_TO_TARGET 1', 'wait TRANSFORM CURRENT_POSITION', QUIET) }
    end
    assert_equal HEARD_2013, @heard
  end

  def test_SWR_IGTL_031_a_procedure_with_a_client_of_2021
    port = boresight_of_2021
    converse(port) do
      procedure { await_arrival }
    end
    assert_equal HEARD_2021, @heard
  end

  def test_SWR_IGTL_030_nothing_is_said_of_an_order_that_stop_has_ended
    converse(boresight.brp_port) do |client|
      client.phase('START_UP')
      client.run('expect STATUS CURRENT_STATUS 1')
      boresight.simctl('pedal', 'press')
      wait_until('an axis is driven') { boresight.moving? }
      client.phase('STOP')
      client.run('expect STATUS CURRENT_STATUS 1')
      client.run('expect STATUS STOP 1')
      assert client.run('expect-silence 500')
    end
  end

  def test_SWR_IGTL_032_a_card_lost_in_an_order_is_a_hardware_failure
    converse(boresight.brp_port) do |client|
      client.phase('START_UP')
      client.run('expect STATUS CURRENT_STATUS 1')
      boresight.simctl('pedal', 'press')
      wait_until('an axis is driven') { boresight.moving? }
      boresight.simctl('card', '3', 'silent')
      failure = client.status('START_UP')
      assert_equal [18, 'START_UP'], failure.values_at('code', 'error_name')
      assert_match(/\AHARDWARE_FAILURE: Card 3 is lost\./, failure['text'])
      assert client.run('expect-silence 500')
    end
  end

  def test_SWR_IGTL_033_what_happens_while_nothing_moves_is_said_to_who_commands
    converse(boresight.brp_port) do |client|
      IgtlClient.open(boresight.brp_port) do |watcher|
        client.phase('STOP')
        client.run('expect STATUS STOP 1')
        client.phase('MANUAL') # By this it commands: it is accepted.
        client.run('expect STATUS MANUAL 1')
        boresight.simctl('card', '3', 'silent')
        failure = client.status('MANUAL')
        assert_equal 18, failure['code']
        boresight.simctl('estop', 'pull')
        pulled = client.status('EMERGENCY')
        assert_equal [3, 'PANIC_MODE'], pulled.values_at('code', 'error_name')
        boresight.simctl('estop', 'reset')
        boresight.post_stop
        assert_equal 1, client.status('STOP')['code']
        watcher.phase('EMERGENCY')
        assert_equal 3, client.status('EMERGENCY')['code']
        client.run('expect-silence 300')
      end
    end
  end

  def test_SWR_IGTL_033_a_controller_that_falls_silent_is_said
    converse(boresight.brp_port) do |client|
      client.phase('STOP')
      client.run('expect STATUS STOP 1')
      client.phase('MANUAL')
      client.run('expect STATUS MANUAL 1')
      boresight.while_stopped('control') do
        lost = client.status('MANUAL')
        assert_equal [7, 'NO_ANSWER'], lost.values_at('code', 'error_name')
      end
    end
  end

  def test_SWR_IGTL_051_nothing_is_known_from_a_controller_that_is_silent
    converse(boresight.brp_port) do |client|
      IgtlClient.open(boresight.igtl_port) do |display|
        display.run('expect STATUS measured_cp 13')
        boresight.while_stopped('control') do
          display.run('expect STATUS measured_cp 7')
          client.run('ask GET_TRANS CURRENT_POSITION')
          assert_equal [7, 'NO_ANSWER'], client.status('CURRENT_POSITION').values_at('code', 'error_name')
        end
        display.run('expect STATUS measured_cp 13')
      end
    end
  end

  private

  def converse(port)
    IgtlClient.open(port) do |client|
      @heard = []
      @client = client
      yield client
    end
  end

  # One with a file of ports; returns the port of 2021.
  def boresight_of_2021
    ports = Boresight.free_ports(2)
    file = Tempfile.create(['ports', '.conf'])
    file.write("[navigation]\ndialect = brp-2021\nlisten = 127.0.0.1:#{ports[0]}\n")
    file.close
    boresight(arguments: ['--igtl-file', file.path])
    ports[0]
  end

  # Asks until it is there, and does not record that.
  def await_arrival
    wait_until('the needle has arrived') do
      @client.run('string HAS_REACHED_TARGET')
      @client.await('STRING', 'HAS_REACHED_TARGET')['text'] == '1'
    end
  end

  # A position may still be under way when the next command is sent.
  def last_received
    @heard.reverse_each.find { |line| !line.start_with?('>') }
  end

  # Carries out commands; the first one is recorded. A stream of positions is one line.
  def hear(*commands)
    @heard << "> #{commands.first.split.first(commands.first.match?(/\A(phase|string)/) ? 2 : 1).join(' ')}"
    listen(*commands)
  end

  def listen(*commands)
    messages = commands.flat_map { |command| @client.run(command) }.reject { |message| message['type'] == 'ACK' }
    messages.map { |message| line_of(message) }.each do |line|
      @heard << line unless line == 'TRANSFORM CURRENT_POSITION' && last_received == line
    end
  end

  def line_of(message)
    message.values_at('type', 'name', *(message['type'] == 'STATUS' ? %w[code error_name] : [])).join(' ')
  end

  def press
    boresight.simctl('pedal', 'release')
    boresight.await_released_pedal
    boresight.simctl('pedal', 'press')
  end

  # The block listens until the needle has arrived.
  def procedure(&)
    prepare
    aim
    move(&)
    move_and_stop
  end

  def prepare
    enter('START_UP', 'expect STATUS CURRENT_STATUS 1')
    press
    listen('expect STATUS START_UP 1', QUIET)
    enter('PLANNING', 'expect STATUS PLANNING 1')
    enter('TARGETING', 'expect STATUS TARGETING 13')
    enter('CALIBRATION', 'expect STATUS CALIBRATION 1')
    hear("registration #{IDENTITY}", 'expect STATUS CALIBRATION 1', QUIET)
  end

  def aim
    enter('TARGETING', 'expect STATUS TARGETING 1')
    hear("target #{FAR}", 'expect STATUS TARGET 10', QUIET)
    hear("target #{TARGET}", 'wait TRANSFORM REACHABLE_TARGET', QUIET)
  end

  def move
    enter('MOVE_TO_TARGET', 'expect STATUS CURRENT_STATUS 1')
    press
    yield
    hear('string HAS_REACHED_TARGET', 'wait STRING HAS_REACHED_TARGET', QUIET)
    hear('string RETRACT_NEEDLE', 'expect STATUS ACK_RETRACT_NEEDLE 1', QUIET)
    press
    listen('expect STATUS RETRACT_NEEDLE 1', QUIET)
  end

  # The robot is homed: START_UP needs no pedal and no time.
  def move_and_stop
    enter('MOVE_TO_TARGET', 'expect STATUS CURRENT_STATUS 1')
    press
    wait_until('it moves') { boresight.moving? }
    listen(QUIET)
    enter('STOP', 'expect STATUS STOP 1')
    enter('START_UP', 'expect STATUS START_UP 1')
  end

  def enter(phase, *commands)
    hear("phase #{phase}", *commands, QUIET)
  end
end
