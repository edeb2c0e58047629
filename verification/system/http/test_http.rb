# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the HTTP server shows everything, obeys STOP of everyone, refuses what it does not know, and no
# client can keep it from serving the others. One running system serves all tests of this file.

require 'yaml'
require_relative '../support/http_client'

class TestHttp < Minitest::Test
  include HttpClient

  AXES = %w[head feet lateral insertion rotation pitch yaw].freeze
  def test_SWR_HTTP_001_status_names_the_state_and_what_is_needed_next
    status = fetch_json('/api/v1/status')
    assert_kind_of String, status.dig('workphase', 'name')
    assert_match(/\.\z/, status.dig('next_step', 'text'))
    assert_equal AXES, status.fetch('cards').map { |card| card.fetch('axis') }
    assert_equal %w[core fifo memory], status.dig('loop', 'rights').keys.sort
  end

  def test_SWR_DRIVE_014_status_reports_type_and_converters_of_every_card
    self.class.boresight.simctl('plug', '9', 'sensor')
    self.class.boresight.simctl('force', 'needle', '1234')
    card = wait_until('the card is found') { fetch_json('/api/v1/status').fetch('cards').find { |one| one['slot'] == 9 } }
    assert_equal ['sensor', nil, [0, 1970, 1234, 0]], card.values_at('type', 'axis', 'converters')
    assert_equal({ 'head' => 'non_pwm', 'insertion' => 'pwm' },
                 fetch_json('/api/v1/status').fetch('cards').to_h { |one| one.values_at('axis', 'type') }.slice('head', 'insertion'))
  ensure
    self.class.boresight.simctl('plug', '9', 'none')
    wait_until('the card is gone') { fetch_json('/api/v1/status').fetch('cards').none? { |one| one['slot'] == 9 } }
  end

  def test_SWR_SUP_005_status_says_how_fast_time_passes
    time = -> { fetch_json('/api/v1/status').fetch('time') }
    assert_equal [true, 1], time.call.values_at('is_elastic', 'slowness')
    wait_until('a second without a pause is reported') { (0.1..101.0).cover?(time.call.fetch('speed_percent')) }
  end

  def test_SWR_CON_098_the_stages_of_each_cycle_are_counted
    figures = -> { fetch_json('/api/v1/status').fetch('loop') }
    counts = ->(all) { all.fetch('stages').map { |stage| stage.fetch('counts').sum } }
    before = figures.call
    wait_until('cycles are counted') { figures.call.fetch('cycles') > before.fetch('cycles') }
    wait_until('each stage is counted') { counts.call(figures.call).zip(counts.call(before)).all? { |now, last| now > last } }
  end

  def test_SWR_CON_098_another_program_that_is_gone_is_shown_so
    running = -> { fetch_json('/api/v1/status').dig('processes', 'igtl') }
    wait_until('OpenIGTLink is there', &running)
    self.class.boresight.kill('igtl', 'STOP')
    wait_until('OpenIGTLink is gone') { !running.call }
  ensure
    self.class.boresight.kill('igtl', 'CONT')
    wait_until('OpenIGTLink is there again', &running)
  end

  def test_SWR_HTTP_001_status_is_young_while_control_runs
    first = fetch_json('/api/v1/status')
    wait_until('control goes on') { fetch_json('/api/v1/status').fetch('cycle') > first.fetch('cycle') }
    wait_until('the status is young') { fetch_json('/api/v1/status').fetch('age_ms') < 200 }
  end

  def test_SWR_HTTP_001_motors_have_a_row_for_each_axis
    axes = fetch_json('/api/v1/motors').fetch('axes')
    assert_equal(AXES, axes.map { |axis| axis.fetch('name') })
    axes.each do |axis|
      assert_includes %w[mm deg], axis.fetch('unit')
      assert_operator axis.fetch('minimum'), :<, axis.fetch('maximum')
      permit = axis.fetch('permit')
      assert_equal permit.fetch('allowed'), permit.fetch('reasons').empty?
    end
  end

  def test_SWR_HTTP_037_the_robot_is_reported_as_its_file_has_it
    file = YAML.safe_load_file(File.expand_path('../../../core/robot/neuro/robot.yml', __dir__))
    robot = fetch_json('/api/v1/robot')
    assert_match(/\A[0-9a-f]{8}\z/, robot.fetch('checksum'))
    assert_equal([file['name'], file['axes'].map { |axis| [axis['name'], axis['slot']] }],
                 [robot['name'], robot['axes'].map { |axis| axis.values_at('name', 'slot') }])
    limits = fetch_json('/api/v1/motors').fetch('axes').map { |axis| axis.values_at('name', 'unit', 'minimum', 'maximum') }
    assert_equal(limits, robot['axes'].map { |axis| axis.values_at('name', 'unit', 'minimum', 'maximum') })
  end

  def test_SWR_HTTP_006_targeting_gives_no_pose_before_the_axes_are_homed
    targeting = fetch_json('/api/v1/targeting')
    assert_equal [nil, nil, nil], targeting.values_at('zframe_treatment', 'scanner_treatment', 'distance_mm')
  end

  def test_SWR_HTTP_001_log_is_numbered_without_gaps_and_continues_after_a_number
    log = fetch_json('/api/v1/log')
    numbers = log.fetch('entries').map { |entry| entry.fetch('number') }
    assert_equal [*numbers.first..numbers.last], numbers
    rest = fetch_json("/api/v1/log?after=#{numbers.first}").fetch('entries')
    assert_equal numbers.first + 1, rest.first.fetch('number')
    assert_empty fetch_json("/api/v1/log?after=#{numbers.last + 1000}").fetch('entries')
  end

  def test_SWR_HTTP_001_the_page_and_its_parts_come_from_the_program
    page = get('/')
    assert_equal ['200', 'no-store'], [page.code, page['Cache-Control']]
    scripts = page.body.scan(%r{(?:src|href)="(/assets/[^"]+)"}).flatten
    refute_empty scripts
    scripts.each do |path|
      part = get(path)
      assert_equal '200', part.code
      assert_includes part['Cache-Control'], 'immutable'
    end
    refute_match(%r{https?://}, page.body)
  end

  def test_SWR_HTTP_001_frozen_control_is_visible_by_its_age
    control = self.class.boresight.pid_of('control')
    Process.kill('STOP', control)
    wait_until('the status is old') { fetch_json('/api/v1/status').fetch('age_ms') > 500 }
  ensure
    Process.kill('CONT', control)
    wait_until('the status is young again') { fetch_json('/api/v1/status').fetch('age_ms') < 200 }
  end

  def test_SWR_HTTP_002_stop_is_answered_by_control
    response = post('/api/v1/stop', '{}')
    assert_equal '200', response.code, response.body
    assert_equal %w[ACCEPTED STOP], JSON.parse(response.body).values_at('result', 'workphase')
    assert_equal 'STOP', fetch_json('/api/v1/status').dig('workphase', 'name')
  end

  def test_SWR_EVENT_007_the_log_says_who_commanded_the_stop
    post('/api/v1/stop', '{}')
    stop = fetch_json('/api/v1/log?text=Workphase%20entered%20STOP').fetch('entries').last
    assert_match(/ By the console\.\z/, stop.fetch('text'))
  end

  def test_SWR_HTTP_002_many_stops_at_once_are_each_answered
    codes = Array.new(6) { Thread.new { post('/api/v1/stop', '').code } }.map(&:value)
    assert_equal ['200'] * 6, codes
  end

  def test_SWR_HTTP_002_stop_says_when_control_does_not_answer
    control = self.class.boresight.pid_of('control')
    Process.kill('STOP', control)
    assert_refused '503', 'NO_ANSWER', post('/api/v1/stop', '{}')
  ensure
    Process.kill('CONT', control)
  end

  def test_SWR_HTTP_003_the_stream_greets_then_reports_the_log_and_the_state
    stream = open_stream
    hello = stream.next_message
    assert_equal 'hello', hello.first
    assert_match(/\A\h{16}\z/, hello.last.fetch('boot_id'))
    assert_kind_of Integer, stream.next_of('log').fetch('number')
    assert_equal %w[motors status targeting], stream.next_of('state').keys.sort
  ensure
    stream&.close
  end

  def test_SWR_HTTP_003_the_state_comes_again_and_again_and_is_never_older
    stream = open_stream
    cycles = Array.new(20) { stream.next_of('state').dig('status', 'cycle') }
    assert_equal cycles.sort, cycles
    wait_until('the state is newer') { stream.next_of('state').dig('status', 'cycle') > cycles.first }
  ensure
    stream&.close
  end

  def test_SWR_HTTP_003_a_change_is_reported_to_every_client
    streams = Array.new(2) { open_stream }
    streams.each { |stream| stream.next_of('state') }
    post('/api/v1/stop', '{}')
    streams.each do |stream|
      wait_until('the client is informed') { stream.next_of('state').dig('status', 'workphase', 'name') == 'STOP' }
    end
  ensure
    streams&.each(&:close)
  end

  def test_SWR_HTTP_003_one_stream_too_many_is_refused_and_a_closed_one_makes_room
    streams = Array.new(STREAMS) { open_stream }
    assert_equal '503', EventStream.new(port).status
    assert_equal '200', get('/api/v1/status').code
    streams.pop.close
    streams << open_stream
  ensure
    streams&.each(&:close)
  end

  # The kernel keeps some seconds of frames for the client before a write has to wait.
  def test_SWR_HTTP_003_a_client_that_reads_nothing_is_dropped_alone
    neighbour = open_stream
    lazy = open_lazy_stream
    wait_until('the client is dropped') do
      neighbour.next_of('state')
      dropped?(lazy)
    end
  ensure
    neighbour&.close
    lazy&.close
  end

  def test_SWR_HTTP_004_other_methods_are_refused
    put = Net::HTTP::Put.new('/api/v1/status').tap { |message| message.body = '' }
    assert_refused '405', 'METHOD_NOT_ALLOWED', request(put)
    assert_refused '405', 'METHOD_NOT_ALLOWED', request(Net::HTTP::Delete.new('/'))
    assert_refused '405', 'METHOD_NOT_ALLOWED', request(Net::HTTP::Propfind.new('/'))
    assert_refused '405', 'METHOD_NOT_ALLOWED', post('/api/v1/motors', '{}')
    response = get('/api/v1/stop')
    assert_refused '405', 'METHOD_NOT_ALLOWED', response
    assert_equal 'POST', response['Allow']
  end

  def test_SWR_HTTP_004_other_paths_are_refused
    ['/nothing', '/api/v1', '/api/v1/status/', '/../../etc/passwd', '/%2e%2e/etc/passwd', '/assets/',
     '/index.html/..'].each do |path|
      assert_refused '404', 'NOT_FOUND', get(path)
    end
  end

  def test_SWR_HTTP_004_other_hosts_are_refused
    ['evil.example', "evil.example:#{port}", "127.0.0.1:#{port + 1}", 'localhost', "localhost:#{port}.evil.example",
     "127.0.0.1:#{port}@evil.example"].each do |name|
      assert_refused '403', 'HOST_REFUSED', get('/api/v1/status', 'Host' => name)
    end
    assert_equal '200', get('/api/v1/status', 'Host' => "localhost:#{port}").code
    assert_match(/\AHTTP\S* 400 .*HOST_MISSING/m, send_raw("GET / HTTP/1.0\r\n\r\n"))
  end

  def test_SWR_HTTP_004_other_origins_are_refused
    ['http://evil.example', 'null', "https://#{host}", "http://#{host}.evil.example"].each do |origin|
      assert_refused '403', 'ORIGIN_REFUSED', post('/api/v1/stop', '{}', { 'Origin' => origin })
    end
    assert_refused '403', 'ORIGIN_REFUSED', get('/api/v1/status', 'Sec-Fetch-Site' => 'cross-site')
    assert_equal '200', post('/api/v1/stop', '{}', { 'Origin' => "http://#{host}" }).code
  end

  def test_SWR_HTTP_004_no_other_site_is_allowed_in
    response = request(Net::HTTP::Options.new('/api/v1/stop', 'Origin' => 'http://evil.example',
                                                              'Access-Control-Request-Method' => 'POST'))
    assert_refused '403', 'ORIGIN_REFUSED', response
    assert_nil get('/api/v1/status')['Access-Control-Allow-Origin']
  end

  def test_SWR_HTTP_004_bodies_must_be_short_announced_and_empty
    assert_refused '413', 'BODY_TOO_LONG', post('/api/v1/stop', 'x' * 257)
    assert_refused '400', 'BAD_BODY', post('/api/v1/stop', '{"workphase":"MANUAL"}')
    head = "POST /api/v1/stop HTTP/1.1\r\nHost: #{host}\r\n"
    assert_match(/\AHTTP\S* 411 .*LENGTH_REQUIRED/m, send_raw("#{head}\r\n"))
    assert_match(/\AHTTP\S* 411 /, send_raw("#{head}Transfer-Encoding: chunked\r\n\r\n2\r\n{}\r\n0\r\n\r\n"))
    assert_match(/\AHTTP\S* 411 /, send_raw("#{head}Content-Length: -5\r\n\r\n"))
    assert_match(/\AHTTP\S* 413 /, send_raw("#{head}Content-Length: 99999999999\r\n\r\n"))
  end

  def test_SWR_HTTP_004_numbers_in_a_query_are_numbers
    %w[abc -1 1.5 99999999999 0x10].each do |text|
      assert_refused '400', 'BAD_QUERY', get("/api/v1/log?after=#{text}")
    end
  end

  def test_SWR_HTTP_004_too_many_and_too_long_headers_are_refused
    many = Array.new(70) { |i| "X-#{i}: 1\r\n" }.join
    assert_match(/\AHTTP\S* 431 /, send_raw("GET / HTTP/1.1\r\nHost: #{host}\r\n#{many}\r\n"))
    assert_refused '431', 'TOO_MANY_HEADERS', get('/', 'X-Long' => 'a' * 9000)
  end

  def test_SWR_HTTP_004_garbage_is_survived
    random = Random.new(20_261)
    20.times { send_raw("#{random.bytes(random.rand(1..3000))}\r\n\r\n") }
    assert_equal '200', get('/api/v1/status').code
  end

  def test_SWR_HTTP_004_half_requests_are_dropped_and_do_not_block_others
    slow = Array.new(10) do
      TCPSocket.new('127.0.0.1', port).tap { |socket| socket.write("GET / HTTP/1.1\r\nHost: ") }
    end
    assert_equal '200', get('/api/v1/status').code
    slow.each { |socket| read_until_closed(socket) }
  ensure
    slow&.each(&:close)
  end

  def test_SWR_HTTP_005_nothing_listens_on_other_addresses
    listening = sockets.select { |state, here, _| state == LISTENING && here.last == port }
    assert_equal(['127.0.0.1'], listening.map { |_, here, _| here.first })
  end
end
