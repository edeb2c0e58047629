# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: no user commands by HTTP without a session of his own, none is stolen, fixed, kept or guessed, and an
# attacker keeps no user from working and nothing from stopping.

require 'io/console'
require 'pty'
require_relative '../support/page_test'

class TestHttpSessions < Minitest::Test
  include PageTest

  PATH = SessionClient::PATH
  SESSIONS = 8

  def test_SWR_SESS_012_a_login_sets_a_cookie_that_no_script_reads_and_no_other_site_gets
    anna = client('anna')
    assert_match(/\Aboresight-#{boresight.instance}=\h{64}; Path=\/; Max-Age=43200; HttpOnly; SameSite=Strict\z/,
                 anna.last.get_fields('Set-Cookie').first)
    assert_equal [true, 'anna', 'OPERATOR', anna.token, 120, 'password'],
                 anna.show.values_at('is_open', 'name', 'role', 'token', 'warn_s', 'login')
    assert_includes 43_100..43_200, anna.show.fetch('most_s')
    assert_includes 800..900, anna.show.fetch('idle_s')
  end

  def test_SWR_SESS_012_the_answers_are_as_described
    anna = client('anna')
    { 'get' => client.request('get', PATH), 'post' => anna.last, 'put' => anna.renew,
      'delete' => anna.log_out }.each do |method, response|
      assert_equal '200', response.code
      assert_described PATH, method, response
    end
    assert_described PATH, 'post', client.log_in('anna', 'wrong')
  end

  def test_SWR_SESS_012_the_cookie_of_another_instance_is_none
    other = client('anna').dup
    other.cookie = other.cookie.sub(boresight.instance, 'other')
    assert_equal [false, 'NO_SESSION'], [other.show.fetch('is_open'), code(other.renew)]
  end

  def test_SWR_SESS_008_a_session_that_the_client_brings_is_never_taken
    mallory = client
    mallory.cookie = "boresight-#{boresight.instance}=#{'a' * 64}"
    brought = mallory.dup
    mallory.log_in('anna')
    refute_equal brought.cookie, mallory.cookie
    refute brought.show.fetch('is_open')
  end

  def test_SWR_SESS_008_another_login_ends_the_session_that_was
    anna = client('anna')
    old = anna.dup
    anna.log_in('egon')
    refute_equal old.cookie, anna.cookie
    assert_equal [false, 'ENGINEER'], [old.show.fetch('is_open'), anna.show.fetch('role')]
  end

  def test_SWR_SESS_012_two_cookies_of_one_name_are_none
    twice = client('anna').dup
    twice.cookie = "#{twice.cookie}; #{twice.cookie}"
    refute twice.show.fetch('is_open')
    head = send_raw("GET #{PATH} HTTP/1.1\r\nHost: #{host}\r\nCookie: a=1\r\nCookie: b=2\r\n\r\n")
    assert_match(/\AHTTP\S* 400 /, head)
  end

  def test_SWR_SESS_009_the_cookie_of_a_session_that_was_logged_out_is_worthless
    anna = client('anna')
    response = anna.log_out
    assert_equal '200', response.code
    assert_match(/\Aboresight-[^=]*=; Path=\/; Max-Age=0;/, response['Set-Cookie'])
    assert_equal [false, 'NO_SESSION', 'NO_SESSION'], [anna.show.fetch('is_open'), code(anna.renew), code(anna.log_out)]
  end

  def test_SWR_SESS_011_what_writes_needs_the_token_of_its_session
    anna = client('anna')
    other = client('anna')
    [nil, '', other.token, anna.token.upcase, "#{anna.token}0"].each do |token|
      assert_equal 'TOKEN_REFUSED', code(anna.renew(SessionClient::TOKEN => token)), token.inspect
    end
    assert_equal 'TOKEN_REFUSED', code(anna.log_out(SessionClient::TOKEN => nil))
    assert_equal '200', anna.renew.code
  end

  def test_SWR_SESS_011_a_stop_needs_neither_session_nor_token
    [port, stop_port].each { |at| assert_equal '200', post('/api/v1/stop', '{}', {}, at:).code }
    assert_equal 'ORIGIN_REFUSED', code(post('/api/v1/stop', '{}', { 'Origin' => 'http://evil.example' }))
  end

  def test_SWR_SESS_016_each_thing_is_judged_before_what_comes_after_it
    anna = client('anna')
    wrong = { 'Host' => 'evil.example', 'Origin' => 'http://evil.example', 'Cookie' => nil, SessionClient::TOKEN => nil }
    %w[HOST_REFUSED ORIGIN_REFUSED NO_SESSION TOKEN_REFUSED].each do |expected|
      assert_equal expected, code(anna.request('put', "#{PATH}?a=1", nil, wrong))
      wrong.shift
    end
    assert_equal 'BAD_QUERY', code(anna.request('put', "#{PATH}?a=1"))
  end

  def test_SWR_SESS_016_a_login_from_another_site_is_refused_before_it_is_looked_at
    response = client.post_login({ name: 'anna', password: 'correct-horse' }, { 'Origin' => 'http://evil.example' })
    assert_equal [%w[403 ORIGIN_REFUSED], nil], [[response.code, code(response)], response['Set-Cookie']]
    form = client.post_login({ name: 'anna', password: 'correct-horse' }, { 'Content-Type' => 'text/plain' })
    assert_equal 'MEDIA_TYPE', code(form)
  end

  def test_SWR_SESS_016_a_login_has_a_name_and_a_password_or_a_code
    { {} => '/password', { name: 'anna' } => '/password', { password: 'x' } => '/name',
      { name: 'anna', password: 'x', code: 'y' } => '/code', { name: 'anna', user: 'x' } => '/user' }.each do |body, place|
      response = client.post_login(body)
      reported = JSON.parse(response.body)
      assert_equal ['BAD_BODY', place], reported.values_at('code', 'pointer')
      assert_match(/\A(?:This is missing|Nothing of this name is expected)\./, reported['detail'])
    end
  end

  def test_SWR_SESS_017_the_loopback_listener_shows_the_state_to_everyone
    %w[status motors targeting log].each { |name| assert_equal '200', get("/api/v1/#{name}").code }
    assert_equal '200', get('/api/v1/status', 'Cookie' => "boresight-#{boresight.instance}=x").code
  end

  def test_SWR_SESS_007_the_ninth_session_is_refused_until_one_ends
    all = %w[anna egon].flat_map { |name| Array.new(SESSIONS / 2) { client(name) } }
    assert_equal '503', client.log_in('olga').code
    assert(all.all? { |one| one.show.fetch('is_open') })
    all.first.log_out
    assert_equal '200', client.log_in('anna').code
  end

  def test_SWR_SESS_022_who_is_removed_is_out
    Dir.mktmpdir do |folder|
      kept = File.join(folder, 'accounts')
      FileUtils.cp(self.class.accounts, kept, preserve: true)
      anna = client('anna')
      egon = client('egon')
      assert_passwd '', self.class.accounts, 'remove', 'anna'
      wait_until('she is out') { !anna.show.fetch('is_open') }
      assert egon.show.fetch('is_open')
    ensure
      FileUtils.cp(kept, self.class.accounts, preserve: true)
    end
  end

  def test_SWR_SESS_025_a_restart_ends_all_sessions
    anna = client('anna')
    boresight.restart_http
    assert_equal [false, 'NO_SESSION'], [anna.show.fetch('is_open'), code(anna.renew)]
  end

  def test_SWR_SESS_024_an_interrupted_question_gives_the_terminal_back
    PTY.open do |master, terminal|
      pid = Process.spawn(Boresight.program('boresight-passwd'), self.class.accounts, 'set', 'anna', 'observer',
                          in: terminal, out: terminal, err: terminal)
      wait_until('it asks') { !terminal.echo? }
      assert_equal 'New password: ', master.readpartial(100)
      Process.kill('INT', pid)
      _, status = Process.wait2(pid)
      assert_equal [Signal.list.fetch('INT'), true], [status.termsig, terminal.echo?]
    end
  end

  def test_SWR_SESS_004_accounts_are_made_changed_and_removed
    Dir.mktmpdir do |folder|
      file = File.join(folder, 'accounts')
      assert_passwd '', file, 'set', 'anna', 'operator', input: "correct-horse\n"
      assert_passwd '', file, 'set', 'bert', 'observer', input: "battery-staple\n"
      assert_passwd '', file, 'set', 'anna', 'service', input: 'another-one'
      assert_passwd "anna service\nbert observer\n", file, 'list'
      assert_passwd '', file, 'remove', 'bert'
      assert_passwd "anna service\n", file, 'list'
      assert_equal 0o600, File.stat(file).mode & 0o777
      refute_includes File.read(file), 'another-one'
    end
  end

  def test_SWR_SESS_004_a_change_that_is_refused_changes_nothing
    Dir.mktmpdir do |folder|
      file = Accounts.make(File.join(folder, 'accounts'))
      before = File.read(file)
      { [%w[set anna operator], "short\n"] => /shorter than 8 bytes/, [%w[set anna king], "correct-horse\n"] => /a role is/,
        [%w[set Anna operator], "correct-horse\n"] => /A name is/, [%w[remove nobody], ''] => /no account of this name/,
        [%w[set anna operator], "#{'x' * 200}\n"] => /longer than 128/ }.each do |(words, input), reason|
        answer, status = Accounts.passwd(file, *words, input:)
        assert_equal [1, before], [status.exitstatus, File.read(file)]
        assert_match reason, answer
      end
    end
  end

  def test_SWR_SESS_006_a_real_board_refuses_to_start_without_an_account
    Dir.mktmpdir do |folder|
      empty = File.join(folder, 'accounts')
      File.write(empty, "# nobody\n", perm: 0o600)
      [[], ['--accounts', empty]].each { |words| assert_match(/There is no account/, server_says(words)) }
    end
  end

  def test_SWR_SESS_001_a_wrong_file_keeps_the_server_from_starting
    Dir.mktmpdir do |folder|
      file = File.join(folder, 'accounts')
      File.write(file, "anna:operator:x\n", perm: 0o600)
      assert_match(/accounts, line 1: the hash must be/, server_says(['--accounts', file, '--box', 'x']))
      File.chmod(0o644, file)
      assert_match(/Others may read/, server_says(['--accounts', file, '--box', 'x']))
    end
  end

  # Output of a second server of this instance before it ends.
  def server_says(words)
    answer, status = Open3.capture2e(Boresight.program('boresight-http'), '--instance', boresight.instance,
                                     '--recordings', boresight.recordings,
                                     '--port', Boresight.free_ports(1).first.to_s, *words)
    assert_equal 3, status.exitstatus
    answer
  end

  def assert_passwd(expected, file, *words, input: '')
    answer, status = Accounts.passwd(file, *words, input:)
    assert status.success?, answer
    assert_equal expected, answer
  end
