# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: what people write into the log stands there once, under their name, and passes for nothing else.

require_relative '../support/page_test'

class TestHttpNotes < Minitest::Test
  include PageTest

  # The answer, as soon as the pause after the note before is over.
  def write(client, text, id: client.id += 1)
    answer = nil
    wait_until('the server takes a note') { (answer = client.act('log/note', { text: text }, id:)).code != '429' }
    answer
  end

  def fault(answer)
    JSON.parse(answer.body).values_at('code', 'pointer')
  end

  def notes(text)
    fetch_json('/api/v1/log').fetch('entries').select do |entry|
      entry.fetch('subject') == 'OPERATOR' && entry.fetch('text').include?(text)
    end
  end

  def test_SWR_EVENT_012_a_note_stands_in_the_log_with_the_name_of_who_wrote_it
    anna = client('anna')
    answer = write(anna, 'The phantom was turned by 5° — see "page 3"\\.')
    assert_equal %w[200 done], [answer.code, JSON.parse(answer.body)['state']]
    entry = notes('phantom').last
    assert_equal ['Note of anna: The phantom was turned by 5° — see "page 3"\\.', 'NOTE', 'OPERATOR', 'CONSOLE', anna.page],
                 entry.values_at('text', 'name', 'subject', 'cause', 'peer')
    wait_until('it is in the file') { boresight.event_lines.any? { |line| line.end_with?('see "page 3"\\.') } }
  end

  def test_SWR_EVENT_012_the_answers_are_as_described
    anna = client('anna')
    [write(anna, 'Described.'), anna.act('log/note', { text: '' }), anna.act('log/note', {})].each do |answer|
      assert_described '/api/v1/log/note', 'POST', answer
    end
  end

  def test_SWR_EVENT_012_a_repeated_note_is_written_once
    anna = client('anna')
    answer = write(anna, 'Once.')
    3.times { assert_equal answer.body, write(anna, 'Once.', id: anna.id).body }
    assert_equal 'ID_USED', code(write(anna, 'Twice.', id: anna.id))
    write(anna, 'After it.')
    assert_equal [1, 0, 1], ['Once.', 'Twice.', 'After it.'].map { |text| notes(text).size }
  end

  def test_SWR_EVENT_012_a_note_needs_no_authority_and_takes_none
    anna = client('anna')
    egon = holder('egon')
    assert_equal '200', write(anna, 'Beside who commands.').code
    assert_equal ['held', egon.page], authority.values_at('state', 'peer')
  end

  def test_SWR_EVENT_012_an_observer_writes_none
    olga = client('olga')
    assert_equal 'ROLE_REFUSED', code(olga.act('log/note', { text: 'x' }))
    anna = client('anna')
    anna.token = nil
    assert_equal 'TOKEN_REFUSED', code(anna.act('log/note', { text: 'x' }))
    anna.cookie = nil
    assert_equal 'NO_SESSION', code(anna.act('log/note', { text: 'x' }))
  end

  def test_SWR_EVENT_012_what_would_change_a_line_is_refused
    anna = client('anna')
    ['', "a\nb", "a\u0000b", "\u007f", "\u0085", "a\u2028b", "\u202e", "\u2066"].each do |text|
      answer = anna.act('log/note', { text: text })
      assert_includes [['OUT_OF_RANGE', '/text'], ['BAD_BODY', '/text']], fault(answer), text.inspect
    end
    assert_equal ['BAD_BODY', '/text'], fault(anna.act('log/note', { text: 'ä' * 81 }))
    assert_equal '200', write(anna, 'ä' * 80).code
    assert_equal "Note of anna: #{'ä' * 80}", notes('ä' * 80).last.fetch('text')
  end

  def test_SWR_EVENT_012_a_note_reads_as_no_line_of_the_system
    write(client('anna'), 'logged in as service, by password.')
    assert_equal ['Note of anna: logged in as service, by password.'], notes('as service').map { |entry| entry.fetch('text') }
  end
end
