# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: real clients of OpenIGTLink get every answer, and in order, and
# no peer can disturb another. One running system serves all tests of this file; the clients are built on the standard's
# own library.

require_relative '../support/igtl_client'
require_relative '../support/system_test'

class TestIgtl < Minitest::Test
  # A pose well inside the workspace, scanner coordinates with the identity as registration.
  TARGET = '-0.719331 -0.593747 -0.360594 11.173943 -0.074838 0.582304 -0.809519 225.277747 ' \
           '0.690625 -0.555326 -0.463305 66.443691'
  IDENTITY = '1 0 0 0 0 1 0 0 0 0 1 0'
  NOT_RIGID = '1 0 0 0 0 1 0 0 0 0 0.5 0'
  CONNECTIONS = 8
  TIMEOUT = Boresight::TIMEOUT_SECONDS

  def self.boresight
    @boresight ||= Boresight.start.tap { |system| Minitest.after_run { system.stop } }
  end

  def boresight
    @fresh || self.class.boresight
  end

  # Every test starts in STOP with the pedal released and no holder of authority.
  def setup
    boresight.simctl('pedal', 'release')
    navigation { |client| stop(client) }
  end

  def test_SWR_IGTL_007_whole_procedure_follows_the_protocol
    with_unhomed_robot do
      navigation do |client|
        start_up(client)
        register(client)
        planning { |watcher| watcher.run('wait TRANSFORM measured_cp') }
        client.run('get CURRENT_POSITION')
        assert_entered client, 'TARGETING'
        client.run("target #{TARGET}")
        client.run('expect STATUS TARGET 1')
        client.run('wait TRANSFORM TARGET')
        client.run('wait TRANSFORM REACHABLE_TARGET')
        move(client)
      end
    end
  end

  def test_SWR_VEL_014_a_client_lets_an_axis_run_at_a_speed
    with_unhomed_robot do
      navigation do |client|
        start_up(client)
        assert_entered client, 'MANUAL'
        client.run('string Text VELOCITY rotation 10 deg/s 0.4 s')
        client.run('expect STATUS ACK_VELOCITY 1')
        boresight.simctl('pedal', 'press')
        assert_equal [1, 'MANUAL'], client.status('VELOCITY').values_at('code', 'error_name')
        boresight.simctl('pedal', 'release')
        boresight.await_released_pedal
        assert_jogs client
      end
    end
  end

  def test_SWR_SWEEP_013_a_sweep_that_a_client_commands_is_refused_by_name
    navigation do |client|
      { 'rotation FREE' => 'NO_SWEEP', 'yaw FREE' => 'NO_SWEEP', 'nose FREE' => 'UNKNOWN_COMMAND' }.each do |words, reason|
        client.run("string Text SWEEP #{words}")
        assert_match(/\A#{reason}: /, client.status('SWEEP')['text'])
      end
    end
  end

  def test_SWR_IGTL_007_messages_of_2021_come_after_those_of_2013
    navigation do |client|
      client.phase('PLANNING')
      client.run('expect STATUS CURRENT_STATUS 1')
      planning = client.status('PLANNING')
      assert_equal %w[STATUS PLANNING], planning.values_at('type', 'name')
    end
  end

  def test_SWR_IGTL_007_repeated_command_is_not_executed_again
    navigation do |client|
      client.run('phase MANUAL 4711')
      client.run('expect STATUS MANUAL 1')
      client.phase('STOP')
      client.run('expect STATUS STOP 1')
      client.run('phase MANUAL 4711')
      client.run('expect-silence 200')
      assert_equal 'STOP', present_phase(client)
    end
  end

  def test_SWR_IGTL_008_stop_with_an_id_used_before_is_executed
    navigation do |client|
      client.run('phase STOP 4712')
      client.run('expect STATUS STOP 1')
      client.phase('MANUAL')
      client.run('expect STATUS MANUAL 1')
      client.run('phase STOP 4712')
      client.run('expect STATUS STOP 1')
      assert_equal 'STOP', present_phase(client)
    end
  end

  def test_SWR_IGTL_008_refused_workphase_is_answered_with_its_reason
    navigation do |client|
      client.phase('MOVE_TO_TARGET')
      current = client.status('CURRENT_STATUS')
      assert_equal [1, 'MOVE_TO_TARGET'], current.values_at('code', 'error_name')
      refused = client.status('MOVE_TO_TARGET')
      assert_equal [13, 'STOP'], refused.values_at('code', 'error_name')
      assert_match(/\AWRONG_WORKPHASE: .+\.\z/, refused['text'])
      assert_equal 'STOP', present_phase(client)
    end
  end

  def test_SWR_IGTL_008_unknown_command_is_answered
    navigation do |client|
      client.phase('DANCE')
      assert client.run('expect STATUS DANCE 12')
      client.run('string ALPHA 0.5')
      client.run('expect STATUS ALPHA 12')
      client.run("transform REGISTRATION #{IDENTITY}")
      client.run('expect STATUS REGISTRATION 12')
    end
  end

  def test_SWR_IGTL_008_target_and_registration_at_the_wrong_time_are_answered
    navigation do |client|
      client.run("target #{TARGET}")
      assert client.run('expect STATUS TARGET 13')
      client.run("registration #{IDENTITY}")
      client.run('expect STATUS CALIBRATION 13')
    end
  end

  def test_SWR_IGTL_008_second_connection_does_not_command_but_may_stop
    navigation do |first|
      first.phase('MANUAL')
      first.run('expect STATUS MANUAL 1')
      navigation do |second|
        second.phase('PLANNING')
        second.run('expect STATUS PLANNING 5')
        assert_equal 'MANUAL', present_phase(second)
        second.phase('STOP')
        second.run('expect STATUS STOP 1')
      end
    end
  end

  def test_SWR_IGTL_010_bad_numbers_are_refused
    navigation do |client|
      assert_entered client, 'CALIBRATION', extra: true
      [NOT_RIGID, IDENTITY.sub('1', 'nan'), IDENTITY.sub('0', 'inf'), "#{IDENTITY[0..-2]}5000",
       '0 0 0 0 0 0 0 0 0 0 0 0', '1 0 0 0 0 1 0 0 0 0 -1 0'].each do |matrix|
        client.run("registration #{matrix}")
        client.run('expect STATUS CALIBRATION 10')
      end
    end
  end

  def test_SWR_IGTL_011_garbage_is_dropped_and_others_go_on
    undisturbed do
      [Random.new(1).bytes(5000), "GET / HTTP/1.1\r\n\r\n" * 10,
       RawIgtl.message('TRANSFORM', 'TGT_1', '', length: (2**64) - 58),
       RawIgtl.message('STRING', 'CMD_1', '', length: (2**24) + 1),
       RawIgtl.message('IMAGE', 'big', '', length: (2**24) + 1)].each { |bytes| assert_dropped bytes }
    end
  end

  def test_SWR_IGTL_011_half_a_message_is_dropped_after_its_time
    undisturbed do
      assert_dropped RawIgtl.string('CMD_1', 'START_UP')[0, 61], after: 4.5
    end
  end

  # The checksum of zeros is 0.
  def test_SWR_IGTL_020_volume_long_text_and_foreign_name_cost_their_messages_alone
    raw do |socket|
      socket.write(RawIgtl.message('IMAGE', 'volume', "\0" * (2**24), crc: 0),
                   RawIgtl.message('STRING', 'long', "\0" * 5000, crc: 0), RawIgtl.transform("N\u00E4he"),
                   RawIgtl.message('GET_STATUS', 'CURRENT_STATUS', ''))
      assert_equal [%w[STATUS long], %w[STATUS N??he], %w[STATUS CURRENT_STATUS]], Array.new(3) { label_of_next(socket) }
    end
  end

  def test_SWR_IGTL_011_wrong_checksum_is_answered_and_not_obeyed
    raw do |socket|
      socket.write(RawIgtl.message('STRING', 'CMD_1', [3, 6, 'MANUAL'].pack('nna*'), crc: 1))
      assert_equal %w[STATUS CMD_1], header_of(socket)
    end
    navigation { |client| assert_equal 'STOP', present_phase(client) }
  end

  def test_SWR_IGTL_011_two_hundred_damaged_messages_hurt_nobody
    random = Random.new(20_130_612)
    templates = [RawIgtl.string('CMD_1', 'MOVE_TO_TARGET'), RawIgtl.transform('TGT_1'), RawIgtl.transform('CLB_1'),
                 RawIgtl.message('STATUS', '', "\0" * 31), RawIgtl.message('GET_STATUS', '', '')]
    undisturbed do
      200.times { send_and_leave(damage(templates.sample(random: random), random)) }
    end
    assert_equal 'STOP', navigation { |client| present_phase(client) }
  end

  def test_SWR_IGTL_026_nine_silent_displays_stay_and_a_tenth_that_speaks_is_served
    sockets = Array.new(CONNECTIONS + 1) { TCPSocket.new('127.0.0.1', boresight.igtl_port) }
    sockets.first(CONNECTIONS).each { |socket| assert socket.wait_readable(TIMEOUT), 'a seated peer is shown the state' }
    boresight.wait_until('one waits') { displays.values_at('peers', 'waiting') == [CONNECTIONS, 1] }
    assert served_after_asking?(boresight.igtl_port), 'one that asks is served'
    lost = sockets.count { |socket| closed?(socket) }
    assert_equal 1, lost, 'of the silent ones one has made room'
    boresight.wait_until('who waited has the place of who has gone') { displays.values_at('peers', 'waiting') == [CONNECTIONS, 0] }
  ensure
    sockets&.each(&:close)
  end

  def test_SWR_AUTH_011_losing_the_commanding_client_disarms
    with_unhomed_robot do
      navigation do |client|
        client.phase('START_UP')
        client.run('expect STATUS CURRENT_STATUS 1')
        assert boresight.wait_until('it is armed') { boresight.status['order'] == 'waiting' }
      end
      assert boresight.wait_until('the order of the lost client has ended') { boresight.status['order'] == 'none' }
    end
  end

  def test_SWR_IGTL_014_before_homing_every_pose_is_answered_by_its_reason
    planning do |client|
      2.times do
        %w[measured_cp measured_jp measured_jv].each { |name| client.run("expect STATUS #{name} 13") }
        client.run('string start_up START_UP')
      end
    end
    navigation do |client|
      client.run('string CURRENT_POSITION')
      assert_equal [13, 'NOT_HOMED'], client.status('CURRENT_POSITION').values_at('code', 'error_name')
      assert_equal '0', client.await('STRING', 'IS_IN_TARGETING_POS')['text']
    end
  end

  def test_SWR_IGTL_013_polls_are_answered_to_everyone
    navigation do |first|
      first.phase('MANUAL')
      first.run('expect STATUS MANUAL 1')
      navigation do |second|
        assert_equal 'MANUAL', present_phase(second)
        second.run('string CURRENT_POSITION')
        second.run('wait STATUS CURRENT_POSITION')
        second.run('wait STRING IS_IN_TARGETING_POS')
        second.run('wait STRING HAS_REACHED_TARGET')
        second.run('string ANY CURRENT_STATUS')
        second.run('wait STATUS CURRENT_STATUS')
      end
    end
  end

  private

  def navigation(&)
    IgtlClient.open(boresight.brp_port, &)
  end

  def planning(&)
    IgtlClient.open(boresight.igtl_port, &)
  end

  # START_UP moves only axes that are not homed.
  # SWR-FLOW-005: by a way, and what is no jog is refused.
  def assert_jogs(client)
    client.run('string Text JOG_BY nose 5 deg')
    assert_match(/\AUNKNOWN_COMMAND: /, client.status('JOG_BY')['text'])
    client.run('string Text JOG_BY rotation 5 deg')
    client.run('expect STATUS ACK_JOG_BY 1')
    boresight.simctl('pedal', 'press')
    assert_equal [1, 'MANUAL'], client.status('JOG_BY').values_at('code', 'error_name')
  end

  # In fast time: the order of messages is looked at, and no duration.
  def with_unhomed_robot
    @fresh = Boresight.start(arguments: Boresight::FAST)
    yield
  ensure
    @fresh&.stop
    @fresh = nil
  end

  def stop(client)
    client.phase('STOP')
    client.run('expect STATUS STOP 1')
  end

  # 2013: the phase reports itself, except where its STATUS was added in 2021.
  def assert_entered(client, phase, extra: false)
    client.phase(phase)
    current = client.status('CURRENT_STATUS')
    assert_equal [1, phase], current.values_at('code', 'error_name')
    client.run("expect STATUS #{phase} 1")
    client.run('expect-silence 100') if extra
  end

  def start_up(client)
    client.phase('START_UP')
    client.run('expect STATUS CURRENT_STATUS 1')
    boresight.simctl('pedal', 'press')
    client.run('expect STATUS START_UP 1')
    boresight.simctl('pedal', 'release')
  end

  def register(client)
    assert_entered client, 'CALIBRATION', extra: true
    client.run("registration #{IDENTITY}")
    client.run('expect STATUS CALIBRATION 1')
  end

  def move(client)
    client.phase('MOVE_TO_TARGET')
    client.run('expect STATUS CURRENT_STATUS 1')
    # Poses are sent by the clock of the world: the motion keeps its pace until six have come, and all of them come before its end.
    boresight.simctl('pace', '1')
    boresight.simctl('pedal', 'press')
    6.times { client.run('wait TRANSFORM CURRENT_POSITION') }
    boresight.simctl('pace', Boresight::FAST.last)
    client.run('expect STATUS MOVE_TO_TARGET 1')
    client.run('wait TRANSFORM CURRENT_POSITION')
    client.run('string HAS_REACHED_TARGET')
    assert_equal '1', client.await('STRING', 'HAS_REACHED_TARGET')['text']
  end

  def present_phase(client)
    client.run('get CURRENT_STATUS').last.fetch('error_name')
  end

  def raw(port = boresight.brp_port)
    TCPSocket.open('127.0.0.1', port) { |socket| yield socket }
  end

  # Type and name of the next message, which is read whole.
  def label_of_next(socket)
    assert socket.wait_readable(TIMEOUT), 'an answer comes'
    header = socket.read(58)
    socket.read(header[42, 8].unpack1('Q>'))
    header[2, 32].unpack('A12A20').map { |text| text.delete("\0") }
  end

  # Type and name of the next message.
  def header_of(socket)
    assert socket.wait_readable(TIMEOUT), 'an answer comes'
    socket.readpartial(58)[2, 32].unpack('A12A20').map { |text| text.delete("\0") }
  end

  def assert_closed(socket)
    loop do
      assert socket.wait_readable(TIMEOUT), 'the server closes'
      socket.readpartial(4096)
    end
  rescue EOFError, Errno::ECONNRESET
    nil
  end

  # The port for displays, as it is shown.
  def displays
    boresight.status['ports'].last
  end

  # Asks again until the answer is not that all places are taken: by then one has been silent for long.
  def served_after_asking?(port)
    raw(port) do |socket|
      boresight.wait_until('the asking one has a place') do
        socket.write(RawIgtl.string('start_up', 'start_up'))
        message_of(socket) != %w[STATUS start_up]
      end
    end
  end

  # Type and name of the next message, which is read to its end.
  def message_of(socket)
    header = read_all(socket, 58)
    read_all(socket, header[42, 8].unpack1('Q>'))
    header[2, 32].unpack('A12A20').map { |text| text.delete("\0") }
  end

  def read_all(socket, count)
    bytes = +''
    while bytes.bytesize < count
      assert socket.wait_readable(TIMEOUT), 'an answer comes'
      bytes << socket.readpartial(count - bytes.bytesize)
    end
    bytes
  end

  def closed?(socket)
    bytes = +''
    bytes = socket.read_nonblock(65_536, exception: false) while bytes.is_a?(String)
    bytes.nil?
  rescue Errno::ECONNRESET
    true
  end

  # Not before `after` seconds.
  def assert_dropped(bytes, after: 0)
    raw do |socket|
      began = Boresight.now
      socket.write(bytes)
      assert_closed(socket)
      assert_operator Boresight.now - began, :>=, after
    end
  rescue Errno::EPIPE, Errno::ECONNRESET
    nil # It was dropped while we wrote.
  end

  # Flips some bytes, and often cuts the end off.
  def damage(message, random)
    bytes = message.dup
    random.rand(1..4).times { bytes.setbyte(random.rand(bytes.bytesize), random.rand(256)) }
    random.rand(3).zero? ? bytes[0, random.rand(1..bytes.bytesize)] : bytes
  end

  def send_and_leave(bytes)
    raw { |socket| socket.write(bytes) }
  rescue Errno::EPIPE, Errno::ECONNRESET
    nil
  end

  # Meanwhile a good client is served, on the same connection all along.
  def undisturbed
    navigation do |client|
      stop(client)
      done = false
      watcher = Thread.new do
        served = 0
        until done && served > 20
          client.phase('STOP')
          served += 1
          client.run('listen 20')
        end
        served
      end
      yield
      done = true
      assert_operator watcher.value, :>, 20
    end
  end
end
