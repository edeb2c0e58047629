# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: real clients of OpenIGTLink get every answer in time and in order, transforms alone move nothing, and
# no peer can disturb another. One running system serves all tests of this file; the clients are built on the standard's
# own library.

require 'json'
require 'open3'
require 'socket'
require_relative 'support/system_test'

# `boresight-client`, driven line by line.
class IgtlClient
  # It ended with a sentence.
  class Failed < StandardError; end

  def self.open(port)
    client = new(port)
    yield client
  ensure
    client&.close
  end

  def initialize(port)
    @input, @output, @errors, @thread = Open3.popen3(Boresight.program('boresight-client'), '--port', port.to_s)
    @seen = []
  end

  # Carries out one command; returns the messages that came meanwhile.
  def run(command)
    @input.puts(command)
    messages = []
    until (message = next_line).key?('done')
      messages << message
    end
    @seen.concat(messages)
    messages
  rescue Errno::EPIPE
    raise Failed, @errors.read
  end

  # Sends a workphase and waits for its acknowledgement, in ms.
  def phase(name)
    run("phase #{name}").find { |message| message['type'] == 'ACK' }.fetch('ack_ms')
  end

  # The next STATUS of this name.
  def status(name, seconds = 1)
    run("wait STATUS #{name} #{(seconds * 1000).to_i}").reverse.find { |m| m['type'] == 'STATUS' && m['name'] == name } ||
      @seen.reverse.find { |m| m['type'] == 'STATUS' && m['name'] == name }
  end

  def close
    @input.close
    @thread.join
  rescue Errno::EPIPE
    nil
  end

  private

  def next_line
    line = @output.gets
    raise Failed, @errors.read unless line

    JSON.parse(line)
  end
end

# Messages made by hand, for peers that the library would not let us play.
module RawIgtl
  module_function

  def message(type, name, body, version: 1, length: body.bytesize, crc: WorkphasePeer.crc64(body))
    [version, type, name, 0, length, crc].pack('na12a20Q>Q>Q>') + body
  end

  def string(name, text)
    message('STRING', name, [3, text.bytesize, text].pack('nna*'))
  end

  def transform(name)
    message('TRANSFORM', name, [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0].pack('g*'))
  end
end