end

# Each test begins with a server that knows of no failure and has noted nothing.
class TestHttpSessionsAnew < Minitest::Test
  include PageTest

  FREE_FAILURES = 3

  def setup
    boresight.restart_http
  end

  def test_SWR_SESS_014_failures_make_the_next_login_wait
    response = nil
    wait_until('one comes too soon, however slow the machine is') do
      (FREE_FAILURES + 1).times { assert_equal %w[401 LOGIN_REFUSED], [(last = client.log_in('anna', 'x')).code, code(last)] }
      anna = client
      response = anna.log_in('anna')
      response.code != '200' || !anna.log_out
    end
    assert_equal %w[429 LOGIN_TOO_SOON 1], [response.code, code(response), response['Retry-After']]
    wait_until('a login is looked at again') { client.log_in('anna').code == '200' }
  end

  # Logs in with the mark of another client, until it is not because another login is judged.
  def log_in_marked(name, mark)
    response = nil
    wait_until('no other login is judged') do
      one = client
      one.cookie = mark
      response = one.log_in(name)
      !response.body.include?('Another login')
    end
    response
  end

  def test_SWR_SESS_032_a_browser_that_has_logged_in_before_gets_in_while_others_guess
    mark = client('anna').mark
    is_over = false
    guessers = Array.new(4) { Thread.new { client.log_in('anna', 'guess') until is_over } }
    wait_until('guessing has become slow') { client.log_in('anna', 'x').body.include?('Too many logins') }
    assert_equal '200', log_in_marked('anna', mark).code
    refute_equal '200', log_in_marked('anna', mark.tr('0-9', '1-90')).code
  ensure
    is_over = true
    guessers&.each(&:join)
  end

  def test_SWR_SESS_032_the_mark_is_a_cookie_that_no_script_reads
    assert_match(%r{\Aboresight_device-#{boresight.instance}\.anna=\h{64}; Path=/api/v1/session; Max-Age=2592000; HttpOnly; SameSite=Strict\z},
                 client('anna').last.get_fields('Set-Cookie').last)
  end

  def test_SWR_SESS_033_the_refusal_is_a_sentence_with_the_time_to_wait
    response = nil
    wait_until('one comes too soon') { (response = client.log_in('anna', 'x')).code == '429' }
    assert_equal "Too many logins failed: wait #{response['Retry-After']} s, then log in again.",
                 JSON.parse(response.body).fetch('detail')
  end

  def test_SWR_SESS_015_guessing_locks_out_no_session_and_no_stop
    anna = client('anna')
    is_over = false
    guessers = Array.new(16) do |i|
      Thread.new { client.log_in(i.even? ? 'anna' : "nobody-#{i}", 'guess') until is_over }
    end
    wait_until('guessing has become slow') { client.log_in('anna').code == '429' }
    10.times do
      assert_equal '200', anna.renew.code
      [port, stop_port].each { |at| assert_equal '200', post('/api/v1/stop', '{}', {}, at:).code }
    end
  ensure
    is_over = true
    guessers&.each(&:join)
  end

  # Notes of this server in the log, with what is said of them elsewhere: [the sentence, name, severity, cause]. One that control
  # has not logged for long is asked for again, and then there twice with its number.
  def notes
    boresight.log.select { |entry| %w[NOTE LOGIN_REFUSED].include?(entry['name']) }.uniq { |entry| entry['value'] }
             .map { |entry| entry.values_at('text', 'name', 'severity', 'cause') }
  end

  def test_SWR_SESS_020_each_login_refusal_and_logout_is_an_event
    before = notes.size
    anna = client('anna')
    client.log_in('anna', 'wrong')
    anna.log_in('egon')
    anna.log_out
    expected = [['anna: logged in as operator, by password.', 'NOTE', 'INFORMATION', 'CONSOLE'],
                ['anna: login refused from plain 127.0.0.1: name, password or code is wrong.', 'LOGIN_REFUSED', 'WARNING', 'CONSOLE'],
                ['anna: session ended: another login took its place.', 'NOTE', 'INFORMATION', 'CONSOLE'],
                ['egon: logged in as engineer, by password.', 'NOTE', 'INFORMATION', 'CONSOLE'],
                ['egon: logged out.', 'NOTE', 'INFORMATION', 'CONSOLE']]
    wait_until('all is said') { notes.size >= before + expected.size }
    assert_equal expected, notes.drop(before)
    wait_until('it is in the file') { boresight.event_lines.any? { |line| line.end_with?(' egon: logged out.') } }
  end

  def test_SWR_EVENT_010_what_a_stranger_calls_himself_is_not_written
    before = notes.size
    client.log_in("a\nroot: logged in", 'correct-horse')
    wait_until('it is said') { notes.size > before }
    assert_equal '?: login refused from plain 127.0.0.1: name, password or code is wrong.', notes.last.first
    boresight.event_lines.each { |line| refute_match(/correct-horse|root/, line) }
  end

  def test_SWR_SESS_020_a_note_that_a_stop_has_refused_comes_all_the_same
    before = notes.size
    is_over = false
    stopping = Thread.new { post('/api/v1/stop', '{}') until is_over }
    10.times { client('anna').log_out }
    expected = ['anna: logged in as operator, by password.', 'anna: logged out.'] * 10
    wait_until('all are in the log') { notes.size >= before + expected.size }
    assert_equal expected, notes.drop(before).map(&:first)
  ensure
    is_over = true
    stopping&.join
  end
end

# Without accounts.
class TestHttpFirstLogin < Minitest::Test
  include HttpClient

  def codes
    self.class.boresight.output.scan(/^Login: +([A-Z2-9-]{14}) /).flatten
  end

  def test_SWR_SESS_005_the_code_that_is_printed_opens_one_session_of_an_engineer
    count = codes.size
    self.class.boresight.restart_http
    wait_until('the code of another server is shown') { codes.size > count }
    client = SessionClient.new(port)
    assert_equal 'code', client.show.fetch('login')
    assert_equal '401', client.post_login({ code: codes.first }).code
    assert_equal '200', client.post_login({ code: codes.last }).code
    assert_equal [true, 'code', 'ENGINEER', 'none'], client.show.values_at('is_open', 'name', 'role', 'login')
    assert_equal '401', SessionClient.new(port).post_login({ code: codes.last }).code
  end

  def test_SWR_SESS_005_there_is_no_password
    %w[admin root engineer code boresight].each_with_index do |name, i|
      assert_includes %w[401 429], SessionClient.new(port).post_login({ name: name, password: ['', name][i % 2] }).code
    end
  end
end

# Beyond the loopback address.
class TestHttpBeyondLoopback < Minitest::Test
  include HttpClient

  def self.boresight
    @boresight ||= Boresight.new(arguments: ['--bind', '0.0.0.0']).tap do |one|
      one.launch
      one.wait_until('it has started') { one.output.include?('Console:') }
    end
  end

  def setup
    wait_until('http answers') { get('/api/v1/session').is_a?(Net::HTTPOK) }
  end

  def test_SWR_SESS_018_no_password_and_no_code_is_taken_in_the_clear
    client = SessionClient.new(port)
    assert_equal 'none', client.show.fetch('login')
    code = self.class.boresight.output[/^Login: +([A-Z2-9-]{14}) /, 1]
    [{ code: code }, { name: 'anna', password: 'x' }].each do |body|
      response = client.post_login(body)
      assert_equal %w[403 LOGIN_NOT_HERE], [response.code, JSON.parse(response.body)['code']]
    end
  end

  def test_SWR_SESS_321_a_refusal_in_the_clear_says_where_a_login_is_taken
    answer = JSON.parse(SessionClient.new(port).post_login({ name: 'anna', password: 'correct-horse' }).body)
    assert_includes answer['detail'], 'a password there or over TLS'
  end

  def test_SWR_SESS_300_a_login_that_is_taken_nowhere_here_is_logged
    SessionClient.new(port).post_login({ name: 'anna', password: 'correct-horse' })
    sentence = 'anna: login refused from plain 127.0.0.1: no login is taken in the clear but at the loopback listener.'
    wait_until('it is logged') { self.class.boresight.event_lines.any? { |line| line.end_with?(sentence) } }
    self.class.boresight.event_lines.each { |line| refute_includes line, 'correct-horse' }
  end

  def test_SWR_SESS_017_nothing_is_shown_without_a_session
    %w[status motors targeting log events].each { |name| assert_refused '401', 'NO_SESSION', get("/api/v1/#{name}") }
    assert_equal '200', get('/').code
    assert_equal '200', get('/api/v1/openapi.json').code
    assert_equal '200', post('/api/v1/stop', '').code
  end
end
