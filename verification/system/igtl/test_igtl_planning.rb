# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: clients that plan and watch get what is true and nothing else; what they propose is shown, and moves
# nothing. One running system, homed and registered, serves all tests of this file that do not ask for another one.

require_relative '../support/igtl_client'
require_relative '../support/system_test'

class TestIgtlPlanning < Minitest::Test
  # A pose well inside the workspace, scanner coordinates with the identity as registration.
  TARGET = '-0.719331 -0.593747 -0.360594 11.173943 -0.074838 0.582304 -0.809519 225.277747 ' \
           '0.690625 -0.555326 -0.463305 66.443691'
  IDENTITY = '1 0 0 0 0 1 0 0 0 0 1 0'
  # As core/robot/neuro/robot.yml lists them.
  ORDER = %w[lateral yaw pitch insertion rotation head feet].freeze
  LENGTHS = { 'cannula_to_treatment' => 5, 'treatment_to_tip' => 10, 'robot_to_entry' => 5,
              'robot_treatment_home' => 41 }.freeze
  TYPES = %w[TRANSFORM STRING STATUS GET_TRANS GET_STATUS GET_CAPABIL GET_SENSOR STT_TDATA STP_TDATA COMMAND].freeze
  CARD_OF_YAW = '5'

  def self.boresight
    @boresight ||= prepared.tap { |system| Minitest.after_run { system.stop } }
  end

  # Homed and registered.
  def self.prepared
    Boresight.start(arguments: Boresight::FAST).tap do |system|
      IgtlClient.open(system.brp_port) do |client|
        client.phase('START_UP')
        client.run('expect STATUS CURRENT_STATUS 1')
        system.simctl('pedal', 'press')
        client.run('expect STATUS START_UP 1')
        system.simctl('pedal', 'release')
        system.simctl('pace', '1')
        client.phase('CALIBRATION')
        client.run("registration #{IDENTITY}")
        client.run('expect STATUS CALIBRATION 1')
      end
    end
  end

  def boresight
    self.class.boresight
  end

  # A client that has disconnected keeps authority until the axes rest.
  def setup
    boresight.wait_until('nobody commands') { boresight.status['authority']['state'] == 'nobody' }
  end

  def test_SWR_IGTL_038_joints_come_in_the_order_of_the_robot_s_file
    boresight.wait_until('all axes stand') { boresight.motors['axes'].all? { |axis| axis['speed_per_s'].zero? } }
    values = planning { |client| numbers(client.await('STRING', 'measured_jp')) }
    axes = boresight.motors['axes'].to_h { |axis| [axis['name'], axis] }
    assert_equal ORDER.size, values.size
    ORDER.zip(values).each { |name, value| assert_in_delta joint(axes.fetch(name)), value, 0.05, name }
    assert_operator values.uniq.size, :>, 2, 'another order would be another list'
  end

  def test_SWR_IGTL_039_lengths_of_the_probe_come_to_who_joins_and_who_asks
    planning do |client|
      2.times do
        LENGTHS.each { |name, millimetres| assert_equal format('%f', millimetres), client.await('STRING', name)['text'] }
        client.run('string start_up START_UP')
      end
    end
  end

  # A probe by the port of the workphase protocol, and the messages of the other port about it.
  def test_SWR_PROBE_007_another_probe_is_reported_at_once
    planning do |client|
      client.await('STRING', 'robot_treatment_home')
      IgtlClient.open(boresight.brp_port) do |navigation|
        navigation.phase('PLANNING') # Another test may have left MOVE_TO_TARGET behind.
        navigation.run('string PROBE treatment_to_tip 12 robot_to_entry 6 cannula_to_treatment 7 robot_to_treatment 46')
        assert_equal 1, navigation.status('PROBE')['code']
        assert_equal '46.000000', client.await('STRING', 'robot_treatment_home')['text']
        navigation.run('string PROBE treatment_to_tip 10 robot_to_entry 5 cannula_to_treatment 5 robot_to_treatment 41')
        assert_equal '41.000000', client.await('STRING', 'robot_treatment_home')['text']
      end
    end
  end

  def test_SWR_IGTL_040_questions_are_answered_by_name
    planning do |client|
      ['', ' measured_cp'].each do |name|
        client.run("ask GET_TRANS#{name}")
        client.run('wait TRANSFORM measured_cp')
      end
      client.run('ask GET_TRANS scanner_to_robot_reg')
      client.run('wait TRANSFORM scanner_to_robot_reg')
      client.run('ask GET_TRANS elsewhere')
      client.run('expect STATUS elsewhere 4')
      client.run('ask GET_STATUS ping')
      assert_equal 1, client.await('STATUS', 'ping')['code']
    end
  end

  def test_SWR_IGTL_041_types_are_named_on_both_ports_and_what_there_is_not_is_answered
    { planning: TYPES + %w[GET_POINT TRAJ], navigation: ['NDARRAY', *TYPES] }.each do |port, types|
      send(port) do |client|
        client.run('ask GET_STATUS ping')
        client.run('expect STATUS ping 1')
        client.run('ask GET_CAPABIL me')
        assert_equal types, client.await('CAPABILITY', 'me')['types']
        client.run('ask GET_IMAGE T1')
        client.run('expect STATUS T1 4')
        client.run('ask STP_QTDATA probe')
        client.run('wait RTS_QTDATA probe')
      end
    end
  end

  def test_SWR_IGTL_042_the_needle_is_tracked_on_both_ports
    [method(:planning), method(:navigation)].each do |port|
      port.call do |client|
        client.run('track probe 0')
        client.run('expect RTS_TDATA probe 0')
        3.times { client.run('wait TDATA probe') }
        client.run('ask STP_TDATA probe')
        client.run('expect RTS_TDATA probe 0')
        messages = client.run('listen 200')
        assert_empty(messages.select { |message| message['type'] == 'TDATA' })
      end
    end
  end

  def test_SWR_IGTL_043_a_command_is_answered_and_commands_nothing
    [boresight.igtl_port, boresight.brp_port].each do |port|
      before = boresight.status['workphase']['name']
      assert_equal [7, 'Status', 'SUCCESS'], reply_to(port, 7, 'Status').first(3)
      assert_match(/\A<Status Workphase="#{before}" Pose="OK" Homed="1" /, reply_to(port, 8, 'Status').last)
      assert_equal [9, 'MOVE_TO_TARGET', 'FAIL'], reply_to(port, 9, 'MOVE_TO_TARGET').first(3)
      assert_equal before, boresight.status['workphase']['name']
    end
  end

  def test_SWR_IGTL_044_a_flood_of_proposals_is_neither_refused_nor_written_down
    first = boresight.status['counts']['events']
    planning do |client|
      300.times { |i| client.run("transform TARGET_POINT #{at(i)}") }
      client.run("transform TARGET_POINT #{at(1000)}")
      messages = client.run('listen 0')
      until messages.any? { |message| message['name'] == 'target_point' && message['position'][0] == 1000 }
        assert_empty(messages.select { |message| message['type'] == 'STATUS' })
        messages = client.run('wait POINT target_point')
      end
    end
    written = boresight.log(first).count { |event| event['text'].match?(/propos/i) }
    assert_operator written, :>, 0
    assert_operator written, :<, 30
  end

  def test_SWR_IGTL_045_a_proposal_is_withdrawn_before_the_eyes_of_every_client
    planning do |watcher|
      planning do |client|
        client.run("transform ENTRY_POINT #{at(77)}")
        watcher.run('wait POINT entry_point')
        client.run('string ENTRY_POINT WITHDRAW')
        [client, watcher].each { |each| wait_for_no_point(each, 'entry_point') }
        client.run('ask GET_POINT entry_point')
        assert client.await('POINT', 'entry_point')['is_empty']
        client.run('string ENTRY_POINT WITHDRAW')
        client.run('expect STATUS ENTRY_POINT 13')
      end
    end
  end

  # Another one that sends the same again is the one that it is from; its age begins anew.
  def test_SWR_IGTL_071_a_proposal_is_shown_with_its_client_and_its_age_until_it_is_withdrawn
    planning do |client|
      client.run('traj Path both 5 205 60 5 190 61')
      boresight.wait_until('both are shown') { shown_proposer('target_by') }
      first = %w[entry_by target_by].map { |by| shown_proposer(by) }
      first.each { |by| assert_match(/\AIGTL transforms 127\.0\.0\.1:\d+\z/, by.values_at('source', 'name').join(' ')) }
      planning do |other|
        other.run('ask GET_STATUS ping')
        boresight.wait_until('it grows older') { shown_proposer('entry_by')['age_s'] > 0.2 }
        other.run("transform ENTRY_POINT #{at(77)}")
        boresight.wait_until('it is of the other one') { shown_proposer('entry_by')['peer'] != first[0]['peer'] }
        assert_operator shown_proposer('entry_by')['age_s'], :<, shown_proposer('target_by')['age_s']
        assert_equal first[1]['peer'], shown_proposer('target_by')['peer']
      end
      %w[ENTRY_POINT TARGET_POINT].each { |name| client.run("string #{name} WITHDRAW") }
      boresight.wait_until('nothing is proposed') { boresight.targeting['proposals'].values_at('entry_by', 'target_by') == [nil, nil] }
    end
  end

  def test_SWR_IGTL_009_bare_transforms_move_nothing_even_with_the_pedal_pressed
    boresight.simctl('pedal', 'press')
    planning do |client|
      before = joints(client)
      [['REGISTRATION', IDENTITY], ['ENTRY_POINT', TARGET], ['TARGET_POINT', TARGET]].each do |name, matrix|
        client.run("transform #{name} #{matrix}")
        client.run('wait TRANSFORM measured_cp')
      end
      client.run("transform CURRENT_POSE #{TARGET}")
      client.run('expect STATUS CURRENT_POSE 12')
      client.run('listen 1000')
      assert_equal before, joints(client)
    end
  ensure
    boresight.simctl('pedal', 'release')
  end

  # The pedal is down, and still nothing but the two points is another.
  def test_SWR_IGTL_067_a_planned_trajectory_is_shown_until_who_commands_takes_its_entry
    boresight.simctl('pedal', 'press')
    planning do |client|
      before = joints(client)
      target = boresight.targeting['target'] # Another test may have aimed.
      client.run('traj Path both 5 205 60 5 190 61')
      assert_equal [5, 205, 60], client.await('POINT', 'entry_point')['position']
      assert_equal [5, 190, 61], client.await('POINT', 'target_point')['position']
      client.run('listen 300')
      assert_equal before, joints(client)
      assert_nil boresight.targeting['entry_mm']
      take_entry { assert_equal [[5, 205, 60], target], boresight.targeting.values_at('entry_mm', 'target') }
    end
  ensure
    boresight.simctl('pedal', 'release')
  end

  def test_SWR_IGTL_068_what_is_no_single_trajectory_is_refused_whole
    planning do |client|
      { 'both 5 205 60 5 190 nan' => 'NOT_FINITE', 'both 5 205 60 5 190 9e9' => 'OUT_OF_RANGE',
        'both 1 2 3 4 5 6 both 1 2 3 4 5 6' => 'NOT_ONE' }.each do |path, reason|
        client.run("traj Path #{path}")
        refused = client.status('Path')
        assert_equal [10, reason], [refused['code'], refused['text'][/\A\w+/]]
      end
    end
    navigation do |client|
      client.run('traj Path both 5 205 60 5 190 61')
      client.run('expect STATUS Path 12')
    end
  end

  def test_SWR_IGTL_012_joints_stream_while_the_robot_moves
    navigation do |commander|
      commander.phase('TARGETING')
      commander.run('expect STATUS TARGETING 1')
      commander.run("target #{TARGET}")
      commander.run('expect STATUS TARGET 1')
      commander.phase('MOVE_TO_TARGET')
      commander.run('expect STATUS CURRENT_STATUS 1')
      boresight.simctl('pedal', 'press')
      assert_joints_move
    end
  ensure
    boresight.simctl('pedal', 'release')
  end

  def test_SWR_IGTL_037_a_lost_reference_ends_the_streams_with_its_reason
    system = self.class.prepared
    IgtlClient.open(system.igtl_port) do |client|
      %w[measured_cp measured_jp measured_jv].each { |name| client.await(name.end_with?('cp') ? 'TRANSFORM' : 'STRING', name) }
      client.run('track probe 0')
      client.run('wait TDATA probe')
      system.simctl('card', CARD_OF_YAW, 'silent')
      %w[probe measured_cp measured_jp measured_jv].each do |name|
        assert_equal [13, 'NOT_HOMED'], client.status(name).values_at('code', 'error_name')
      end
      client.run('ask GET_TRANS')
      client.run('expect STATUS measured_cp 13')
      assert_only_reasons(client.run('listen 500'))
    end
  ensure
    system&.stop
  end

  private

  def planning(&)
    IgtlClient.open(boresight.igtl_port, &)
  end

  def navigation(&)
    IgtlClient.open(boresight.brp_port, &)
  end

  def shown_proposer(what)
    boresight.targeting['proposals'].fetch(what)
  end

  # As the commanding client, and gives it back: other tests have none.
  def take_entry
    navigation do |client|
      client.phase('TARGETING')
      client.run('string ACCEPT_ENTRY')
      assert_equal 1, client.status('ACCEPT_ENTRY')['code']
      yield
      client.run('string WITHDRAW_ENTRY')
      client.run('expect STATUS WITHDRAW_ENTRY 1')
    end
  end

  def at(x_mm)
    "1 0 0 #{x_mm} 0 1 0 0 0 0 1 0"
  end

  def numbers(message)
    message.fetch('text').delete_suffix(',').split(',').map { |number| Float(number) }
  end

  # mm or radians.
  def joint(axis)
    axis['unit'] == 'mm' ? axis['position'] : axis['position'] * Math::PI / 180
  end

  def joints(client)
    client.run('string start_up START_UP')
    client.await('STRING', 'measured_jp').fetch('text')
  end

  # A watcher is sent one list after the other, and they are not all the same.
  def assert_joints_move
    planning do |watcher|
      lists = Array.new(15) { watcher.run('wait STRING measured_jp') }.flatten.select { |m| m['name'] == 'measured_jp' }
      assert_operator lists.map { |message| message['text'] }.uniq.size, :>, 5
    end
  end

  def assert_only_reasons(messages)
    assert_empty(messages.reject { |message| message['type'] == 'STATUS' })
  end

  def wait_for_no_point(client, name)
    boresight.wait_until("#{name} has gone") { client.await('POINT', name)['is_empty'] }
  end

  # Id, name, verdict and text of the answer to a COMMAND of header version 2.
  def reply_to(port, id, name)
    content = [id, name, 3, 0].pack('Na128nN')
    body = [12, 2, 0, 0].pack('nnNN') + content + [0].pack('n')
    TCPSocket.open('127.0.0.1', port) do |socket|
      socket.write(RawIgtl.message('COMMAND', 'me', body, version: 2))
      type, answer = next_message(socket) until type == 'RTS_COMMAND'
      size = answer[146, 4].unpack1('N')
      [answer[12, 4].unpack1('N'), answer[16, 128].delete("\0"), answer[(150 + size + 16)..], answer[150, size]]
    end
  end

  def next_message(socket)
    header = socket.read(58)
    [header[2, 12].delete("\0"), socket.read(header[42, 8].unpack1('Q>'))]
  end
end