class TestIgtl < Minitest::Test
  # A pose well inside the workspace, scanner coordinates with the identity as registration.
  TARGET = '-0.719331 -0.593747 -0.360594 11.173943 -0.074838 0.582304 -0.809519 225.277747 ' \
           '0.690625 -0.555326 -0.463305 66.443691'
  IDENTITY = '1 0 0 0 0 1 0 0 0 0 1 0'
  NOT_RIGID = '1 0 0 0 0 1 0 0 0 0 0.5 0'
  ACK_MS = 100
  CONNECTIONS = 8
  HOMING_SECONDS = 120
  MOVE_SECONDS = 60

  def self.boresight
    @boresight ||= Boresight.start.tap { |system| Minitest.after_run { system.stop } }
  end

  def boresight
    @fresh || self.class.boresight
  end

  # Every test starts in STOP with the pedal released and nobody in control.
  def setup
    boresight.simctl('pedal', 'release')
    navigation { |client| stop(client) }
  end

  def test_SWR_IGTL_006_every_command_is_acknowledged_within_its_time
    navigation do |client|
      times = %w[STOP MANUAL PLANNING CALIBRATION].cycle.first(200).map { |name| client.phase(name) }
      assert_operator times.max, :<, ACK_MS
    end
  end

  def test_SWR_IGTL_006_command_is_acknowledged_while_control_does_not_answer
    navigation do |client|
      while_stopped('control') do
        assert_operator client.phase('MANUAL'), :<, ACK_MS
        status = client.status('MANUAL')
        assert_equal [7, 'NO_ANSWER'], status.values_at('code', 'error_name')
      end
    end
  end

  def test_SWR_IGTL_006_client_that_reads_nothing_delays_nobody
    flood = TCPSocket.new('127.0.0.1', boresight.brp_port)
    navigation do |client|
      2000.times { flood.write_nonblock(RawIgtl.string('CURRENT_POSITION', ''), exception: false) }
      50.times { assert_operator client.phase('STOP'), :<, ACK_MS }
    end
  rescue Errno::EPIPE, Errno::ECONNRESET
    nil # It was dropped, which is as good.
  ensure
    flood&.close
  end

  def test_SWR_IGTL_007_whole_procedure_follows_the_protocol
    repeated_after_a_pause do
      navigation do |client|
        start_up(client)
        register(client)
        assert_entered client, 'TARGETING'
        client.run("target #{TARGET}")
        client.run('expect STATUS TARGET 1 1000')
        client.run('wait TRANSFORM TARGET 500')
        client.run('wait TRANSFORM REACHABLE_TARGET 500')
        move(client)
      end
    end
  end

  def test_SWR_IGTL_007_messages_of_2021_come_after_those_of_2013
    navigation do |client|
      client.phase('PLANNING')
      client.run('expect STATUS CURRENT_STATUS 1 1000')
      planning = client.run('wait STATUS PLANNING 500').last
      assert_equal %w[STATUS PLANNING], planning.values_at('type', 'name')
    end
  end

  def test_SWR_IGTL_007_messages_of_2021_are_withheld_when_the_next_command_comes_first
    navigation do |client|
      client.phase('PLANNING')
      client.run('expect STATUS CURRENT_STATUS 1 1000')
      client.phase('CALIBRATION')
      client.run('expect STATUS CURRENT_STATUS 1 1000')
      names = client.run('listen 200').map { |message| message['name'] }
      assert_equal ['CALIBRATION'], names
    end
  end

  def test_SWR_IGTL_007_repeated_command_is_not_executed_again
    navigation do |client|
      client.run('phase MANUAL 4711')
      client.run('expect STATUS MANUAL 1 1000')
      client.phase('STOP')
      client.run('expect STATUS STOP 1 1000')
      client.run('phase MANUAL 4711')
      client.run('expect-silence 200')
      assert_equal 'STOP', present_phase(client)
    end
  end

  def test_SWR_IGTL_008_stop_with_an_id_used_before_is_executed
    navigation do |client|
      client.run('phase STOP 4712')
      client.run('expect STATUS STOP 1 1000')
      client.phase('MANUAL')
      client.run('expect STATUS MANUAL 1 1000')
      client.run('phase STOP 4712')
      client.run('expect STATUS STOP 1 1000')
      assert_equal 'STOP', present_phase(client)
    end
  end

  def test_SWR_IGTL_006_stop_of_another_is_obeyed_while_the_commanding_client_floods
    flooding do
      navigation do |other|
        20.times do
          assert_operator other.phase('STOP'), :<, ACK_MS
          other.run('expect STATUS STOP 1 1000')
        end
      end
    end
  end

  def test_SWR_IGTL_008_refused_workphase_is_answered_with_its_reason
    navigation do |client|
      client.phase('MOVE_TO_TARGET')
      current = client.status('CURRENT_STATUS')
      assert_equal [13, 'STOP'], current.values_at('code', 'error_name')
      refused = client.status('MOVE_TO_TARGET')
      assert_equal [13, 'STOP'], refused.values_at('code', 'error_name')
      assert_match(/\AWRONG_WORKPHASE: .+\.\z/, refused['text'])
    end
  end

  def test_SWR_IGTL_008_unknown_command_is_answered
    navigation do |client|
      client.phase('DANCE')
      assert client.run('expect STATUS DANCE 12 1000')
      client.run('string RETRACT_NEEDLE')
      client.run('expect STATUS RETRACT_NEEDLE 12 1000')
      client.run("transform NPOS_1 #{IDENTITY}")
      client.run('expect STATUS NPOS_1 12 1000')
    end
  end

  def test_SWR_IGTL_008_target_and_registration_at_the_wrong_time_are_answered
    navigation do |client|
      client.run("target #{TARGET}")
      assert client.run('expect STATUS TARGET 13 1000')
      client.run("registration #{IDENTITY}")
      client.run('expect STATUS CALIBRATION 13 1000')
    end
  end

  def test_SWR_IGTL_008_second_connection_does_not_command_but_may_stop
    navigation do |first|
      first.phase('MANUAL')
      first.run('expect STATUS MANUAL 1 1000')
      navigation do |second|
        second.phase('PLANNING')
        second.run('expect STATUS PLANNING 5 1000')
        assert_equal 'MANUAL', present_phase(second)
        second.phase('STOP')
        second.run('expect STATUS STOP 1 1000')
      end
    end
  end

  def test_SWR_IGTL_009_bare_transforms_move_nothing_even_with_the_pedal_pressed
    boresight.simctl('pedal', 'press')
    planning do |client|
      client.run('listen 300')
      before = joints(client)
      [['REGISTRATION', IDENTITY], ['ENTRY_POINT', TARGET], ['TARGET_POINT', TARGET]].each do |name, matrix|
        client.run("transform #{name} #{matrix}")
        client.run('wait TRANSFORM measured_cp 1000')
      end
      client.run('listen 1000')
      assert_equal before, joints(client)
    end
    navigation { |client| assert_equal 'STOP', present_phase(client) }
  end

  def test_SWR_IGTL_010_bad_numbers_are_refused
    navigation do |client|
      assert_entered client, 'CALIBRATION', extra: true
      [NOT_RIGID, IDENTITY.sub('1', 'nan'), IDENTITY.sub('0', 'inf'), "#{IDENTITY[0..-2]}5000",
       '0 0 0 0 0 0 0 0 0 0 0 0', '1 0 0 0 0 1 0 0 0 0 -1 0'].each do |matrix|
        client.run("registration #{matrix}")
        client.run('expect STATUS CALIBRATION 10 1000')
      end
    end
  end

  def test_SWR_IGTL_011_garbage_is_dropped_and_others_go_on
    undisturbed do
      [Random.new(1).bytes(5000), "GET / HTTP/1.1\r\n\r\n" * 10,
       RawIgtl.message('TRANSFORM', 'TGT_1', '', length: (2**64) - 58),
       RawIgtl.message('STRING', 'CMD_1', '', length: 4097),
       RawIgtl.message('IMAGE', 'big', '', length: (2**20) + 1)].each { |bytes| assert_dropped bytes }
    end
  end

  def test_SWR_IGTL_011_half_a_message_is_dropped_after_its_time
    undisturbed do
      assert_dropped RawIgtl.string('CMD_1', 'START_UP')[0, 61], after: 4.5
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

  def test_SWR_IGTL_011_connections_beyond_the_last_are_closed
    sockets = Array.new(CONNECTIONS) { TCPSocket.new('127.0.0.1', boresight.igtl_port) }
    sockets.each { |socket| assert socket.wait_readable(2), 'a seated peer is shown the state' }
    raw(boresight.igtl_port) { |socket| assert_closed(socket, 2) }
  ensure
    sockets&.each(&:close)
  end

  def test_SWR_IGTL_011_losing_the_commanding_client_disarms
    with_unhomed_robot do
      navigation do |client|
        client.phase('START_UP')
        client.run('expect STATUS CURRENT_STATUS 1 1000')
      end
      navigation do |client|
        assert boresight.wait_until(2, 'the lost client has stopped the robot') { present_phase(client) == 'STOP' }
      end
    end
  end

  def test_SWR_IGTL_012_pose_and_joints_come_to_every_client
    planning do |client|
      messages = client.run('listen 500')
      names = messages.map { |message| message['name'] }
      assert_includes names, 'measured_cp'
      list = messages.find { |message| message['name'] == 'measured_jp' }.fetch('text')
      assert_match(/\A(-?\d+\.\d{6},){7}\z/, list)
    end
  end

  def test_SWR_IGTL_012_poses_stream_while_the_robot_moves
    with_unhomed_robot do
      navigation do |commander|
        commander.phase('START_UP')
        commander.run('expect STATUS CURRENT_STATUS 1 1000')
        boresight.simctl('pedal', 'press')
        assert_includes 15..21, count_poses('listen 2000')
      end
    end
  end

  def test_SWR_IGTL_013_polls_are_answered_to_everyone
    navigation do |first|
      first.phase('MANUAL')
      first.run('expect STATUS MANUAL 1 1000')
      navigation do |second|
        assert_equal 'MANUAL', present_phase(second)
        second.run('get CURRENT_POSITION')
        second.run('string CURRENT_POSITION')
        second.run('wait TRANSFORM CURRENT_POSITION 500')
        second.run('wait STRING IS_IN_TARGETING_POS 500')
        second.run('wait STRING HAS_REACHED_TARGET 500')
        second.run('string ANY CURRENT_STATUS')
        second.run('wait STATUS CURRENT_STATUS 500')
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
  def with_unhomed_robot
    @fresh = Boresight.start
    yield
  ensure
    @fresh&.stop
    @fresh = nil
  end

  # Runs the block on a new instance; once more, twice at most, when a pause of the machine stopped the motion.
  def repeated_after_a_pause
    2.downto(0) do |left|
      with_unhomed_robot do
        return yield
      rescue StandardError, Minitest::Assertion
        raise if left.zero? || !boresight.paused?
      end
    end
  end

  # Meanwhile the commanding client sends commands as fast as it can, and reads the answers.
  def flooding
    raw do |socket|
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

  def count_poses(command)
    planning do |watcher|
      watcher.run('wait TRANSFORM measured_cp 1000')
      watcher.run(command).count { |message| message['name'] == 'measured_cp' }
    end
  end

  def stop(client)
    client.phase('STOP')
    client.run('expect STATUS STOP 1 2000')
  end

  # 2013: the phase reports itself, except where its STATUS was added in 2021.
  def assert_entered(client, phase, extra: false)
    assert_operator client.phase(phase), :<, ACK_MS
    current = client.status('CURRENT_STATUS')
    assert_equal [1, phase], current.values_at('code', 'error_name')
    client.run("expect STATUS #{phase} 1 1000")
    client.run('expect-silence 100') if extra
  end

  def start_up(client)
    client.phase('START_UP')
    client.run('expect STATUS CURRENT_STATUS 1 1000')
    boresight.simctl('pedal', 'press')
    client.run("expect STATUS START_UP 1 #{HOMING_SECONDS * 1000}")
    boresight.simctl('pedal', 'release')
  end

  def register(client)
    assert_entered client, 'CALIBRATION', extra: true
    client.run("registration #{IDENTITY}")
    client.run('expect STATUS CALIBRATION 1 1000')
  end

  def move(client)
    client.phase('MOVE_TO_TARGET')
    client.run('expect STATUS CURRENT_STATUS 1 1000')
    boresight.simctl('pedal', 'press')
    messages = client.run("expect STATUS MOVE_TO_TARGET 1 #{MOVE_SECONDS * 1000}")
    assert_operator messages.count { |message| message['name'] == 'CURRENT_POSITION' }, :>, 5
    client.run('wait TRANSFORM CURRENT_POSITION 500')
    client.run('string HAS_REACHED_TARGET')
    reached = client.run('wait STRING HAS_REACHED_TARGET 500').last
    assert_equal '1', reached['text']
  end

  def present_phase(client)
    client.run('get CURRENT_STATUS').last.fetch('error_name')
  end

  def joints(client)
    client.run('string start_up START_UP')
    client.run('wait STRING measured_jp 1000').reverse.find { |message| message['name'] == 'measured_jp' }.fetch('text')
  end

  def while_stopped(name)
    pid = boresight.pids.fetch(name)
    Process.kill('STOP', pid)
    yield
  ensure
    Process.kill('CONT', pid)
  end

  def raw(port = boresight.brp_port)
    TCPSocket.open('127.0.0.1', port) { |socket| yield socket }
  end

  # Type and name of the next message.
  def header_of(socket)
    assert socket.wait_readable(2), 'an answer comes'
    socket.readpartial(58)[2, 32].unpack('A12A20').map { |text| text.delete("\0") }
  end

  def assert_closed(socket, seconds)
    deadline = Boresight.now + seconds
    loop do
      assert socket.wait_readable([deadline - Boresight.now, 0.01].max), "the server closes within #{seconds} s"
      socket.readpartial(4096)
    end
  rescue EOFError, Errno::ECONNRESET
    nil
  end

  # Not before `after` seconds.
  def assert_dropped(bytes, after: 0)
    raw do |socket|
      began = Boresight.now
      socket.write(bytes)
      assert_closed(socket, after + 2)
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

  # Meanwhile a good client is served in time, on the same connection all along.
  def undisturbed
    navigation do |client|
      stop(client)
      done = false
      watcher = Thread.new do
        times = []
        until done && times.size > 20
          times << client.phase('STOP')
          client.run('listen 20')
        end
        times
      end
      yield
      done = true
      assert_operator watcher.value.max, :<, ACK_MS
    end
  end
end
