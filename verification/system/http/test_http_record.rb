# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: what is commanded over HTTP stands in the log with its answer, what is refused too, and no secret.

require 'cgi'
require_relative '../support/page_test'

class TestHttpRecord < Minitest::Test
  include PageTest

  # The transactions in the log with this text.
  def transactions(text)
    fetch_json('/api/v1/log').fetch('entries').select do |entry|
      entry.fetch('subject') == 'TRANSACTION' && entry.fetch('text').include?(text)
    end
  end

  def test_SWR_EVENT_018_a_command_stands_in_the_log_with_body_and_answer
    anna = holder('anna')
    answer = anna.act('targeting/entry', { point_mm: [12.25, -3, 4.5] })
    line = nil
    wait_until('it is in the log') { line = transactions('12.25').last }
    assert_equal 'anna: POST /api/v1/targeting/entry ' \
                 "{\"id\":#{anna.id},\"point_mm\":[12.25,-3,4.5]} answered #{answer.code} #{answer.body}", line.fetch('text')
    found = fetch_json("/api/v1/log?text=#{CGI.escape('[12.25,-3')}").fetch('entries')
    assert_equal [line.fetch('number')], found.map { |entry| entry.fetch('number') }
    wait_until('it is in the file') { boresight.event_lines.any? { |one| one.include?('"point_mm":[12.25,-3,4.5]') } }
  end

  def test_SWR_EVENT_018_no_secret_stands_in_the_log
    egon = holder('egon')
    egon.act('positions/restore', { token: 987_654_321 })
    wait_until('it is in the log') { transactions('positions/restore').any? }
    assert_includes transactions('positions/restore').last.fetch('text'), '"token":"***"'
    all = fetch_json('/api/v1/log').fetch('entries').map { |entry| entry.fetch('text') }.join("\n")
    [Accounts::PASSWORDS.dig('egon', 1), egon.token, '987654321'].each { |secret| refute_includes all, secret }
  end

  def test_SWR_EVENT_019_a_refused_request_stands_in_the_log
    anna = holder('anna')
    anna.act('targeting/registration', { matrix: [9999] * 16 })
    wait_until('it is in the log') { transactions('targeting/registration').any? }
    assert_match(%r{\Aanna: POST /api/v1/targeting/registration \{"id":\d+,"matrix":\[9999,.*\} answered 422 .*/matrix/0"\}\z},
                 transactions('targeting/registration').last.fetch('text'))
    client.act('workphase', { workphase: 'PLANNING' })
    wait_until('a stranger is in the log') { transactions('?: POST /api/v1/workphase').any? }
    assert_match(%r{\A\?: POST /api/v1/workphase answered 401 }, transactions('?: POST /api/v1/workphase').last.fetch('text'))
  end
end
