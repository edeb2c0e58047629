# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: whatever a process writes where every process may write, nothing moves for it, and once it has ended all
# works again without a restart.

require_relative 'support/session_client'
require_relative 'support/system_test'

class TestNeighbour < SystemTest
  LASTS_MS = 1500
  SEED = Integer(ENV.fetch('SEED', '33'))
  DAMAGE_END_MS = 5000 # Span of the world's time; SWR-EXCH-023.
  SERVED_BY = %w[control recorder igtl http].freeze
  REPLACED = SERVED_BY.drop(1).freeze

  # With a peer that commands, with commands in its lane that were carried out, and with a pedal that is pressed.
  def begin_with_commands
    boresight(arguments: ['--robot', 'bench2', '--accounts', Accounts.make_for_a_while])
    boresight.press_and_command('START_UP')
    boresight.command('STOP')
    wait_until('nothing moves') { !boresight.moving? }
  end

  def neighbour
    @began_at = boresight.status['cycle']
    Open3.popen2(Boresight.program('neighbour'), boresight.instance, LASTS_MS.to_s, SEED.to_s) do |input, output, thread|
      input.close
      yield while thread.alive?
      assert thread.value.success?
      assert_operator Integer(output.read, 10), :>, LASTS_MS
    end
  end

  # An awaited condition comes true within the bound, counted in cycles of 1 ms: elastic time does not hurry.
  def in_time(reason, &)
    self.assertions += 1
    boresight.patiently(&)
    assert_operator boresight.status['cycle'] - @began_at, :<=, LASTS_MS + DAMAGE_END_MS, reason
  end

  # An operator's page: it takes authority and jogs.
  def jog
    page = SessionClient.new(boresight.http_port)
    wait_until('somebody is logged in') { page.log_in('anna').code == '200' }
    boresight.leave
    wait_until('the page commands') { page.take.code == '200' }
    boresight.simctl('pedal', 'release')
    boresight.await_released_pedal
    assert_equal '200', page.act('workphase', { workphase: 'MANUAL' }).code, page.last.body
    assert_equal '202', page.act('motors/needle/jog', { position: 5, unit: 'mm' }).code, page.last.body
    boresight.simctl('pedal', 'press')
    wait_until('the jog is done') do
      JSON.parse(page.act('motors/needle/jog', { position: 5, unit: 'mm' }, id: page.id).body)['state'] == 'done'
    end
    boresight.simctl('pedal', 'release')
  end

  def test_SWR_EXCH_023_all_works_again_when_it_has_gone
    begin_with_commands
    programs = boresight.pids.slice(*SERVED_BY)
    files = boresight.recording_files.size
    neighbour { assert_empty boresight.driven_axes }
    in_time('a STOP is obeyed') { boresight.post_stop(boresight.stop_port).code == '200' }
    in_time('START_UP is obeyed') { boresight.command('START_UP') && boresight.status['workphase']['name'] == 'START_UP' }
    boresight.home
    jog
    assert_equal programs, boresight.pids.slice(*SERVED_BY)
    wait_until('the damage is in the log') { boresight.event_lines.grep(/command lane damaged/).any? }
    assert_operator boresight.recording_files.size, :<=, files + 1
    Process.kill('TERM', boresight.pid)
    boresight.wait_for_end
    boresight.recording_files.each do |file|
      text, code = replay(file)
      assert_equal 0, code, text
    end
  end

  # They find what the neighbour has left, and no more.
  def test_SWR_EXCH_023_programs_that_are_started_anew_work_as_well
    begin_with_commands
    boresight.leave
    neighbour do
      @ended ||= REPLACED.each { |name| boresight.kill(name, 'KILL') }
    end
    in_time('a STOP is obeyed') { boresight.post_stop(boresight.stop_port).code == '200' }
    in_time('START_UP is obeyed') { boresight.command('START_UP') && boresight.status['workphase']['name'] == 'START_UP' }
    wait_until('events are logged on') { boresight.event_lines.last(5).grep(/START_UP/).any? }
    assert_operator boresight.log_files.size, :<=, 2
  end
end
