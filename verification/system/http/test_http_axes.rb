# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: single axes are homed, cleared, confirmed and given their home over HTTP by a page that has authority, the
# last and the clearing by an engineer alone; the robot is lined up, its needle inserted, taken through a program, and to poses by both networks; what
# control refuses is answered by its name, and nothing moves without the pedal or is confirmed without the button.

require_relative '../support/igtl_client'
require_relative '../support/page_test'

class TestHttpAxes < Minitest::Test
  include PageTest
  extend PageTest::Homed

  def teardown
    boresight.simctl('pedal', 'release')
    boresight.simctl('button', 'release')
    super
  end

  # In MANUAL.
  def holder(name)
    super.tap { |one| assert_answer '200', 'done', one.act('workphase', { workphase: 'MANUAL' }) }
  end

  def assert_act_described(act, response)
    assert_described "/api/v1/motors/{axis}/#{act}", 'POST', response
  end

  def reference(axis)
    fetch_json('/api/v1/motors').fetch('axes').find { |one| one['name'] == axis }.fetch('reference')
  end

  # Armed mode of the status, and its progress.
  def shown_mode
    status = fetch_json('/api/v1/status')
    [status.dig('mode', 'name'), *status.values_at('done_per_mille', 'left_ms')]
  end

  # Under a pedal that is pressed anew, to its end.
  def run_act(page, path, fields = {})
    assert_answer '202', 'accepted', page.act(path, fields)
    assert_described "/api/v1/#{path}", 'POST', page.last
    boresight.simctl('pedal', 'release')
    boresight.await_released_pedal
    boresight.simctl('pedal', 'press')
    wait_until("#{path} is done") { page.keep && JSON.parse(page.act(path, fields, id: page.id).body)['state'] == 'done' }
    boresight.simctl('pedal', 'release')
  end

  def ticks(axis)
    fetch_json('/api/v1/motors').fetch('axes').find { |one| one['name'] == axis }.fetch('position_ticks')
  end

  def test_SWR_POSE_006_the_poses_of_the_robot_are_reported_and_gone_to_by_name
    assert_equal %w[PARK DRAPING EGRESS], fetch_json('/api/v1/robot').fetch('poses')
    anna = holder('anna')
    assert_answer '409', 'NO_POSE', anna.act('pose', { pose: 'HOME' })
    assert_answer '422', 'OUT_OF_RANGE', anna.act('pose', { pose: 'BED' })
    run_act(anna, 'pose', { pose: 'PARK' })
    assert_equal [-79, 477], [ticks('head'), ticks('pitch')]
  end

  def test_SWR_POSE_006_a_client_of_openigtlink_says_pose_and_its_name
    IgtlClient.open(boresight.brp_port) do |client|
      client.phase('MANUAL')
      client.run('expect STATUS MANUAL 1')
      client.run('string Text POSE PARK')
      client.run('expect STATUS ACK_POSE 1')
      boresight.simctl('pedal', 'press')
      assert client.run('expect STATUS POSE 1')
      client.run('string ALIGN')
      assert_match(/\A(NO_TARGET|NO_ENTRY_POINT|WRONG_WORKPHASE): /, client.status('ALIGN')['text'])
    end
  end

  def test_SWR_IGTL_090_a_client_of_the_later_server_drapes_the_robot
    IgtlClient.open(boresight.brp_port) do |client|
      client.phase('PLANNING')
      client.run('expect STATUS CURRENT_STATUS 1')
      client.phase('DRAPING')
      assert client.run('expect STATUS DRAPING 1')
      assert_equal 'MANUAL', fetch_json('/api/v1/status').dig('workphase', 'name')
      boresight.simctl('pedal', 'press')
      wait_until('it stands at the pose DRAPING') { [ticks('head'), ticks('pitch')] == [-3543, 358] }
    end
  end

  # To a target 3 mm in, near where the robot is.
  def aim(page)
    %w[PLANNING CALIBRATION].each { |phase| page.act('workphase', { workphase: phase }) }
    page.act('targeting/registration', { matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] })
    page.act('workphase', { workphase: 'TARGETING' })
    assert_answer '409', 'NO_TARGET', page.act('align')
    page.act('targeting/entry', { point_mm: [17, 246, 68] })
    assert_answer '200', 'done', page.act('targeting/target', { point_mm: [17, 207, 68] })
  end

  def test_SWR_ALIGN_007_the_robot_lines_up_and_then_inserts
    anna = holder('anna')
    aim(anna)
    run_act(anna, 'align')
    assert_operator ticks('insertion'), :<, 2083
    assert_answer '409', 'WRONG_WORKPHASE', anna.act('needle/insert')
    assert_answer '202', 'accepted', anna.act('workphase', { workphase: 'MOVE_TO_TARGET' })
    run_act(anna, 'needle/insert')
    assert_in_delta 10_000, ticks('insertion'), 40
    run_act(anna, 'needle/retract')
  end

  PROGRAM = '/api/v1/program'

  def send_program(page, *steps)
    steps = steps.map { |depth_mm, angle_deg, dwell_s, gate| { depth_mm:, angle_deg:, dwell_s:, gate: } }
    page.request('post', PROGRAM, JSON.generate({ steps: }), 'X-Boresight-Page' => page.page.to_s)
  end

  # From a pedal that is pressed to the dose of the second step.
  def run_program(page, checksum)
    assert_answer '202', 'accepted', page.act('program/run', { checksum: })
    boresight.simctl('pedal', 'press')
    wait_until('it dwells in its second step') { page.keep && fetch_json(PROGRAM).then { |one| one['done'] == 1 && one['dwelt_s'].positive? } }
    assert_operator fetch_json('/api/v1/status')['left_ms'], :>, 500_000
    boresight.simctl('gate', 'dose')
    wait_until('it is done') { JSON.parse(page.act('program/run', { checksum: }, id: page.id).body)['state'] == 'done' }
  ensure
    boresight.simctl('gate', 'off')
    boresight.simctl('pedal', 'release')
  end

  def test_SWR_PROG_012_a_program_is_judged_run_ended_by_its_dose_and_emptied
    anna = holder('anna')
    aim(anna)
    run_act(anna, 'align')
    refused = JSON.parse(assert_described(PROGRAM, 'POST', send_program(anna, [2, 0, 1, false], [5, 0, 1, false])).body)
    assert_equal ['PROGRAM_DEPTH', '/steps/1'], refused.values_at('code', 'pointer')
    reported = JSON.parse(assert_described(PROGRAM, 'POST', send_program(anna, [2, 20, 0.1, false], [2.9, 0, 600, true])).body)
    assert_equal [2, 'HTTP'], reported.values_at('steps', 'source')
    anna.act('workphase', { workphase: 'MOVE_TO_TARGET' })
    run_program(anna, reported['checksum'])
    assert_in_delta 9667, ticks('insertion'), 40
    emptied = anna.request('delete', PROGRAM, nil, 'X-Boresight-Page' => anna.page.to_s)
    assert_equal [0, nil], JSON.parse(assert_described(PROGRAM, 'DELETE', emptied).body).values_at('steps', 'source')
    run_act(anna, 'needle/retract')
  end

  # Lined up with a target 3 mm in.
  def line_up(client)
    %w[PLANNING CALIBRATION].each { |phase| client.phase(phase) }
    client.run('registration 1 0 0 0 0 1 0 0 0 0 1 0')
    client.run('expect STATUS CALIBRATION 1')
    client.phase('TARGETING')
    client.run('transform ENTRY_1 1 0 0 17 0 1 0 246 0 0 1 68')
    client.run('target -1 0 0 17 0 0 -1 207 0 -1 0 68')
    client.run('expect STATUS TARGET 1')
    under_pedal(client, 'ALIGN')
  end

  def under_pedal(client, word)
    boresight.simctl('pedal', 'release')
    client.run("string #{word}")
    client.run("expect STATUS ACK_#{word} 1")
    boresight.simctl('pedal', 'press')
    client.run("expect STATUS #{word} 1")
  ensure
    boresight.simctl('pedal', 'release')
  end

  # The checksum that its end states.
  def send_steps(client, *steps)
    lines = ["BEGIN #{steps.size}", *steps.each_with_index.map { |step, index| "STEP #{index} #{step}" }, 'END']
    reported = lines.map do |line|
      client.run("string Text PROGRAM #{line}")
      client.status('PROGRAM').values_at('code', 'text')
    end
    assert_equal [1], reported.map(&:first).uniq
    Integer(reported.last.last[/\AChecksum (\d+)\.\z/, 1])
  end

  def test_SWR_PROG_013_a_client_of_openigtlink_sends_a_program_and_runs_it_to_its_dose
    IgtlClient.open(boresight.brp_port) do |client|
      line_up(client)
      client.run('array PROGRAM 64 4 2 0 1 0 5 0 1 0')
      assert_match(/\APROGRAM_DEPTH: .* Step 1\.\z/, client.status('PROGRAM')['text'])
      checksum = send_steps(client, '2 mm 20 deg 0.1 s', '2.9 mm 0 deg 600 s GATE')
      wait_until('it is shown') { fetch_json(PROGRAM).values_at('steps', 'source', 'checksum') == [2, 'IGTL', checksum] }
      client.phase('MOVE_TO_TARGET')
      client.run('expect STATUS CURRENT_STATUS 1')
      client.run('string Text PROGRAM RUN 7')
      client.run('expect STATUS PROGRAM 10')
      client.run("string Text PROGRAM RUN #{checksum}")
      client.run('expect STATUS ACK_PROGRAM 1')
      boresight.simctl('pedal', 'press')
      assert_equal "2 #{checksum} 1", client.await('STRING', 'CURRENT_PROGRAM')['text'][/\A\d+ \d+ \d+/]
      wait_until('it dwells') { fetch_json(PROGRAM)['dwelt_s'].positive? }
      boresight.simctl('gate', 'dose')
      assert client.run('expect STATUS PROGRAM 1')
      assert_in_delta 9667, ticks('insertion'), 40
      under_pedal(client, 'RETRACT_NEEDLE')
    end
  ensure
    boresight.simctl('gate', 'off')
    boresight.simctl('pedal', 'release')
  end

  def test_SWR_AXIS_044_one_axis_homes_under_the_pedal_alone
    anna = holder('anna')
    assert_answer '202', 'accepted', anna.act('motors/yaw/home')
    assert_act_described 'home', anna.last
    assert_equal 'lost', reference('yaw')
    assert_equal ['HOME_AXIS', 0, 0], shown_mode
    boresight.simctl('pedal', 'press')
    wait_until('it is done') { JSON.parse(anna.act('motors/yaw/home', id: anna.id).body)['state'] == 'done' }
    assert_equal 'verified', reference('yaw')
    assert_equal ['NONE', 0, 0], shown_mode
  end

  def test_SWR_AXIS_044_a_home_that_an_engineer_sets_counts_once_the_button_has_confirmed_it
    egon = holder('egon')
    assert_answer '200', 'done', egon.act('motors/feet/clear')
    assert_act_described 'clear', egon.last
    assert_equal 'lost', reference('feet')
    assert_answer '200', 'done', egon.act('motors/feet/set-home')
    assert_equal 'unverified', reference('feet')
    assert_answer '200', 'done', egon.act('motors/feet/confirm')
    reported = authority
    assert_equal ['CONFIRM_AXIS', 1], reported.values_at('request', 'request_axis')
    assert_equal 'unverified', reference('feet')
    boresight.simctl('button', 'press')
    wait_until('it is confirmed') { egon.keep && reference('feet') == 'verified' }
  end

  def test_SWR_AXIS_044_a_refusal_has_its_name
    egon = holder('egon')
    { 'feet/home' => 'HOMES_OTHERWISE', 'yaw/set-home' => 'HOMES_OTHERWISE', 'yaw/confirm' => 'NOTHING_TO_CONFIRM' }.each do |path, code|
      assert_answer '409', code, egon.act("motors/#{path}")
      assert_act_described path.split('/').last, egon.last
    end
    egon.act('workphase', { workphase: 'PLANNING' })
    assert_answer '409', 'WRONG_WORKPHASE', egon.act('motors/yaw/clear')
    assert_equal 'verified', reference('yaw')
    assert_answer '404', 'NOT_THERE', egon.act('motors/nose/clear')
  end

  def position(axis)
    fetch_json('/api/v1/motors').fetch('axes').find { |one| one['name'] == axis }.fetch('position')
  end

  def run_at(one, fields)
    assert_answer '202', 'accepted', one.act('velocity', fields)
    assert_described '/api/v1/velocity', 'POST', one.last
    boresight.simctl('pedal', 'press')
    reported = nil
    wait_until('it has ended') { %w[done failed].include?((reported = JSON.parse(one.act('velocity', fields, id: one.id).body))['state']) }
    boresight.simctl('pedal', 'release')
    reported
  end

  def speed(axis, speed_per_s, unit = 'deg')
    { axis:, speed_per_s:, unit: }
  end

  def test_SWR_VEL_013_an_axis_runs_at_a_speed_for_a_way_and_up_to_its_limit
    anna = holder('anna')
    start = position('rotation')
    reported = run_at(anna, { speeds: [speed('rotation', -50)], way: 40, unit: 'deg' })
    assert_equal 'done', reported['state'], reported
    assert_in_delta start - 40, position('rotation'), 0.1
    reported = run_at(anna, { speeds: [speed('pitch', 50), speed('rotation', 20)], time_s: 3 })
    assert_equal %w[failed SWITCH_ZONE pitch], reported.values_at('state', 'code', 'axis'), reported
  end

  def test_SWR_VEL_013_what_is_no_speed_is_refused_by_its_place_or_name
    anna = holder('anna')
    yaw = speed('yaw', -5)
    { { speeds: [yaw, speed('nose', 1)], time_s: 1 } => ['422', 'OUT_OF_RANGE', '/speeds/1'],
      { speeds: [yaw, yaw], time_s: 1 } => ['422', 'OUT_OF_RANGE', '/speeds/1'],
      { speeds: [yaw], time_s: 1, way: 1, unit: 'deg' } => ['400', 'BAD_BODY', '/time_s'],
      { speeds: [yaw] } => ['400', 'BAD_BODY', '/time_s'],
      { speeds: [speed('yaw', 61)], time_s: 1 } => ['409', 'TOO_FAST', nil],
      { speeds: [speed('yaw', 0)], time_s: 1 } => ['409', 'OUT_OF_RANGE', nil] }.each do |fields, expected|
      refusal = anna.act('velocity', fields)
      reported = JSON.parse(refusal.body)
      assert_equal expected, [refusal.code, *reported.values_at('code', 'pointer')], refusal.body
      assert_described '/api/v1/velocity', 'POST', refusal
    end
  end

  # Code of HTTP, name, place and sentence of the refusal of `fields`.
  def refusal_of(page, path, fields)
    refusal = page.act(path, fields)
    [refusal.code, *JSON.parse(refusal.body).values_at('code', 'pointer', 'detail')]
  end

  def test_SWR_HTTP_078_the_unit_of_another_axis_is_refused_with_that_of_this_one
    anna = holder('anna')
    yaw = 'Axis yaw goes in deg: its numbers need "unit": "deg".'
    assert_equal ['422', 'WRONG_UNIT', '/unit', yaw], refusal_of(anna, 'motors/yaw/jog', { position: 0, unit: 'mm' })
    assert_act_described 'jog', anna.last
    assert_equal ['422', 'WRONG_UNIT', '/unit', yaw.gsub('yaw', 'head').gsub('deg', 'mm')],
                 refusal_of(anna, 'motors/head/jog', { distance: 1, unit: 'deg' })
    assert_equal ['422', 'WRONG_UNIT', '/speeds/0/unit', yaw], refusal_of(anna, 'velocity', { speeds: [speed('yaw', -5, 'mm')], time_s: 1 })
    [{}, { unit: 'mm' }].each do |unit|
      assert_equal ['422', 'WRONG_UNIT', '/unit', yaw], refusal_of(anna, 'velocity', { speeds: [speed('yaw', -5)], way: 1, **unit })
      assert_described '/api/v1/velocity', 'POST', anna.last
    end
    assert_equal %w[400 BAD_BODY /unit], refusal_of(anna, 'velocity', { speeds: [speed('yaw', -5)], time_s: 1, unit: 'deg' }).take(3)
  end

  def test_SWR_HTTP_079_a_number_of_before_is_refused_with_what_is_expected_now
    anna = holder('anna')
    assert_equal ['400', 'BAD_BODY', '/unit', 'This is missing. Expected is one of mm, deg.'],
                 refusal_of(anna, 'motors/yaw/jog', { position: 0 })
    assert_equal ['400', 'BAD_BODY', '/speeds/0/speed', 'Nothing of this name is expected. Expected are axis, speed_per_s, unit.'],
                 refusal_of(anna, 'velocity', { speeds: [{ axis: 'yaw', speed: 5 }], time_s: 1 })
    step = { depth: 1, angle: 0, dwell_s: 1, gate: false }
    refusal = anna.request('post', PROGRAM, JSON.generate({ steps: [step] }), 'X-Boresight-Page' => anna.page.to_s)
    assert_equal ['/steps/0/depth', 'Nothing of this name is expected. Expected are depth_mm, angle_deg, dwell_s, gate.'],
                 JSON.parse(refusal.body).values_at('pointer', 'detail')
  end

  def test_SWR_SWEEP_012_a_sweep_is_commanded_by_name_and_refused_by_name
    anna = holder('anna')
    { { axis: 'rotation', is_free: true } => ['409', 'NO_SWEEP', nil], { axis: 'yaw' } => ['409', 'NO_SWEEP', nil],
      { axis: 'nose', is_free: true } => ['422', 'OUT_OF_RANGE', '/axis'] }.each do |fields, expected|
      refusal = anna.act('motion/sweep', fields)
      assert_equal expected, [refusal.code, *JSON.parse(refusal.body).values_at('code', 'pointer')], refusal.body
      assert_described '/api/v1/motion/sweep', 'POST', refusal
    end
  end

  # As the recorder writes it, of this robot.
  def sweep_file(robot)
    text = "# robot neuro #{robot.fetch('checksum')}\n# axis rotation\n# card high_frequency 66048\n" \
           "# ended 2026-11-22T17:50:00.000Z 1 SPEED\n" \
           "frequency_hz,upwards_ticks,downwards_ticks,upwards_rpm,downwards_rpm\n51600,673,-673,1.000,-1.000\n"
    format("%<text>s# crc32c %<sum>08x\n", text: text, sum: crc32c(text))
  end

  def crc32c(text)
    text.bytes.inject(0xFFFFFFFF) { |sum, byte| 8.times.inject(sum ^ byte) { |rest, _| (rest >> 1) ^ (rest[0] * 0x82F63B78) } } ^ 0xFFFFFFFF
  end

  def sweep_shown
    JSON.parse(assert_described('/api/v1/sweep', 'GET', get('/api/v1/sweep')).body)
  end

  def test_SWR_SWEEP_014_a_kept_sweep_is_shown_if_it_is_whole
    path = File.join(boresight.recordings, 'sweep-neuro.csv')
    assert_equal ['none', nil, []], sweep_shown.values_at('state', 'axis', 'points')
    whole = sweep_file(fetch_json('/api/v1/robot'))
    File.write(path, whole)
    assert_equal %w[kept rotation 2026-11-22T17:50:00.000Z SPEED], sweep_shown.values_at('state', 'axis', 'ended', 'end')
    assert_in_delta 1.0, sweep_shown['points'].first['upwards_rpm'], 0.001
    assert_equal whole, get('/api/v1/sweep.csv').body
    File.write(path, whole.sub('673', '674'))
    assert_equal ['damaged', []], sweep_shown.values_at('state', 'points')
    assert_equal '404', get('/api/v1/sweep.csv').code
  ensure
    FileUtils.rm_f(path)
  end

  def test_SWR_MODE_009_an_axis_is_disabled_enabled_and_jogged_by_a_distance
    anna = holder('anna')
    assert_answer '200', 'done', anna.act('motors/yaw/disable')
    assert_act_described 'disable', anna.last
    assert_answer '409', 'FAULT_PRESENT', anna.act('motors/yaw/jog', { distance: -1, unit: 'deg' })
    assert_answer '200', 'done', anna.act('motors/yaw/enable')
    assert_act_described 'enable', anna.last
    assert_answer '202', 'accepted', anna.act('motors/yaw/jog', { distance: -1, unit: 'deg' })
    assert_act_described 'jog', anna.last
    [{}, { position: 0, distance: -1 }].each do |body|
      anna.act('motors/yaw/jog', body.merge(unit: 'deg'))
      assert_equal ['400', '/position'], [anna.last.code, JSON.parse(anna.last.body)['pointer']]
    end
  end

  # The reason against this act, from the list of possible commands.
  def reason_against(act, client)
    modes = assert_described('/api/v1/modes', 'GET', client.request('get', '/api/v1/modes'))
    JSON.parse(modes.body).fetch('commands').find { |one| one['name'] == act }.fetch('reason')
  end

  def test_SWR_HTTP_056_what_may_be_commanded_is_reported_for_the_role_of_the_session
    anna = holder('anna')
    egon = client('egon')
    assert_equal 'The role of this account does not allow it.', reason_against('SET_HOME', anna)
    assert_nil reason_against('SET_HOME', egon)
    assert_nil reason_against('SET_HOME', client)
    assert_nil reason_against('CONFIRM_AXIS', anna)
    assert_equal 'Only in CALIBRATION.', reason_against('REGISTRATION', anna)
    assert_answer '200', 'done', anna.act('workphase', { workphase: 'CALIBRATION' })
    assert_nil reason_against('REGISTRATION', anna)
    assert_equal 'Only in MANUAL.', reason_against('SET_HOME', egon)
  end

  def test_SWR_AXIS_044_an_operator_neither_clears_nor_sets
    anna = holder('anna')
    %w[clear set-home].each { |act| assert_answer '403', 'ROLE_REFUSED', anna.act("motors/feet/#{act}") }
    anna.give_up
    %w[home confirm].each { |act| assert_answer '423', 'NO_AUTHORITY', anna.act("motors/feet/#{act}") }
  end
end
