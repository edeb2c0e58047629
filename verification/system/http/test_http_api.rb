# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the HTTP server does what it says of itself at /api/v1/openapi.json, and speaks HTTP as clients expect.
# Bytes are sent as they are where a library would put them right.

require 'digest'
require 'stringio'
require 'zlib'
require_relative '../support/http_client'
require_relative '../support/openapi'

class TestHttpApi < Minitest::Test
  include HttpClient

  def self.robot
    'bench2'
  end

  WORKERS = 64
  GETS = %w[status motors targeting log modes].freeze

  def openapi
    @openapi ||= Openapi.new(get('/api/v1/openapi.json').body)
  end

  def assert_described(path, method, response)
    fault = openapi.fault(path.split('?').first, method, response.code, response['Content-Type'], response.body)
    assert_nil fault, "#{method} #{path}: #{fault}\n#{response.body}"
  end

  def problem(response)
    assert_equal 'application/problem+json', response['Content-Type']
    JSON.parse(response.body)
  end

  # The head and the body of one raw answer.
  def raw(bytes, at: port)
    send_raw(bytes, at:).split("\r\n\r\n", 2)
  end

  def script
    @script ||= get('/').body[%r{src="(/assets/[^"]+)"}, 1]
  end

  # A connection of its own; the block gets the socket.
  def connected
    socket = TCPSocket.new('127.0.0.1', port)
    yield socket
  ensure
    socket&.close
  end

  # Reads one answer with a length; the connection may stay open.
  def read_answer(socket)
    head = +''
    head << socket.readpartial(1) until head.end_with?("\r\n\r\n")
    [head, socket.read(head[/^Content-Length: (\d+)/, 1].to_i)]
  end

  def test_SWR_HTTP_019_each_answer_is_as_described
    GETS.each { |name| assert_described "/api/v1/#{name}", 'GET', get("/api/v1/#{name}") }
    assert_described '/api/v1/stop', 'POST', post('/api/v1/stop', '')
    assert_described '/api/v1/log?after=0', 'GET', get('/api/v1/log?after=0')
    assert_described '/api/v1/openapi.json', 'GET', get('/api/v1/openapi.json')
  end

  def test_SWR_HTTP_019_each_answer_is_as_described_when_all_is_known
    self.class.boresight.home
    GETS.each { |name| assert_described "/api/v1/#{name}", 'GET', get("/api/v1/#{name}") }
  end

  def test_SWR_HTTP_019_each_message_of_the_stream_is_as_described
    stream = open_stream
    names = openapi.paths.dig('/api/v1/events', 'get', 'x-events').transform_values { |ref| ref['$ref'].split('/').last }
    seen = []
    wait_until('all kinds of messages have come') do
      kind, data = stream.next_message
      assert_nil openapi.message_fault(names.fetch(kind), data)
      seen |= [kind]
      (names.keys - seen) == ['act'] # No client acts here.
    end
  ensure
    stream&.close
  end

  def test_SWR_HTTP_019_nothing_else_is_served_under_api
    served = openapi.paths.to_h { |path, methods| [path, methods.keys.map(&:upcase)] }
    served.each do |path, methods|
      (%w[GET HEAD POST PUT DELETE OPTIONS PATCH] - methods).each do |method|
        head, = raw("#{method} #{path} HTTP/1.1\r\nHost: #{host}\r\nContent-Length: 0\r\n\r\n")
        assert_match(/\AHTTP\S* 405 /, head)
        assert_equal methods.sort, head[/^Allow: (.*)\r$/, 1].split(', ').sort
      end
    end
  end

  def test_SWR_HTTP_019_all_schemas_refuse_what_they_do_not_name
    status = fetch_json('/api/v1/status')
    assert_nil openapi.message_fault('Status', status)
    refute_nil openapi.message_fault('Status', status.merge('surprise' => 1))
    refute_nil openapi.message_fault('Status', status.merge('cycle' => '1'))
    refute_nil openapi.message_fault('Status', status.except('workphase'))
  end

  def test_SWR_HTTP_013_every_refusal_is_a_problem_with_a_code
    { 400 => get('/api/v1/log?after=x'), 403 => get('/api/v1/status', 'Host' => 'evil.example'),
      413 => post('/api/v1/stop', 'x' * 257), 431 => get('/api/v1/status', 'X-Long' => 'a' * 9000) }.each do |status, response|
      assert_equal status.to_s, response.code
      assert_equal status, problem(response).fetch('status')
      assert_nil openapi.message_fault('Problem', problem(response))
    end
    assert_described '/api/v1/log', 'GET', get('/api/v1/log?after=x')
    assert_described '/api/v1/stop', 'POST', post('/api/v1/stop', '[')
    assert_equal ['NOT_FOUND', 'Not Found', 'about:blank'], problem(get('/no')).values_at('code', 'title', 'type')
  end

  def test_SWR_HTTP_013_a_problem_names_the_place
    found = problem(post('/api/v1/stop', "{\"a\\\"~/\u00e9\":1}"))
    assert_equal ['BAD_BODY', "/a\"~0~1\u00e9"], found.values_at('code', 'pointer')
    assert_equal %w[BAD_QUERY limits], problem(get('/api/v1/log?limits=5')).values_at('code', 'parameter')
    assert_equal %w[BAD_QUERY a], problem(get('/api/v1/status?a=1')).values_at('code', 'parameter')
    assert_equal %w[BAD_QUERY after], problem(get('/api/v1/log?after=1&after=2')).values_at('code', 'parameter')
  end

  def test_SWR_HTTP_013_the_port_for_stops_refuses_in_the_same_way
    response = post('/api/v1/stop', '{"a":1}', {}, at: stop_port)
    assert_equal %w[400 BAD_BODY /a], [response.code, *problem(response).values_at('code', 'pointer')]
    assert_described '/api/v1/stop', 'POST', response
    _, body = raw("GET / HTTP/1.1\r\nHost: 127.0.0.1:#{stop_port}\r\n\r\n", at: stop_port)
    assert_nil openapi.message_fault('Problem', JSON.parse(body))
  end

  def test_SWR_HTTP_013_control_that_does_not_answer_is_a_problem
    self.class.boresight.while_stopped('control') do
      [port, stop_port].each { |at| assert_described '/api/v1/stop', 'POST', post('/api/v1/stop', '', {}, at:) }
    end
    wait_until('control goes on') { post('/api/v1/stop', '').code == '200' }
  end

  def test_SWR_HTTP_011_a_stop_may_be_written_in_any_way_that_says_nothing
    [port, stop_port].each do |at|
      ['', '{}', '{ }', "{}\n", " \r\n{\t} "].each { |body| assert_equal '200', post('/api/v1/stop', body, {}, at:).code }
      ['[]', '{} {}', '{"a":1}', '{', 'null', ' ', "{}\0"].each do |body|
        assert_equal '400', post('/api/v1/stop', body, {}, at:).code, body.inspect
      end
      %w[text/plain application/json multipart/form-data x/y].each do |type|
        assert_equal '200', post('/api/v1/stop', '{}', { 'Content-Type' => type }, at:).code
      end
    end
    assert_equal '200', post('/api/v1/stop?x', '{}').code
  end

  def test_SWR_HTTP_012_the_end_of_all_numbers_is_no_beginning
    assert_empty fetch_json('/api/v1/log?after=4294967295').fetch('entries')
    assert_equal '400', get('/api/v1/log?after=4294967296').code
    assert_equal '400', get('/api/v1/log?after=01').code
  end

  def test_SWR_HTTP_014_head_is_get_without_the_body
    [*GETS.map { |name| "/api/v1/#{name}" }, '/', script, '/api/v1/openapi.json'].each do |path|
      head, body = raw("HEAD #{path} HTTP/1.1\r\nHost: #{host}\r\nConnection: close\r\n\r\n")
      assert_match(/\AHTTP\S* 200 /, head)
      assert_match(/^Content-Length: [1-9]/, head)
      assert_empty body.to_s
    end
    head, body = raw("HEAD /api/v1/events HTTP/1.1\r\nHost: #{host}\r\n\r\n")
    assert_match(/\AHTTP\S* 200 .*text.event-stream/m, head)
    assert_empty body.to_s
    head, body = raw("HEAD /no HTTP/1.1\r\nHost: #{host}\r\n\r\n")
    assert_match(/\AHTTP\S* 404 /, head)
    assert_empty body.to_s
  end

  def test_SWR_HTTP_014_what_the_client_has_is_not_sent_again
    ['/', script, '/api/v1/openapi.json'].each do |path|
      tag = get(path)['ETag']
      assert_match(/\A"[^"]+"\z/, tag)
      again = get(path, 'If-None-Match' => "\"other\", W/#{tag}")
      assert_equal ['304', tag, nil], [again.code, again['ETag'], again.body]
      assert_equal '200', get(path, 'If-None-Match' => '"other"').code
    end
    assert_nil get('/api/v1/status')['ETag']
  end

  def test_SWR_HTTP_014_the_answer_ends_with_its_head
    head, body = raw("HEAD #{script} HTTP/1.1\r\nHost: #{host}\r\n\r\n")
    assert_match(/\AHTTP\S* 200 /, head)
    assert_empty body
    tag = head[/^ETag: (.*)\r$/, 1]
    head, body = raw("GET #{script} HTTP/1.1\r\nHost: #{host}\r\nIf-None-Match: #{tag}\r\n\r\n")
    assert_match(/\AHTTP\S* 304 /, head)
    assert_empty body
  end

  def test_SWR_HTTP_015_files_are_packed_for_who_takes_it
    plain = get(script, 'Accept-Encoding' => 'identity')
    packed = get(script, 'Accept-Encoding' => 'br, gzip;q=0.5')
    assert_equal [nil, 'gzip'], [plain['Content-Encoding'], packed['Content-Encoding']]
    assert_equal plain.body.b, Zlib::GzipReader.new(StringIO.new(packed.body)).read.b
    assert_operator packed.body.bytesize, :<, plain.body.bytesize / 2
    assert_equal ['Accept-Encoding'] * 2, [plain['Vary'], packed['Vary']]
    refute_equal plain['ETag'], packed['ETag']
    assert_nil get(script, 'Accept-Encoding' => 'gzip;q=0')['Content-Encoding']
  end

  def test_SWR_HTTP_016_the_stream_goes_on_after_the_last_event
    3.times { post('/api/v1/stop', '') }
    numbers = fetch_json('/api/v1/log').fetch('entries').map { |entry| entry.fetch('number') }
    stream = EventStream.new(port, 'Last-Event-ID' => numbers[-3].to_s)
    assert_equal numbers[-2], stream.next_of('log').fetch('number')
    stream.close
    [numbers.last + 1000, 'x', ''].each do |other|
      stream = EventStream.new(port, 'Last-Event-ID' => other.to_s)
      assert_operator stream.next_of('log').fetch('number'), :<, numbers[-2]
      stream.close
    end
  end

  def test_SWR_HTTP_017_a_header_that_decides_stands_there_once
    ['Host: HOST', 'Origin: http://HOST', 'Content-Length: 0', 'Content-Type: text/plain'].each do |line|
      line = line.sub('HOST', host)
      head, = raw("POST /api/v1/stop HTTP/1.1\r\nHost: #{host}\r\nOrigin: http://#{host}\r\nContent-Length: 0\r\n" \
                  "Content-Type: text/plain\r\n#{line}\r\n\r\n")
      assert_match(/\AHTTP\S* 400 /, head, line)
    end
    head, = raw("POST /api/v1/stop HTTP/1.1\r\nHost: #{host}\r\nContent-Length: 2\r\nTransfer-Encoding: chunked\r\n\r\n{}")
    assert_match(/\AHTTP\S* 4\d\d /, head)
    head, = raw("GET /api/v1/status HTTP/1.1\r\nHost: #{host}\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n")
    assert_match(/\AHTTP\S* 411 /, head)
  end

  def test_SWR_HTTP_017_headers_are_few_and_short
    head = "GET /api/v1/status HTTP/1.1\r\nHost: #{host}\r\nConnection: close\r\n"
    { 61 => 200, 62 => 431, 70 => 431, 500 => 431 }.each do |count, status|
      assert_match(/\AHTTP\S* #{status} /, raw("#{head}#{'X: 1' "\r\n" * count}\r\n").first, count.to_s)
    end
    stop = "POST /api/v1/stop HTTP/1.1\r\nHost: #{host}\r\nContent-Length: 0\r\n#{'X: 1' "\r\n" * 70}\r\n"
    assert_match(/\AHTTP\S* 431 /, raw(stop).first)
    rest = 8192 - head.bytesize - "X: \r\n".bytesize
    { rest - 50 => 200, rest + 10 => 431, 60_000 => 431, 200_000 => 431 }.each do |size, status|
      assert_match(/\AHTTP\S* #{status} /, raw("#{head}X: #{'a' * size}\r\n\r\n").first, size.to_s)
    end
    assert_match(/\AHTTP\S* 431 /, raw("GET /#{'a' * 9000} HTTP/1.1\r\nHost: #{host}\r\n\r\n").first)
  end

  def test_SWR_HTTP_018_a_connection_serves_one_request
    ['', "Connection: keep-alive\r\n"].each do |wish|
      connected do |socket|
        socket.write("GET /api/v1/status HTTP/1.1\r\nHost: #{host}\r\n#{wish}\r\n" * 3)
        assert_match(/\AHTTP\S* 200 .*^Connection: close/m, read_answer(socket).first)
        assert_empty socket.read
      end
    end
  end

  # A program that uses a connection again if the answer lets it. Meanwhile half requests drive out clients that ask for nothing.
  def test_SWR_HTTP_018_a_stop_behind_another_request_is_not_lost_in_a_crowd
    socket = TCPSocket.new('127.0.0.1', port)
    socket.write("GET /api/v1/status HTTP/1.1\r\nHost: #{host}\r\n\r\n")
    is_kept = read_answer(socket).first.include?('Connection: keep-alive')
    half = Array.new(WORKERS * 4) { TCPSocket.new('127.0.0.1', port).tap { |other| other.write('GET /api') } }
    half.first(WORKERS).each(&:read)
    stop = "POST /api/v1/stop HTTP/1.1\r\nHost: #{host}\r\nContent-Length: 0\r\n\r\n"
    socket = TCPSocket.new('127.0.0.1', port) unless is_kept
    socket.write(stop)
    assert_match(/\AHTTP\S* 200 /, read_answer(socket).first)
  ensure
    [socket, *half].each(&:close)
  end
end
