# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: on a full disk the first START_UP of a run is refused by name to everybody, until an engineer accepts the run
# without a recording; the log says who did.

require_relative '../support/igtl_client'
require_relative '../support/page_test'

class TestRunWithoutRecording < Minitest::Test
  include PageTest

  PATH = '/api/v1/black-box/accept-none'

  # No file of the recorder may become larger, as on a full disk.
  def fill_disk
    skip 'prlimit is missing' unless system('command -v prlimit > /dev/null')
    wait_until('it records') { boresight.recording_files.any? }
    assert system('prlimit', '--pid', boresight.pid_of('recorder').to_s, "--fsize=#{File.size(boresight.recording_files.last) + 1000}:unlimited")
    wait_until('nothing is recorded') { boresight.status['is_recorder_failing'] }
  end

  def start_up(who)
    who.act('workphase', { workphase: 'START_UP' })
  end

  def allowed?(who)
    reported = JSON.parse(who.request('get', '/api/v1/modes').body)
    reported.fetch('commands').find { |one| one['name'] == 'ACCEPT_NO_BLACK_BOX' }.fetch('is_allowed')
  end

  def refused_to_all
    IgtlClient.open(boresight.brp_port) do |client|
      client.phase('START_UP')
      client.run('expect STATUS START_UP 13')
    end
    boresight.leave
    anna = holder('anna')
    assert_answer '409', 'NO_BLACK_BOX', start_up(anna)
    assert_answer '403', 'ROLE_REFUSED', anna.act('black-box/accept-none')
    anna.give_up
  end

  def test_SWR_CMD_006_SWR_NEXT_027_an_engineer_accepts_a_run_on_a_full_disk_by_name
    egon = holder('egon')
    refute allowed?(egon)
    assert_answer '409', 'BLACK_BOX_THERE', egon.act('black-box/accept-none')
    assert_described PATH, 'POST', egon.last
    egon.give_up
    fill_disk
    assert_equal 'NO_BLACK_BOX', boresight.status['next_step']['name']
    refused_to_all
    egon.take
    assert allowed?(egon)
    assert_answer '200', 'done', egon.act('black-box/accept-none')
    assert_described PATH, 'POST', egon.last
    texts = boresight.log.map { |event| [event['name'], event['text']] }
    assert_includes texts.map(&:first), 'NO_BLACK_BOX_ACCEPTED'
    assert(texts.any? { |_, text| text.include?('black-box/accept-none') && text.include?('egon') }, texts.last(5).join("\n"))
    assert_answer '202', 'accepted', start_up(egon)
  end
end
