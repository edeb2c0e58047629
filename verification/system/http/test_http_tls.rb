# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: over TLS, which stunnel ends with the configuration that is written for it, the console and the stop are
# reached by the configured names alone, nothing is shown without a session, and no cookie leaves TLS.

require 'openssl'
require 'tempfile'
require_relative '../support/http_client'
require_relative '../support/session_client'

# A certificate by an authority of our own, the file of TLS, and stunnel.
class TlsFront
  HOST = 'robot.example'

  attr_reader :file, :console, :stop, :console_from, :stop_from, :authority_hash

  def initialize(folder)
    @folder = folder
    @console, @stop, @console_from, @stop_from = Boresight.free_ports(4)
    @file = File.join(folder, 'tls')
    write_certificate
    File.write(@file, "hosts = #{HOST}, localhost\nconsole = #{console}\nstop = #{stop}\nconsole-from = #{console_from}\n" \
                      "stop-from = #{stop_from}\ncertificate = #{path('certificate')}\nkey = #{path('key')}\n")
  end

  def start
    text, status = Open3.capture2e(Boresight.program('boresight-http'), '--tls-file', file, '--stunnel')
    raise text unless status.success?

    File.write(path('stunnel.conf'), text)
    @pid = Process.spawn('stunnel', path('stunnel.conf'), %i[out err] => path('stunnel.log'))
  end

  def close
    Process.kill('TERM', @pid) if @pid
    Process.wait(@pid) if @pid
    FileUtils.rm_rf(@folder)
  end

  # A connection over TLS; who connects knows our authority alone.
  def connect(port)
    context = OpenSSL::SSL::SSLContext.new
    context.ca_file = path('authority')
    context.verify_mode = OpenSSL::SSL::VERIFY_PEER
    socket = OpenSSL::SSL::SSLSocket.new(TCPSocket.new('127.0.0.1', port), context)
    socket.sync_close = true
    socket.hostname = HOST
    socket.connect
  end

  # Sends bytes and returns all that comes back; the other end does not say farewell as TLS would have it.
  def exchange(port, bytes)
    socket = connect(port)
    socket.write(bytes)
    TlsFront.read_all(socket)
  ensure
    socket&.close
  end

  def self.read_all(socket)
    text = +''
    loop { text << socket.readpartial(65_536) }
  rescue EOFError, OpenSSL::SSL::SSLError, Errno::ECONNRESET
    text
  end

  private

  def path(name)
    File.join(@folder, name)
  end

  def write_certificate
    authority = certify("/CN=Authority of #{HOST}", 'basicConstraints' => 'critical,CA:TRUE')
    own = certify("/CN=#{HOST}", { 'subjectAltName' => "DNS:#{HOST}" }, authority)
    @authority_hash = OpenSSL::Digest.base64digest('SHA256', authority.key.public_to_der)
    File.write(path('authority'), authority.certificate.to_pem)
    File.write(path('certificate'), own.certificate.to_pem + authority.certificate.to_pem)
    File.write(path('key'), own.key.to_pem, perm: 0o600)
  end

  Certified = Struct.new(:certificate, :key)

  # A key and its certificate, signed by `authority`, or by itself.
  def certify(name, extensions, authority = nil)
    key = OpenSSL::PKey::EC.generate('prime256v1')
    certificate = OpenSSL::X509::Certificate.new
    certificate.version = 2
    certificate.serial = authority ? 2 : 1
    certificate.subject = OpenSSL::X509::Name.parse(name)
    certificate.issuer = authority ? authority.certificate.subject : certificate.subject
    certificate.public_key = key
    certificate.not_before = Time.now - 3600
    certificate.not_after = Time.now + 86_400
    factory = OpenSSL::X509::ExtensionFactory.new
    extensions.each { |its_name, value| certificate.add_extension(factory.create_extension(its_name, value)) }
    Certified.new(certificate.sign(authority&.key || key, OpenSSL::Digest.new('SHA256')), key)
  end
end

