# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: what a page with authority asks for is commanded once and answered; what any other asks for is refused by
# the first reason there is, and nothing behind it is looked at.

require_relative '../support/page_test'

class TestHttpActs < Minitest::Test
  include PageTest
  extend PageTest::Homed

  def events(kind)
    fetch_json("/api/v1/log?text=#{kind.gsub(' ', '%20')}").fetch('entries').size
  end

  def workphase
    fetch_json('/api/v1/status').dig('workphase', 'name')
  end

  def test_SWR_HTTP_021_a_page_takes_authority_commands_and_gives_it_up
    anna = client('anna')
    assert_answer '423', 'NO_AUTHORITY', anna.act('workphase', { workphase: 'PLANNING' })
    assert_answer '200', 'done', anna.take
    assert_equal ['held', 'HTTP', anna.page], authority.values_at('state', 'source', 'peer')
    response = anna.act('workphase', { workphase: 'PLANNING' })
    assert_equal 'PLANNING', assert_answer('200', 'done', response).fetch('workphase')
    assert_equal 'PLANNING', workphase
    assert_equal '200', anna.keep.code
    # The page holds it no more; it has no holder in the cycle in which the robot is seen at rest.
    assert_includes %w[ending nobody], JSON.parse(anna.give_up.body).fetch('state')
    wait_until('nobody has authority') { authority.fetch('state') == 'nobody' }
    assert_answer '423', 'NO_AUTHORITY', anna.keep
  end

  def test_SWR_HTTP_021_control_refuses_by_name
    anna = holder
    anna.act('workphase', { workphase: 'PLANNING' })
    assert_answer '409', 'WRONG_WORKPHASE', anna.act('motors/yaw/jog', { position: 0, unit: 'deg' })
    anna.act('workphase', { workphase: 'MANUAL' })
    reported = assert_answer '409', 'AXIS_LIMIT', anna.act('motors/yaw/jog', { position: 1000, unit: 'deg' })
    assert_equal %w[yaw upper], reported.values_at('axis', 'limit')
    assert_described '/api/v1/motors/{axis}/jog', 'POST', anna.last
  end

  def test_SWR_HTTP_021_each_answer_is_as_described
    anna = client('anna')
    { 'authority' => {}, 'workphase' => { workphase: 'PLANNING' }, 'authority/request' => { what: 'CONFIRM' } }.each do |path, fields|
      assert_described "/api/v1/#{path}", 'POST', anna.act(path, fields)
      assert_described "/api/v1/#{path}", 'POST', anna.act(path, fields, id: 1)
    end
    %w[keep give_up].zip(%w[PUT DELETE]).each { |name, method| assert_described '/api/v1/authority', method, anna.public_send(name) }
    assert_described '/api/v1/authority', 'GET', get('/api/v1/authority')
  end

  def test_SWR_HTTP_023_a_repeated_act_does_nothing_again
    anna = holder
    anna.act('workphase', { workphase: 'CALIBRATION' })
    again = anna.id
    anna.act('workphase', { workphase: 'PLANNING' })
    assert_answer '200', 'done', anna.act('workphase', { workphase: 'CALIBRATION' }, id: again)
    assert_equal 'PLANNING', workphase
    assert_answer '409', 'ID_USED', anna.act('workphase', { workphase: 'MANUAL' }, id: again)
    anna.id += 10
    anna.act('workphase', { workphase: 'PLANNING' })
    assert_answer '409', 'ID_USED', anna.act('workphase', { workphase: 'MANUAL' }, id: anna.id - 1)
  end

  def test_SWR_HTTP_023_what_comes_many_times_at_once_is_done_once
    anna = holder
    in_targeting(anna)
    before = events('An entry point was taken')
    anna.id += 1
    answers = Array.new(20) { Thread.new { anna.dup.act('targeting/entry', { point_mm: [0, 246, 50] }, id: anna.id) } }.map(&:value)
    assert_equal [%w[200 done]], answers.map { |one| [one.code, JSON.parse(one.body)['state']] }.uniq
    assert_equal before + 1, events('An entry point was taken')
  end

  def test_SWR_HTTP_022_a_second_page_of_the_session_has_no_authority
    anna = holder
    other = anna.another_page
    assert_answer '423', 'NO_AUTHORITY', other.act('workphase', { workphase: 'PLANNING' })
    assert_answer '423', 'NO_AUTHORITY', other.take
    other.give_up
    assert_answer '200', 'done', anna.act('workphase', { workphase: 'PLANNING' })
  end

  def test_SWR_HTTP_022_the_page_of_another_session_is_refused
    anna = holder
    egon = client('egon')
    egon.page = anna.page
    assert_answer '403', 'PAGE_REFUSED', egon.act('workphase', { workphase: 'PLANNING' })
    assert_answer '403', 'PAGE_REFUSED', egon.give_up
    assert_equal anna.page, authority.fetch('peer')
  end

  def test_SWR_HTTP_025_who_logs_out_has_no_authority
    holder.log_out
    wait_until('nobody has authority') { authority.fetch('state') == 'nobody' }
  end

  def test_SWR_HTTP_035_a_page_that_renews_by_itself_keeps_no_session_awake
    anna = holder
    left = -> { JSON.parse(anna.request('get', SessionClient::PATH).body).fetch('idle_s') }
    whole = left.call
    wait_until('some of it has passed') { anna.keep.code == '200' && left.call < whole }
    self.assertions += 1
  end

  def test_SWR_HTTP_024_a_server_that_is_killed_leaves_no_authority
    anna = holder
    boresight.kill('http', 'KILL')
    wait_until('nobody has authority') { boresight.patiently { authority.fetch('state') == 'nobody' } }
    assert_answer '401', 'NO_SESSION', anna.keep
  end

  def test_SWR_HTTP_028_the_end_of_an_act_comes_by_the_stream
    anna = holder
    stream = open_stream
    anna.act('workphase', { workphase: 'MANUAL' })
    begun = assert_answer '202', 'accepted', anna.act('motors/yaw/jog', { position: -3, unit: 'deg' })
    assert_equal ['OK', 'Accepted; its end is reported later.'], begun.values_at('code', 'message')
    anna.give_up
    reported = stream.next_of('act')
    assert_equal [anna.page, anna.id, 'failed', 'NO_AUTHORITY'], reported.values_at('page', 'id', 'state', 'code')
    assert_nil openapi.message_fault('Act', reported)
  ensure
    stream&.close
  end

  def yaw
    fetch_json('/api/v1/motors').fetch('axes').last
  end

  def test_SWR_HTTP_029_an_axis_jogs_in_its_unit_and_under_the_pedal_alone
    anna = holder
    anna.act('workphase', { workphase: 'MANUAL' })
    before = yaw.fetch('position')
    assert_answer '202', 'accepted', anna.act('motors/6/jog', { position: -2, unit: 'deg' })
    refute yaw.fetch('is_driven')
    assert_equal before, yaw.fetch('position')
    assert_equal 0, yaw.fetch('output_percent')
    boresight.simctl('pedal', 'press')
    wait_until('it is driven downwards') { yaw.fetch('output_percent').negative? }
    wait_until('it is done') { JSON.parse(anna.act('motors/6/jog', { position: -2, unit: 'deg' }, id: anna.id).body)['state'] == 'done' }
    assert_in_delta(-2, yaw.fetch('position'), 0.02)
  ensure
    boresight.simctl('pedal', 'release')
  end

  def test_SWR_HTTP_027_an_axis_that_is_not_there_is_refused
    anna = holder
    ['nose', '7', '00', '-1', 'yaw%20', 'YAW', '4294967296', "a#{'b' * 100}"].each do |axis|
      assert_answer '404', 'NOT_THERE', anna.act("motors/#{axis}/jog", { position: 0, unit: 'deg' })
    end
    ['', 'yaw/x', '/yaw', 'yaw/'].each { |axis| assert_answer '404', 'NOT_FOUND', anna.act("motors/#{axis}/jog", { position: 0, unit: 'deg' }) }
    assert_equal '405', anna.request('get', '/api/v1/motors/yaw/jog').code
  end

  def test_SWR_HTTP_029_what_no_axis_can_mean_is_refused_where_it_stands
    anna = holder
    ['1e7', '-1e7'].each do |text|
      found = anna.request('post', '/api/v1/motors/yaw/jog', "{\"id\":#{anna.id += 1},\"position\":#{text},\"unit\":\"deg\"}",
                           'X-Boresight-Page' => anna.page.to_s)
      assert_equal %w[OUT_OF_RANGE /position], JSON.parse(found.body).values_at('code', 'pointer')
    end
  end

  # Each line is a fault and its reason; of two faults the one that stands first here is reported.
  FAULTS = {
    'HOST_REFUSED' => ->(head, _) { head['Host'] = 'evil.example' },
    'ORIGIN_REFUSED' => ->(head, _) { head['Origin'] = 'http://evil.example' },
    'NO_SESSION' => ->(head, _) { head['Cookie'] = 'x=y' },
    'TOKEN_REFUSED' => ->(head, _) { head['X-Boresight-Token'] = '0' * 64 },
    'ROLE_REFUSED' => ->(head, _) { head.merge!(head.delete(:observer)) },
    'NO_AUTHORITY' => ->(head, _) { head['X-Boresight-Page'] = '4711' },
    'NOT_THERE' => ->(head, _) { head[:axis] = 'nose' },
    'BAD_BODY' => ->(_, body) { body.replace('{"id":1}') }
  }.freeze

  # With a cookie that is wrong no token is right, and no role is known.
  def test_SWR_HTTP_026_of_two_reasons_the_first_is_reported
    anna = holder
    anna.act('workphase', { workphase: 'MANUAL' })
    olga = client('olga')
    FAULTS.keys.combination(2).each { |first, second| assert_equal first, code_of(anna, olga, first, second) }
    FAULTS.each_key { |one| assert_equal one, code_of(anna, olga, one) }
    assert_nil code_of(anna, olga)
  end

  def code_of(anna, olga, *faults)
    head = { 'Host' => host, 'Origin' => "http://#{host}", 'Cookie' => anna.cookie, 'X-Boresight-Token' => anna.token,
             'X-Boresight-Page' => anna.page.to_s, 'Content-Type' => 'application/json', 'Connection' => 'close' }
    head[:axis] = 'yaw'
    head[:observer] = { 'Cookie' => olga.cookie, 'X-Boresight-Token' => olga.token }
    anna.id += 1
    body = +"{\"id\":#{anna.id},\"position\":-3,\"unit\":\"deg\"}"
    faults.reverse.each { |fault| FAULTS.fetch(fault).call(head, body) }
    head.delete(:observer)
    axis = head.delete(:axis)
    lines = head.map { |name, value| "#{name}: #{value}\r\n" }.join
    _, answer = send_raw("POST /api/v1/motors/#{axis}/jog HTTP/1.1\r\n#{lines}Content-Length: #{body.bytesize}\r\n\r\n#{body}").split("\r\n\r\n", 2)
    reported = JSON.parse(answer)
    reported['code'] unless reported['code'] == 'OK'
  end

  def test_SWR_HTTP_026_a_page_must_say_which_it_is
    anna = holder
    ['', '0', '01', 'x', '4294967296', '-1', nil].each do |page|
      anna.page = page
      assert_answer '400', 'PAGE_MISSING', anna.act('workphase', { workphase: 'PLANNING' })
    end
  end

  IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1].freeze

  def in_targeting(anna)
    anna.act('workphase', { workphase: 'PLANNING' })
    anna.act('workphase', { workphase: 'CALIBRATION' })
    assert_answer '200', 'done', anna.act('targeting/registration', { matrix: IDENTITY })
    anna.act('workphase', { workphase: 'TARGETING' })
  end

  def preview(page, fields)
    page.request('post', '/api/v1/targeting/preview', JSON.generate(fields))
  end

  def range_at(place)
    return '0 0 0 1 as the last row' if place >= 12

    place % 4 == 3 ? 'a number from -2000 to 2000' : 'a number from -1 to 1'
  end

  def test_SWR_HTTP_031_SWR_HTTP_300_a_number_that_no_pose_has_is_refused_where_it_stands
    anna = holder
    anna.act('workphase', { workphase: 'PLANNING' })
    anna.act('workphase', { workphase: 'CALIBRATION' })
    { 0 => 1.1, 3 => 2000.1, 12 => 0.1, 15 => 0, 6 => -1.5 }.each do |place, number|
      matrix = IDENTITY.dup.tap { |one| one[place] = number }
      reported = assert_answer '422', 'OUT_OF_RANGE', anna.act('targeting/registration', { matrix: })
      assert_equal "/matrix/#{place}", reported['pointer']
      assert_equal "This is outside its range. Expected is #{range_at(place)}.", reported['detail']
    end
    assert_answer '409', 'NOT_RIGID', anna.act('targeting/registration', { matrix: IDENTITY.dup.tap { |one| one[0] = 0.9 } })
    reported = assert_answer '400', 'BAD_BODY', anna.act('targeting/registration', { matrix: IDENTITY.first(15) })
    assert_equal '/matrix', reported['pointer']
  end

  def test_SWR_HTTP_031_what_is_taken_is_shown_to_the_nanometre
    anna = holder
    in_targeting(anna)
    point = [1.234567, -200.000001, 50.5]
    assert_answer '200', 'done', anna.act('targeting/entry', { point_mm: point })
    assert_equal point, fetch_json('/api/v1/targeting').fetch('entry_mm')
    assert_answer '200', 'done', anna.act('targeting/withdraw', { what: 'entry' })
    assert_nil fetch_json('/api/v1/targeting').fetch('entry_mm')
    assert_answer '409', 'NOT_PROPOSED', anna.act('targeting/withdraw', { what: 'proposed_entry' })
  end

  def test_SWR_HTTP_031_a_point_is_a_target_with_an_entry_point
    anna = holder
    in_targeting(anna)
    assert_answer '409', 'NO_ENTRY', anna.act('targeting/target', { point_mm: [0, 200, 50] })
    assert_answer '400', 'BAD_BODY', anna.act('targeting/target')
    assert_answer '400', 'BAD_BODY', anna.act('targeting/target', { point_mm: [0, 200, 50], matrix: IDENTITY })
    anna.act('targeting/entry', { point_mm: [0, 246, 50] })
    assert_answer '200', 'done', anna.act('targeting/target', { point_mm: [0, 200, 50] })
    reached = fetch_json('/api/v1/targeting').fetch('target').values_at(3, 7, 11)
    reached.zip([0, 200, 50]).each { |is, asked| assert_in_delta asked, is, 0.1 }
    assert_described '/api/v1/targeting/target', 'POST', anna.last
  end

  # Straight down, as a turn by 180 degrees.
  POSE = { point_mm: [0, 200, 50], w: 0, x: 0, y: Math.sqrt(0.5), z: -Math.sqrt(0.5) }.freeze
  SAME = [-1, 0, 0, 0, 0, 0, -1, 200, 0, -1, 0, 50, 0, 0, 0, 1].freeze

  def test_SWR_HTTP_083_a_target_is_a_pose_of_a_point_and_a_quaternion
    anna = holder
    in_targeting(anna)
    reached = [{ matrix: SAME }, { pose: POSE }].map do |aim|
      assert_answer '200', 'done', anna.act('targeting/target', aim)
      fetch_json('/api/v1/targeting').fetch('target')
    end
    reached.first.zip(reached.last).each { |one, other| assert_in_delta one, other, 1e-6 }
    assert_described '/api/v1/targeting/target', 'POST', anna.last
    assert_answer '422', 'NO_UNIT_QUATERNION', anna.act('targeting/target', { pose: POSE.merge(w: 0.1) })
    assert_described '/api/v1/targeting/target', 'POST', anna.last
    assert_answer '400', 'BAD_BODY', anna.act('targeting/target', { pose: POSE, matrix: SAME })
    assert_answer '400', 'BAD_BODY', anna.act('targeting/target', { pose: POSE.except(:w) })
  end

  def test_SWR_HTTP_032_it_is_shown_from_whom_a_registration_is
    anna = holder
    in_targeting(anna)
    wait_until('it is known') { fetch_json('/api/v1/targeting')['registration_by'] }
    by = fetch_json('/api/v1/targeting').fetch('registration_by')
    assert_equal ['HTTP', anna.page, 'page of anna'], by.values_at('source', 'peer', 'name')
    wait_until('it grows older') { fetch_json('/api/v1/targeting').dig('registration_by', 'age_s') > by['age_s'] }
    assert_described '/api/v1/targeting', 'GET', get('/api/v1/targeting')
    assert_nil fetch_json('/api/v1/targeting')['target_by']
  end

  PROBE = %w[treatment_to_tip robot_to_entry cannula_to_treatment robot_to_treatment].freeze

  def probe
    fetch_json('/api/v1/targeting').fetch('probe').map { |one| one.values_at('name', 'length_mm') }
  end

  def named(lengths)
    PROBE.zip(lengths).reject { |_, length| length.nil? }.map { |name, length| { name: name, length_mm: length } }
  end

  def send_probe(page, lengths)
    page.act('targeting/probe', { lengths: named(lengths) })
  end

  def test_SWR_PROBE_008_another_probe_is_taken_shown_and_reported_and_what_none_has_is_refused
    anna = holder
    in_targeting(anna)
    anna.act('targeting/entry', { point_mm: [0, 246, 50] })
    assert_answer '200', 'done', anna.act('targeting/target', { point_mm: [0, 200, 50] })
    assert_answer '200', 'done', send_probe(anna, [12.5, 6, 7, 46])
    assert_described '/api/v1/targeting/probe', 'POST', anna.last
    assert_equal PROBE.zip([12.5, 6, 7, 46]), probe
    assert_equal [nil, nil], fetch_json('/api/v1/targeting').values_at('target', 'entry_mm')
    reported = assert_answer '422', 'OUT_OF_RANGE', send_probe(anna, [12.5, 6, 60.5, 46])
    assert_equal '/lengths/2/length_mm', reported['pointer']
    assert_answer '409', 'PROBE_ORDER', send_probe(anna, [10, 42, 5, 41])
    assert_answer '409', 'PROBE_LENGTH', send_probe(anna, [10, 5, 5])
    assert_equal PROBE.zip([12.5, 6, 7, 46]), probe
    assert_answer '200', 'done', send_probe(anna, [10, 5, 5, 41])
  end

  def test_SWR_PROBE_010_lengths_count_by_name_and_never_by_their_order
    anna = holder
    in_targeting(anna)
    turned = named([10, 5, 6, 41]).reverse
    assert_answer '200', 'done', anna.act('targeting/probe', { lengths: turned })
    assert_equal PROBE.zip([10, 5, 6, 41]), probe
    twice = [*named([10, 5, 5]), { name: PROBE.first, length_mm: 10 }]
    assert_equal '/lengths/3/name', assert_answer('422', 'OUT_OF_RANGE', anna.act('targeting/probe', { lengths: twice }))['pointer']
    foreign = [{ name: 'needle_tip', length_mm: 200 }]
    assert_equal '/lengths/0/name', assert_answer('422', 'OUT_OF_RANGE', anna.act('targeting/probe', { lengths: foreign }))['pointer']
    reported = assert_answer '400', 'BAD_BODY', anna.act('targeting/probe', { lengths_mm: [10, 5, 5, 41] })
    assert_equal ['/lengths_mm', 'Nothing of this name is expected. Expected are id, lengths.'],
                 reported.values_at('pointer', 'detail')
    assert_equal PROBE.zip([10, 5, 6, 41]), probe
  end

  def test_SWR_PLAN_023_a_registration_says_whether_its_rotation_counts
    anna = holder
    in_targeting(anna)
    anna.act('workphase', { workphase: 'CALIBRATION' })
    turned = [0, -1, 0, 7, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
    assert_answer '200', 'done', anna.act('targeting/registration', { matrix: turned, ignore_rotation: true })
    reported = fetch_json('/api/v1/targeting')
    assert_equal [true, [1, 0, 0, 7]], [reported['ignores_registration_rotation'], reported['registration'].first(4)]
    assert fetch_json('/api/v1/status')['ignores_registration_rotation']
    assert_answer '200', 'done', anna.act('targeting/registration', { matrix: turned })
    reported = fetch_json('/api/v1/targeting')
    assert_equal [false, turned], [reported['ignores_registration_rotation'], reported['registration']]
  end

  def test_SWR_HTTP_033_a_preview_needs_no_authority_and_changes_nothing
    anna = holder
    in_targeting(anna)
    anna.act('targeting/entry', { point_mm: [0, 246, 50] })
    olga = client('olga')
    before = fetch_json('/api/v1/targeting').slice('registration', 'entry_mm', 'target')
    reported = JSON.parse(preview(olga, { point_mm: [0, 200, 50] }).body)
    assert_equal [true, 'OK', nil], reported.values_at('is_reachable', 'code', 'limit')
    far = preview(olga, { matrix: [-1, 0, 0, 0, 0, 0, -1, 200, 0, -1, 0, 900, 0, 0, 0, 1] })
    assert_equal false, JSON.parse(far.body)['is_reachable'], far.body
    assert_described '/api/v1/targeting/preview', 'POST', far
    assert_equal before, fetch_json('/api/v1/targeting').slice('registration', 'entry_mm', 'target')
    assert_nil before.fetch('target')
  end

  def test_SWR_HTTP_030_emergency_is_everyones_at_both_ports
    holder
    [port, stop_port].each do |at|
      response = post('/api/v1/stop', '{"emergency":true}', {}, at:)
      assert_equal ['200', 'EMERGENCY'], [response.code, JSON.parse(response.body)['workphase']]
      assert_described '/api/v1/stop', 'POST', response
      assert_equal 'STOP', JSON.parse(post('/api/v1/stop', '{"emergency":false}', {}, at:).body)['workphase']
      refused = post('/api/v1/stop', '{"emergency":true}', { 'Origin' => 'http://evil.example' }, at:)
      assert_equal %w[403 ORIGIN_REFUSED], [refused.code, JSON.parse(refused.body)['code']]
      assert_equal 'STOP', workphase
      assert_equal '400', post('/api/v1/stop', '{"emergency":1}', {}, at:).code
    end
  end
end
