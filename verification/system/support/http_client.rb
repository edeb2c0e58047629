# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'json'
require 'net/http'
require 'socket'
require_relative 'system_test'

# Common parts of the tests: requests, raw bytes, and waits with a deadline.
module HttpClient
  TIMEOUT = Boresight::TIMEOUT_SECONDS
  SAFETY_HEADERS = %w[Content-Security-Policy X-Content-Type-Options X-Frame-Options Referrer-Policy
                      Cache-Control].freeze

  STREAMS = 8
  ESTABLISHED = '01'
  LISTENING = '0A'

  def self.included(test)
    test.extend(OneForAll)
  end

  # One running system serves all tests of a file.
  module OneForAll
    def boresight
      @boresight ||= Boresight.start(arguments: ['--robot', robot])
    end

    # A file that homes and can do with the smaller robot says so: it homes in a quarter of the time.
    def robot
      'neuro'
    end
  end

  def setup
    wait_until('http answers') { get('/api/v1/status').is_a?(Net::HTTPOK) }
  end

  def port
    self.class.boresight.http_port
  end

  def host
    "127.0.0.1:#{port}"
  end

  def get(path, headers = {})
    request(Net::HTTP::Get.new(path, headers))
  end

  def post(path, body, headers = {}, at: port)
    request(Net::HTTP::Post.new(path, headers).tap { |message| message.body = body }, at:)
  end

  def request(message, at: port)
    Net::HTTP.start('127.0.0.1', at, open_timeout: TIMEOUT, read_timeout: TIMEOUT) { |http| http.request(message) }
  end

  def stop_port
    self.class.boresight.stop_port
  end

  # Yields while `count` clients have sent half a request each.
  def with_slow_clients(count, at)
    slow = Array.new(count) do
      TCPSocket.new('127.0.0.1', at).tap { |socket| socket.write("POST /api/v1/stop HTTP/1.1\r\nHost: ") }
    end
    yield
  ensure
    slow&.each(&:close)
  end

  def fetch_json(path)
    response = get(path)
    assert_equal '200', response.code, response.body
    JSON.parse(response.body)
  end

  def assert_refused(code, word, response)
    assert_equal [code, word], [response.code, JSON.parse(response.body).fetch('code')]
    SAFETY_HEADERS.each { |header| refute_nil response[header], "#{header} is missing" }
  end

  # Sends bytes as they are and returns what comes back until the server closes.
  def send_raw(bytes, at: port)
    TCPSocket.open('127.0.0.1', at) do |socket|
      socket.write(bytes)
      read_until_closed(socket)
    end
  end

  def read_until_closed(socket)
    answer = +''
    answer << socket.readpartial(65_536) while socket.wait_readable(TIMEOUT)
    flunk "the server did not close within #{TIMEOUT} s"
  rescue EOFError, Errno::ECONNRESET, Errno::EPIPE
    answer
  end

  # A stream that was accepted; one closed just before may still have its place for some frames.
  def open_stream
    stream = nil
    wait_until('a stream is accepted') do
      stream&.close
      stream = EventStream.new(port)
      stream.status == '200'
    end
    stream
  end

  def wait_until(reason, &)
    self.assertions += 1
    Boresight.wait_until(reason, &)
  end

  # A stream that reads the first line of the answer and no more. Its kernel keeps `bytes` for it, by default few.
  def open_lazy_stream(bytes = 4096)
    lazy = nil
    wait_until('a stream is accepted') do
      lazy&.close
      lazy = Socket.new(:INET, :STREAM)
      lazy.setsockopt(:SOCKET, :RCVBUF, bytes) if bytes
      lazy.connect(Addrinfo.tcp('127.0.0.1', port))
      lazy.write("GET /api/v1/events HTTP/1.1\r\nHost: #{host}\r\n\r\n")
      lazy.gets.start_with?('HTTP/1.1 200')
    end
    lazy
  end

  # The server's end is the one to look at: what it has sent still stands before its farewell.
  def dropped?(socket)
    its_port = socket.local_address.ip_port
    sockets.none? { |state, here, there| state == ESTABLISHED && here.last == port && there.last == its_port }
  end

  # [state, [address, port], [address, port]] of every IPv4 socket of this machine.
  def sockets
    File.readlines('/proc/net/tcp').drop(1).map(&:split).map do |row|
      [row[3], endpoint(row[1]), endpoint(row[2])]
    end
  end

  def endpoint(text)
    address, its_port = text.split(':')
    [address.scan(/../).map { |byte| byte.to_i(16) }.reverse.join('.'), its_port.to_i(16)]
  end
end

# A client of the stream.
class EventStream
  attr_reader :status

  def initialize(port, headers = {})
    @socket = TCPSocket.new('127.0.0.1', port)
    lines = headers.map { |name, value| "#{name}: #{value}\r\n" }.join
    @socket.write("GET /api/v1/events HTTP/1.1\r\nHost: 127.0.0.1:#{port}\r\n#{lines}\r\n")
    @buffer = +''
    @status = head[/\A\S+ (\d+)/, 1]
  end

  # The next message as [event, data]; comments are skipped.
  def next_message
    loop do
      text = take("\n\n")
      event = text[/^event: (.*)$/, 1]
      return [event, JSON.parse(text[/^data: (.*)$/, 1])] if event
    end
  end

  def next_of(event)
    loop do
      name, data = next_message
      return data if name == event
    end
  end

  def close
    @socket.close
  end

  private

  def head
    take("\r\n\r\n")
  end

  def take(separator)
    until (text = @buffer.slice!(/\A.*?#{separator}/m))
      raise 'nothing came' unless @socket.wait_readable(Boresight::TIMEOUT_SECONDS)

      @buffer << @socket.readpartial(65_536)
    end
    text
  end
end