class TestHttpTls < Minitest::Test
  include HttpClient

  # With accounts and TLS in front.
  module WithTls
    def boresight
      @boresight ||= Boresight.start(arguments: ['--accounts', accounts, '--tls-file', front.file]).tap { front.start }
    end

    def accounts
      @accounts ||= Accounts.make_for_a_while
    end

    def front
      @front ||= TlsFront.new(Dir.mktmpdir('tls')).tap { |one| Minitest.after_run { one.close } }
    end
  end
  extend WithTls

  Answer = Struct.new(:status, :head, :body) do
    def json
      JSON.parse(body)
    end
  end

  def setup
    self.class.boresight
    wait_until('stunnel answers') { ask('GET', '/api/v1/session').status == 200 rescue nil } # rubocop:disable Style/RescueModifier
  end

  def front
    self.class.front
  end

  # `headers` replace those that are sent; nil leaves one out.
  def ask(method, path, body: nil, headers: {}, at: front.console)
    all = { 'Host' => "#{TlsFront::HOST}:#{at}", 'Connection' => 'close', 'Content-Length' => body.to_s.bytesize,
            'Content-Type' => ('application/json' if body) }.merge(headers).compact
    text = front.exchange(at, "#{method} #{path} HTTP/1.1\r\n#{all.map { |pair| "#{pair.join(': ')}\r\n" }.join}\r\n#{body}")
    head, rest = text.split("\r\n\r\n", 2)
    Answer.new(head[/\AHTTP\S* (\d+)/, 1].to_i, head, rest)
  end

  def log_in
    ask('POST', '/api/v1/session', body: JSON.generate(name: 'anna', password: 'correct-horse'),
                                   headers: { 'Origin' => origin })
  end

  def origin
    "https://#{TlsFront::HOST}:#{front.console}"
  end

  def cookie_of(answer)
    answer.head[/^Set-Cookie: ([^;]*)/, 1]
  end

  def test_SWR_SESS_019_nothing_is_shown_by_tls_without_a_session
    %w[status motors targeting log events].each do |name|
      assert_equal [401, 'NO_SESSION'], [(answer = ask('GET', "/api/v1/#{name}")).status, answer.json['code']]
    end
    assert_equal 200, ask('GET', '/').status
    cookie = cookie_of(log_in)
    assert_equal 200, ask('GET', '/api/v1/status', headers: { 'Cookie' => cookie }).status
  end

  def test_SWR_SESS_012_the_cookie_of_tls_stays_there
    answer = log_in
    assert_match(/^Set-Cookie: __Host-boresight-\S+=\h{64}; Path=\/; Max-Age=\d+; HttpOnly; SameSite=Strict; Secure\r$/,
                 answer.head)
    assert_match(%r{^Set-Cookie: __Secure-boresight_device-\S+\.anna=\h{64}; Path=/api/v1/session; \S+ HttpOnly; SameSite=Strict; Secure\r$},
                 answer.head)
    plain = SessionClient.new(port)
    plain.cookie = cookie_of(answer)
    refute plain.show.fetch('is_open')
  end

  def test_SWR_SESS_019_only_the_configured_hosts_and_pages_are_served
    { { 'Host' => 'evil.example' } => 'HOST_REFUSED', { 'Host' => "127.0.0.1:#{front.console_from}" } => 'HOST_REFUSED',
      { 'Host' => "127.0.0.1:#{port}" } => 'HOST_REFUSED', { 'Origin' => "http://127.0.0.1:#{port}" } => 'ORIGIN_REFUSED',
      { 'Origin' => "http://#{TlsFront::HOST}:#{front.console}" } => 'ORIGIN_REFUSED',
      { 'Origin' => "https://evil.example:#{front.console}" } => 'ORIGIN_REFUSED' }.each do |headers, expected|
      assert_equal expected, ask('GET', '/api/v1/session', headers:).json['code'], headers
    end
    assert_equal 200, ask('GET', '/', headers: { 'Origin' => origin }).status
    assert_refused '403', 'HOST_REFUSED', get('/api/v1/status', 'Host' => "#{TlsFront::HOST}:#{front.console}")
  end

  def test_SWR_SESS_019_the_page_learns_where_to_stop_and_may_ask_there
    page = ask('GET', '/')
    assert_includes page.body, %(name="boresight-tls-stop-port" content="#{format('%05d', front.stop)}")
    assert_match(/connect-src 'self'[^;]* https:\/\/#{TlsFront::HOST}:#{front.stop}[ ;]/, page.head)
  end

  def test_SWR_SESS_019_a_stop_passes_by_tls_without_a_session
    headers = { 'Origin' => origin, 'Sec-Fetch-Site' => 'same-site' }
    [front.stop, front.console].each do |at|
      answer = ask('POST', '/api/v1/stop', body: '{}', at:, headers: at == front.stop ? headers : headers.take(1).to_h)
      assert_equal [200, 'ACCEPTED'], [answer.status, answer.json['result']]
    end
    evil = ask('POST', '/api/v1/stop', body: '{}', at: front.stop, headers: { 'Origin' => 'https://evil.example' })
    assert_equal [403, 'ORIGIN_REFUSED'], [evil.status, evil.json['code']]
  end

  def test_SWR_SESS_005_no_code_is_taken_by_tls
    answer = ask('POST', '/api/v1/session', body: '{"code":"AAAA-AAAA-AAAA"}')
    assert_equal [403, 'LOGIN_NOT_HERE'], [answer.status, answer.json['code']]
  end

  def test_SWR_SESS_321_a_code_by_tls_is_refused_as_a_code
    answer = ask('POST', '/api/v1/session', body: '{"code":"AAAA-AAAA-AAAA"}')
    assert_includes answer.json['detail'], 'a code is taken at the loopback listener alone'
    sentence = 'code: login refused from TLS 127.0.0.1: by TLS a name and password are taken, and no code.'
    wait_until('it is logged') { self.class.boresight.event_lines.any? { |line| line.end_with?(sentence) || line.include?("#{sentence} Refused before") } }
  end

  def test_SWR_SESS_019_a_stream_ends_with_its_session
    answer = log_in
    cookie = cookie_of(answer)
    token = answer.json.fetch('token')
    stream = front.connect(front.console)
    stream.write("GET /api/v1/events HTTP/1.1\r\nHost: #{TlsFront::HOST}:#{front.console}\r\nCookie: #{cookie}\r\n\r\n")
    seen = +''
    seen << stream.readpartial(1024) until seen.include?('event: hello')
    ask('DELETE', '/api/v1/session', headers: { 'Cookie' => cookie, SessionClient::TOKEN => token })
    rest = Thread.new { TlsFront.read_all(stream) }
    assert rest.join(TIMEOUT), 'the stream goes on'
  ensure
    stream&.close
  end

  def test_SWR_SESS_019_a_browser_logs_in_and_stops_over_tls
    environment = { 'BORESIGHT_URL' => "#{origin}/", 'BORESIGHT_AUTHORITY' => front.authority_hash,
                    'BORESIGHT_LOGIN' => "anna #{Accounts::PASSWORDS.fetch('anna').last}" }
    said, status = Open3.capture2e(environment, 'npx', 'vitest', 'run', '--config', 'vitest.e2e.config.ts', 'tls.e2e.ts',
                                   chdir: File.expand_path('../../../app/console', __dir__))
    assert status.success?, said
  end

  def test_SWR_SESS_023_a_port_that_stunnel_shall_feed_and_another_has_keeps_the_server_from_starting
    { 'console-from' => front.console_from, 'stop-from' => front.stop_from }.each do |key, taken|
      others = Boresight.free_ports(2)
      text = File.read(front.file)
      %w[console-from stop-from].each { |other| text.sub!(/^#{other} = .*/, "#{other} = #{other == key ? taken : others.pop}") }
      Tempfile.create('tls') do |file|
        file.write(text)
        file.close
        said, status = Open3.capture2e(Boresight.program('boresight-http'), '--instance', self.class.boresight.instance,
                                       '--recordings', self.class.boresight.recordings,
                                       '--box', 'x', '--port', others.pop.to_s, '--tls-file', file.path)
        assert_equal 3, status.exitstatus
        assert_includes said, "port #{taken}, which TLS shall feed, is in use; change #{key} in the file of TLS"
      end
    end
  end

  def test_SWR_SESS_019_the_library_never_speaks_tls_itself
    %w[8443s 8443r 127.0.0.1:8443s].each do |its_port|
      _, status = Open3.capture2e(Boresight.program('boresight-http'), '--instance', self.class.boresight.instance,
                                  '--recordings', self.class.boresight.recordings,
                                  '--box', 'x', '--port', its_port)
      assert_equal 2, status.exitstatus
    end
  end
end
