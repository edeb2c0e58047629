# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: no client can keep a stop from reaching control, and the port that is there for it is good for nothing
# else. How long a stop takes is judged in punctual/.

require_relative '../support/http_client'

class TestHttpStop < Minitest::Test
  include HttpClient

  THREADS = 20
  EACH = 50
  SLOW = 600
  LAZY_STATES = 300 # lazy_states
  FLOOD = 20_000_000 # bytes

  def stop_code(at = port, headers = {})
    post('/api/v1/stop', '{}', headers, at:).code
  end

  def codes_of_many(at)
    threads = Array.new(THREADS) { Thread.new { Array.new(EACH) { stop_code(at) } } }
    threads.flat_map(&:value).tally
  end

  def stop_head(headers = {}, line: 'POST /api/v1/stop HTTP/1.1')
    fields = { 'Host' => "127.0.0.1:#{stop_port}", 'Content-Length' => '2' }.merge(headers).compact
    "#{line}\r\n#{fields.map { |name, value| "#{name}: #{value}\r\n" }.join}\r\n"
  end

  def assert_stop_port_refuses(status, code, bytes)
    answer = send_raw(bytes, at: stop_port)
    assert_match(/\AHTTP\S* #{status} .*"code":"#{code}"/m, answer)
    refute_match(/Access-Control-Allow-Origin/i, answer)
  end

  def test_SWR_HTTP_008_each_of_a_thousand_stops_of_twenty_clients_is_accepted
    assert_equal({ '200' => THREADS * EACH }, codes_of_many(port))
  end

  def test_SWR_HTTP_008_each_of_a_thousand_stops_at_their_own_port_is_accepted
    assert_equal({ '200' => THREADS * EACH }, codes_of_many(stop_port))
  end

  def test_SWR_HTTP_008_a_stop_reports_what_control_did
    response = post('/api/v1/stop', '', {}, at: stop_port)
    assert_equal %w[ACCEPTED STOP], JSON.parse(response.body).values_at('result', 'workphase')
    assert_equal 'STOP', fetch_json('/api/v1/status').dig('workphase', 'name')
  end

  def test_SWR_HTTP_008_a_stop_says_when_control_does_not_answer
    self.class.boresight.while_stopped('control') do
      response = post('/api/v1/stop', '', {}, at: stop_port)
      assert_equal %w[503 NO_ANSWER], [response.code, JSON.parse(response.body)['code']]
    end
    wait_until('control goes on') { stop_code == '200' }
  end

  def test_SWR_HTTP_007_a_stop_leaves_while_slow_clients_hold_the_port_of_the_console
    with_slow_clients(SLOW, port) { assert_equal '200', stop_code(stop_port) }
  end

  def test_SWR_HTTP_007_a_stop_leaves_while_slow_clients_hold_its_own_port
    with_slow_clients(SLOW, stop_port) { assert_equal '200', stop_code(stop_port) }
  end

  def test_SWR_HTTP_007_a_stop_leaves_while_every_stream_is_taken
    streams = Array.new(STREAMS) { open_stream }
    assert_equal '200', stop_code(stop_port)
  ensure
    streams&.each(&:close)
  end

  def test_SWR_HTTP_007_the_port_stays_the_same_when_the_server_starts_again
    before = stop_port
    server = self.class.boresight.pid_of('http')
    Process.kill('KILL', server)
    wait_until('the server runs again') do
      self.class.boresight.patiently { get('/api/v1/status').is_a?(Net::HTTPOK) } &&
        ![nil, server].include?(self.class.boresight.pid_of('http'))
    end
    assert_equal before, stop_port
    assert_equal '200', stop_code(stop_port)
  end

  # The supervisor is held, so that it does not start the server before its port is taken.
  def test_SWR_HTTP_007_a_port_that_another_program_has_taken_is_replaced_and_the_new_one_kept
    before = stop_port
    other = with_server_killed { TCPServer.new('127.0.0.1', before) }
    after = stop_port
    refute_equal before, after
    assert_equal '200', stop_code(after)
    other.close
    with_server_killed { nil }
    assert_equal after, stop_port
  ensure
    other&.close unless other&.closed?
  end

  def with_server_killed
    server = self.class.boresight.pid_of('http')
    Process.kill('STOP', self.class.boresight.pid)
    Process.kill('KILL', server)
    wait_until('nobody listens') { sockets.none? { |state, here, _| state == LISTENING && here.last == port } }
    yield
  ensure
    Process.kill('CONT', self.class.boresight.pid)
    wait_until('the server runs again') { self.class.boresight.patiently { get('/api/v1/status').is_a?(Net::HTTPOK) } }
  end

  # Control does not answer meanwhile, so it is still waiting when those come that want its place.
  def test_SWR_HTTP_007_who_waits_for_an_answer_keeps_its_place
    answer = self.class.boresight.while_stopped('control') do
      TCPSocket.open('127.0.0.1', stop_port) do |socket|
        socket.write("#{stop_head}{}")
        with_slow_clients(SLOW, stop_port) { read_until_closed(socket) }
      end
    end
    assert_match(/\AHTTP\S* 503 .*"code":"NO_ANSWER"/m, answer)
    wait_until('control goes on') { stop_code == '200' }
  end

  def test_SWR_HTTP_007_who_does_not_finish_or_does_not_go_is_dismissed
    half = TCPSocket.new('127.0.0.1', stop_port).tap { |socket| socket.write('POST') }
    answered = TCPSocket.new('127.0.0.1', stop_port).tap { |socket| socket.write("#{stop_head}{}") }
    assert_match(/\AHTTP\S* 200 /, answered.read)
    assert_empty half.read
    wait_until('what is sent is read no more') { deaf?(answered) }
  ensure
    [half, answered].each(&:close)
  end

  def deaf?(socket)
    socket.write('x')
    false
  rescue Errno::EPIPE, Errno::ECONNRESET
    true
  end

  # More than the kernels of both ends keep: who is closed at once after his answer cannot send it all.
  def test_SWR_HTTP_009_who_sends_more_than_is_read_hears_why_it_is_refused
    socket = TCPSocket.new('127.0.0.1', stop_port)
    socket.write("#{stop_head({ 'Content-Length' => FLOOD.to_s })}#{'x' * FLOOD}")
    assert_match(/\AHTTP\S* 413 /, socket.read)
  ensure
    socket&.close
  end

  def test_SWR_HTTP_007_the_page_may_use_the_port_and_no_other
    policy = get('/')['Content-Security-Policy']
    assert_includes policy, "connect-src 'self' http://127.0.0.1:#{stop_port} http://127.0.0.1:#{stop_port} " \
                            "http://localhost:#{stop_port};"
  end

  def test_SWR_HTTP_007_it_listens_where_the_console_does
    listening = sockets.select { |state, here, _| state == LISTENING && here.last == stop_port }
    assert_equal(['127.0.0.1'], listening.map { |_, here, _| here.first })
  end

  def test_SWR_HTTP_009_the_page_of_the_console_may_read_the_answer
    origin = "http://127.0.0.1:#{port}"
    response = post('/api/v1/stop', '{}', { 'Origin' => origin, 'Sec-Fetch-Site' => 'same-site' }, at: stop_port)
    assert_equal ['200', origin], [response.code, response['Access-Control-Allow-Origin']]
    assert_nil post('/api/v1/stop', '{}', {}, at: stop_port)['Access-Control-Allow-Origin']
  end

  def test_SWR_HTTP_009_pages_from_elsewhere_are_refused
    ['http://evil.example', 'null', "http://127.0.0.1:#{stop_port}", "https://127.0.0.1:#{port}",
     "http://127.0.0.1:#{port}.evil.example", "http://127.0.0.1:#{port + 1}", ''].each do |origin|
      assert_stop_port_refuses 403, 'ORIGIN_REFUSED', "#{stop_head({ 'Origin' => origin })}{}"
    end
    assert_stop_port_refuses 403, 'ORIGIN_REFUSED', "#{stop_head({ 'Sec-Fetch-Site' => 'cross-site' })}{}"
    assert_stop_port_refuses 403, 'HOST_REFUSED', "#{stop_head({ 'Host' => "127.0.0.1:#{port}" })}{}"
    assert_stop_port_refuses 403, 'HOST_REFUSED', "#{stop_head({ 'Host' => "evil.example:#{stop_port}" })}{}"
    assert_stop_port_refuses 400, 'HOST_MISSING', "#{stop_head({ 'Host' => nil })}{}"
  end

  def test_SWR_HTTP_009_everything_but_a_stop_is_refused
    assert_stop_port_refuses 405, 'METHOD_NOT_ALLOWED', stop_head(line: 'GET /api/v1/stop HTTP/1.1')
    assert_stop_port_refuses 405, 'METHOD_NOT_ALLOWED', stop_head(line: 'OPTIONS /api/v1/stop HTTP/1.1')
    ['/', '/api/v1/status', '/api/v1/stop/', '/api/v1/stop?x', '/api/v1/events', '*'].each do |path|
      assert_stop_port_refuses 404, 'NOT_FOUND', stop_head(line: "POST #{path} HTTP/1.1")
    end
    ['POST', 'POST /api/v1/stop', 'POST /api/v1/stop HTTP/2.0', "POST  /api/v1/stop HTTP/1.1\r\n x", "\0"].each do |line|
      assert_stop_port_refuses 400, 'BAD_REQUEST', stop_head(line:)
    end
  end

  def test_SWR_HTTP_009_headers_that_can_be_read_in_two_ways_are_refused
    ["Host: 127.0.0.1:#{stop_port}", 'Content-Length: 0', ' folded: x', 'a b: x', 'nothing', "nul: \0"].each do |line|
      bytes = stop_head.sub("\r\n\r\n", "\r\n#{line}\r\n\r\n")
      assert_stop_port_refuses 400, 'BAD_REQUEST', "#{bytes}{}"
    end
    assert_stop_port_refuses 431, 'TOO_MANY_HEADERS', stop_head({ 'X-Long' => 'a' * 5000 })
  end

  def test_SWR_HTTP_009_bodies_must_be_short_announced_and_empty
    [nil, '', '-2', '0x2', '2 2'].each do |length|
      assert_stop_port_refuses 411, 'LENGTH_REQUIRED', stop_head({ 'Content-Length' => length })
    end
    assert_stop_port_refuses 411, 'LENGTH_REQUIRED', stop_head({ 'Transfer-Encoding' => 'chunked' })
    assert_stop_port_refuses 413, 'BODY_TOO_LONG', stop_head({ 'Content-Length' => '257' })
    assert_stop_port_refuses 413, 'BODY_TOO_LONG', stop_head({ 'Content-Length' => '99999999999999999999' })
    assert_stop_port_refuses 400, 'BAD_BODY', "#{stop_head}[]"
  end

  def test_SWR_HTTP_009_garbage_is_survived
    random = Random.new(20_262)
    30.times { send_raw("#{random.bytes(random.rand(1..6000))}\r\n\r\n", at: stop_port) }
    assert_equal '200', stop_code(stop_port)
  end

  def test_SWR_HTTP_009_a_request_in_pieces_is_read
    answer = TCPSocket.open('127.0.0.1', stop_port) do |socket|
      socket.setsockopt(:TCP, :NODELAY, 1)
      "#{stop_head}{}".each_char { |byte| socket.write(byte) }
      read_until_closed(socket)
    end
    assert_match(/\AHTTP\S* 200 /, answer)
  end

  # Sends `head`, and `body` once it is asked for. Returns what came before the body, and behind it.
  def ask_first(head, body, at:)
    TCPSocket.open('127.0.0.1', at) do |socket|
      socket.write(head)
      first = +''
      first << socket.readpartial(4096) until first.end_with?("\r\n\r\n")
      socket.write(body)
      [first, read_until_closed(socket)]
    end
  end

  GO_ON = "HTTP/1.1 100 Continue\r\n\r\n"

  def test_SWR_HTTP_059_a_stop_that_waits_for_its_turn_is_asked_to_go_on_and_answered
    { '{}' => 'STOP', '{"emergency":true}' => 'EMERGENCY' }.each do |body, workphase|
      [port, stop_port].each do |at|
        head = stop_head({ 'Host' => "127.0.0.1:#{at}", 'Content-Length' => body.size.to_s, 'Expect' => '100-Continue',
                           'Content-Type' => 'application/json' })
        first, answer = ask_first(head, body, at:)
        assert_equal GO_ON, first
        assert_match(/\AHTTP\S* 200 .*"workphase":"#{workphase}"/m, answer)
      end
    end
  end

  # A fault known from the head is answered at once.
  def test_SWR_HTTP_059_a_stop_without_a_body_or_with_one_that_is_refused_is_answered_at_once
    { '0' => 200, '300' => 413 }.each do |length, status|
      answer = send_raw(stop_head({ 'Content-Length' => length, 'Expect' => '100-continue' }), at: stop_port)
      assert_match(/\AHTTP\S* #{status} /, answer)
    end
    head = stop_head({ 'Host' => host, 'Content-Length' => '0', 'Expect' => '100-continue' })
    assert_match(/\AHTTP\S* 200 /, send_raw(head))
  end

  def test_SWR_HTTP_059_other_requests_are_asked_to_go_on_as_well
    head = "POST /api/v1/session HTTP/1.1\r\nHost: #{host}\r\nContent-Type: application/json\r\nContent-Length: 2\r\n" \
           "Expect: 100-continue\r\n\r\n"
    first, answer = ask_first(head, '[]', at: port)
    assert_equal GO_ON, first
    assert_match(/\AHTTP\S* 400 .*"code":"BAD_BODY"/m, answer)
  end

  def assert_obeyed(workphase, bytes, at:)
    answer = send_raw(bytes, at:)
    assert_match(/\AHTTP\S* 200 .*"workphase":"#{workphase}"/m, answer)
    assert_equal 1, answer.scan('HTTP/1.1').size, answer
  end

  # The answer ends the connection, so a client knows that nothing behind its stop was looked at.
  def test_SWR_HTTP_076_a_stop_is_obeyed_and_answered_once_whatever_comes_behind_it
    [port, stop_port].each do |at|
      head = stop_head({ 'Host' => "127.0.0.1:#{at}" })
      ["#{head}{}", head, "GET / HTTP/1.1\r\nHost: x\r\n\r\n", '{}', "\r\n", "\0\xff", 'x' * 100_000].each do |behind|
        assert_obeyed 'STOP', "#{head}{}#{behind}", at:
      end
      emergency = '{"emergency":true}'
      long = stop_head({ 'Host' => "127.0.0.1:#{at}", 'Content-Length' => emergency.size.to_s })
      assert_obeyed 'EMERGENCY', "#{long}#{emergency}#{head}{}", at:
    end
  end

  def test_SWR_HTTP_077_a_repeated_expectation_is_one
    [port, stop_port].each do |at|
      head = stop_head({ 'Host' => "127.0.0.1:#{at}", 'Expect' => "100-continue\r\nExpect: 100-continue" })
      first, answer = ask_first(head, '{}', at:)
      assert_equal GO_ON, first
      assert_match(/\AHTTP\S* 200 /, answer)
      assert_obeyed 'STOP', head.sub('Content-Length: 2', 'Content-Length: 0'), at:
    end
  end

  # A server that would ask for the body does so at once: its silence lasts until it loses patience.
  def test_SWR_HTTP_077_a_client_of_http_1_0_is_not_reported_to_go_on
    [port, stop_port].each do |at|
      head = stop_head({ 'Host' => "127.0.0.1:#{at}", 'Expect' => '100-continue' }, line: 'POST /api/v1/stop HTTP/1.0')
      refute_includes send_raw(head, at:), '100 Continue'
      assert_obeyed 'STOP', "#{head}{}", at:
    end
    head = "POST /api/v1/session HTTP/1.0\r\nHost: #{host}\r\nContent-Type: application/json\r\nContent-Length: 2\r\n" \
           "Expect: 100-continue\r\n\r\n"
    assert_match(/\AHTTP\S* 400 .*"code":"BAD_BODY"/m, send_raw("#{head}[]"))
  end

  def test_SWR_HTTP_010_clients_that_read_nothing_lose_their_places
    neighbour = open_stream
    lazy = Array.new(STREAMS - 1) { |number| open_lazy_stream(number.even? ? nil : 4096) }
    states = 0
    wait_until('they are dropped') do
      neighbour.next_of('state')
      states += 1
      lazy.all? { |socket| dropped?(socket) }
    end
    assert_operator states, :<=, LAZY_STATES
    puts "SWR-HTTP-010: #{lazy.size} clients that read nothing were dropped after #{states} states"
  ensure
    neighbour&.close
    lazy&.each(&:close)
  end
end
