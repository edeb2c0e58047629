# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the holder of authority is named wherever people look, and so is each connection of OpenIGTLink; the
# holder of authority ends a connection, and asks whether it is still there.

require_relative '../support/igtl_client'
require_relative '../support/page_test'

class TestCommunication < Minitest::Test
  include PageTest

  # Each test begins without connections, and without authority.
  def setup
    super
    wait_until('nobody is connected') { connections.empty? }
  end

  def authority
    boresight.status['authority']
  end

  # A connection that has authority.
  def command_by_igtl
    boresight.command('START_UP')
    wait_until('it has authority, and is reported') { authority['state'] == 'held' && connections.any? }
  end

  def test_SWR_AUTH_017_status_stream_and_route_report_who_commands_by_name
    assert_equal ['nobody', nil, nil, 0], authority.values_at('state', 'source', 'name', 'age_s')
    command_by_igtl
    wait_until('its age is reported') { authority['age_s'] > 0.5 }
    reported = authority
    assert_equal %w[held IGTL], reported.values_at('state', 'source')
    assert_match(/\Aworkphases 127\.0\.0\.1:\d+\z/, reported['name'])
    assert_equal reported['name'], fetch_json('/api/v1/authority')['name']
    stream = open_stream
    assert_equal reported['name'], stream.next_of('state').dig('status', 'authority', 'name')
  ensure
    stream&.close
  end

  def test_SWR_AUTH_017_a_page_is_reported_by_its_account
    page = holder
    wait_until('it is reported') { authority['name'] == 'page of anna' }
    assert_equal ['HTTP', page.page], authority.values_at('source', 'peer')
    reported = communication['pages'].find { |one| one['number'] == page.page }
    assert_equal ['anna', true], reported.values_at('account', 'has_authority')
  end

  # A navigation program that is refused shows its operator the text.
  def test_SWR_IGTL_055_a_connection_is_refused_with_the_name_of_the_page_that_commands
    page = holder
    wait_until('it is reported') { authority['name'] == 'page of anna' }
    socket = TCPSocket.open('127.0.0.1', boresight.brp_port)
    socket.write(RawIgtl.string('CMD_1', 'PLANNING'))
    heard = +''
    heard << socket.readpartial(4096) until heard.match?(/NO_AUTHORITY: page of anna has commanded the robot for \d+ s\./)
    self.assertions += 1
  ensure
    socket&.close
  end

  def test_SWR_AUTH_018_the_line_of_status_reports_who_commands_by_name
    wait_until('nobody does') { last_line.include?(' | nobody commands | ') }
    command_by_igtl
    wait_until('it does') { last_line.match?(/ \| commanded by workphases 127\.0\.0\.1:\d+ for \d+ s \| /) }
  end

  def test_SWR_AUTH_018_the_line_of_status_reports_who_asks_for_the_button
    assert_equal '200', client('anna').act('authority/request', { what: 'TAKE' }).code
    wait_until('it is reported') { last_line.match?(/ \| page of anna asks for the button, \d+ s left/) }
    self.assertions += 1
  end

  def test_SWR_IGTL_059_each_connection_and_page_is_reported
    watcher = TCPSocket.open('127.0.0.1', boresight.igtl_port)
    command_by_igtl
    wait_until('both are reported') { connections.map { |one| one['messages_in'] }.sort == [0, 1] }
    assert_described '/api/v1/communication', 'GET', get('/api/v1/communication')
    other, commander = connections.sort_by { |one| one['port'] }
    assert_equal ['workphases', 'brp-2013', true, true, false, 0],
                 commander.values_at('port', 'dialect', 'has_authority', 'keep_alive', 'is_waiting', 'errors')
    assert_match(/\ACMD_\d{4}\z/, commander['last_message'])
    assert_operator commander['bytes_in'], :>, 58
    assert_operator commander['messages_out'], :>=, 1
    assert_equal ['transforms', 'crtk', false, nil, "127.0.0.1:#{watcher.local_address.ip_port}"],
                 other.values_at('port', 'dialect', 'has_authority', 'last_message', 'address')
    assert_equal %w[workphases transforms], communication['ports'].map { |one| one['name'] }
  ensure
    watcher&.close
  end

  # Code, subcode, error name, text.
  def test_SWR_IGTL_092_SWR_EVENT_022_the_status_of_an_imager_is_shown_and_logged
    imager = TCPSocket.open('127.0.0.1', boresight.igtl_port)
    wait_until('it is reported') { connections.size == 1 }
    assert_nil connections.first['status']
    imager.write(RawIgtl.message('STATUS', 'IMAGER', [1, 0, 'OK', "Valid Target\0"].pack('nQ>a20a*')))
    wait_until('its status is shown') { connections.first['status'] == 'IMAGER 1 OK Valid Target' }
    wait_until('its status is logged') { boresight.log_lines.any? { |line| line.end_with?(' STATUS IMAGER 1 OK Valid Target') } }
    assert_described '/api/v1/communication', 'GET', get('/api/v1/communication')
  ensure
    imager&.close
  end

  # Old words of PROBE, without units.
  def test_SWR_IGTL_093_SWR_EVENT_023_a_message_that_igtl_refuses_is_logged
    peer = TCPSocket.open('127.0.0.1', boresight.brp_port)
    3.times { peer.write(RawIgtl.string('PROBE', 'PROBE 10 5 5 41')) }
    wait_until('its refusal is logged') { refusals.any? }
    assert_match(/ REFUSED PROBE PROBE_LENGTH: /, refusals.first)
    peer.write(RawIgtl.string('JUGGLE', 'JUGGLE'))
    wait_until('the next one is logged') { refusals.size == 2 }
    assert_match(/ REFUSED JUGGLE UNKNOWN_COMMAND: /, refusals.last)
  ensure
    peer&.close
  end

  def refusals
    boresight.log_lines.grep(/ REFUSED /)
  end

  def test_SWR_IGTL_060_who_has_authority_ends_a_connection
    watcher = TCPSocket.open('127.0.0.1', boresight.igtl_port)
    wait_until('it is reported') { connections.size == 1 }
    number = connections.first['number']
    page = client('anna')
    assert_refused '423', 'NO_AUTHORITY', disconnect(page, number)
    assert_equal '200', page.take.code
    assert_refused '404', 'NOT_THERE', disconnect(page, number + 10)
    answer = disconnect(page, number)
    assert_equal '200', answer.code, answer.body
    assert_empty JSON.parse(answer.body)['connections']
    wait_until('its end is seen') { ended?(watcher) }
    assert_refused '404', 'NOT_THERE', disconnect(page, number)
  ensure
    watcher&.close
  end

  # Authority may change between a page's question and the order: the server of the connections judges it, too.
  def test_SWR_IGTL_060_a_connection_that_has_authority_is_not_ended
    command_by_igtl
    assert_refused '423', 'NO_AUTHORITY', disconnect(client('anna'), connections.first['number'])
    assert_equal 'held', authority['state']
  end

  # Connections and pages have numbers of their own.
  def test_SWR_IGTL_060_the_number_of_who_commands_makes_no_page_command
    command_by_igtl
    page = client('anna')
    page.page = connections.first['number']
    assert_refused '423', 'NO_AUTHORITY', disconnect(page, page.page)
    assert_refused '423', 'NO_AUTHORITY', keep_alive(page, page.page, on: false)
  end

  def test_SWR_IGTL_060_an_order_while_the_server_of_connections_hangs_is_refused
    page = holder
    boresight.while_stopped('igtl') { assert_refused '503', 'NO_ANSWER', disconnect(page, 11) }
  end

  def test_SWR_IGTL_061_who_has_authority_switches_keep_alive
    watcher = TCPSocket.open('127.0.0.1', boresight.igtl_port)
    wait_until('it is reported') { connections.size == 1 }
    number = connections.first['number']
    page = client('anna')
    assert_refused '423', 'NO_AUTHORITY', keep_alive(page, number, on: false)
    assert_equal '200', page.take.code
    [false, true].each do |is_on|
      answer = keep_alive(page, number, on: is_on)
      assert_equal '200', answer.code, answer.body
      assert_equal is_on, JSON.parse(answer.body).dig('connections', 0, 'keep_alive')
    end
    assert_refused '404', 'NOT_THERE', keep_alive(page, number + 10, on: true)
  ensure
    watcher&.close
  end

  private

  def communication
    fetch_json('/api/v1/communication')
  end

  def connections
    communication['connections']
  end

  def disconnect(page, number)
    page.request('post', "/api/v1/communication/#{number}/disconnect", nil, SessionClient::PAGE => page.page.to_s)
  end

  def keep_alive(page, number, fields)
    page.request('put', "/api/v1/communication/#{number}/keep-alive", JSON.generate(fields),
                 SessionClient::PAGE => page.page.to_s)
  end

  def ended?(socket)
    socket.read_nonblock(1000, exception: false).nil?
  rescue Errno::ECONNRESET
    true
  end

  def last_line
    boresight.output.lines.grep(/links/).last.to_s
  end
end
