# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: positions go out as a file that only this box can have made; what comes back is shown beside what is,
# refused by name if it does not fit, and restored as it was shown, unverified.

require_relative '../support/lone_box'
require_relative '../support/page_test'

class TestHttpPositions < Minitest::Test
  include PageTest
  extend PageTest::Homed

  PATH = '/api/v1/positions'

  # Each test begins without authority, in STOP, with axes that rest.
  def setup
    boresight.command('STOP')
    wait_until('the robot is stopped') { status.dig('workphase', 'name') == 'STOP' }
    super
    wait_until('the axes rest') { get(PATH).code == '200' }
  end

  def status
    fetch_json('/api/v1/status')
  end

  def axes
    fetch_json('/api/v1/motors').fetch('axes')
  end

  def file
    JSON.parse(get(PATH).body)
  end

  # An engineer's page, with authority.
  def engineer
    @engineer ||= holder('egon')
  end

  def preview(body, by: engineer)
    @last = by.request('post', "#{PATH}/preview", JSON.generate(body))
    JSON.parse(@last.body)
  end

  def assert_refused(code, body)
    assert_equal code, preview(body).fetch('code'), @last.body
    assert_described "#{PATH}/preview", 'POST', @last
  end

  def restore(token, id: nil)
    engineer.act('positions/restore', { token: token }, id: id)
    JSON.parse(engineer.last.body)
  end

  # Those that were to be are where they were saved, as old lists have it; the others were homed there.
  def assert_restored(shown, ticks)
    restored, stayed = shown['axes'].zip(axes).partition { |reported, _| reported['is_restored'] }
    refute_empty restored
    assert_equal [['old_list', 'unverified', 'unverified', ticks]],
                 restored.map { |reported, axis| reported.values_at('why', 'grade') + axis.values_at('reference', 'position_ticks') }.uniq
    assert_empty(stayed.map { |reported, _| reported['why'] }.uniq - ['stands_there'])
  end

  # As an older control program saves them.
  def motors(ticks)
    cards = status.fetch('cards')
    slots = cards.to_h { |card| [card['axis'], card['slot']] }
    axes.map do |axis|
      { slot: slots.fetch(axis['name']), name: axis['name'], type: 'none', enabled: true, current_ticks: ticks,
        desired_ticks: ticks, min_ticks: -5000, max_ticks: 5000, conversion_factor: 12.5, unit: 'mm',
        limits: [{ name: 'upper', value: false }], homed: true, homing: false, faults: [] }
    end
  end

  # Where a switch then contradicts, the axis is lost.
  def confirm
    boresight.simctl('button', 'press')
    wait_until('the positions are confirmed') { axes.none? { |axis| axis['reference'] == 'unverified' } }
    assert_equal(%w[verified verified], axes.select { |axis| %w[feet rotation].include?(axis['name']) }.map { |axis| axis['reference'] })
  ensure
    boresight.simctl('button', 'release')
  end

  def test_SWR_STORE_024_the_positions_are_a_file
    response = get(PATH)
    saved = JSON.parse(response.body)
    assert_described PATH, 'GET', response
    assert_match(/\Aattachment; filename="positions-neuro-\d{4}-\d\d-\d\dT[\d-]+Z\.json"\z/, response['Content-Disposition'])
    assert_equal %w[boresight-positions/1 neuro], saved.values_at('format', 'robot')
    assert_match(/\A[0-9a-f]{8}\z/, saved['checksum'])
    assert_match(/\A[0-9a-f]{64}\z/, saved['hmac'])
    assert_in_delta Time.now.to_i, Time.iso8601(saved['saved_utc']).to_i, 60
    shown = axes.map do |axis|
      axis['reference'] == 'lost' ? [axis['name'], 'lost', 0] : [axis['name'], 'known', axis['position_ticks']]
    end
    assert_equal(shown, saved['axes'].map { |axis| axis.values_at('name', 'grade', 'position_ticks') })
  end

  def test_SWR_STORE_025_the_key_is_beside_the_kept_positions_for_its_owner_alone
    keys = Dir.glob(File.join(boresight.recordings, 'positions-*.key'))
    assert_equal 1, keys.size
    assert_equal [0o600, 32], [File.stat(keys.first).mode & 0o7777, File.size(keys.first)]
    refute_includes get(PATH).body, File.binread(keys.first).unpack1('H*')
  end

  def test_SWR_STORE_027_what_restoring_would_do_is_shown
    saved = file
    shown = preview({ file: saved })
    assert_described "#{PATH}/preview", 'POST', @last
    assert_equal ['sealed', true, saved['saved_utc']], shown.values_at('origin', 'is_same_power_on', 'saved_utc')
    assert_equal(saved['axes'].map { |axis| axis['name'] }, shown['axes'].map { |axis| axis['name'] })
    whys = { 'unverified' => 'counts_agree', 'lost' => 'not_known' }
    assert_equal(axes.map { |axis| whys.fetch(axis['reference'], 'stands_there') }, shown['axes'].map { |axis| axis['why'] })
  end

  # As after a scan that made an axis' counter count.
  def miscounted(axis)
    saved = file.except('hmac')
    saved.merge('axes' => saved['axes'].map { |one| one['name'] == axis ? one.merge('reading_ticks' => one['reading_ticks'] - 500) : one })
  end

  def why_of(axis, shown)
    shown.fetch('axes').find { |one| one['name'] == axis }.values_at('why', 'is_restored')
  end

  def test_SWR_REF_020_an_axis_that_has_not_moved_is_restored_against_its_counts
    known, before = axes.find { |axis| axis['reference'] != 'lost' }.values_at('name', 'position_ticks')
    body = { file: miscounted(known) }
    assert_equal ['moved', false], why_of(known, preview(body))
    assert_refused 'SAVED_NOT_MOVED', body.merge(miscounted: [known, axes.last['name']])
    assert_refused 'SAVED_NOT_MOVED', body.merge(miscounted: ['nobody'])
    shown = preview(body.merge(miscounted: [known]))
    assert_described "#{PATH}/preview", 'POST', @last
    assert_equal ['miscounted', true], why_of(known, shown)
    assert_equal 'done', restore(shown['token'])['state'], engineer.last.body
    assert_equal ['unverified', before],
                 axes.find { |axis| axis['name'] == known }.values_at('reference', 'position_ticks')
  end

  def test_SWR_STORE_026_what_does_not_fit_is_refused_by_name
    saved = file
    assert_refused 'SAVED_ALTERED', { file: saved.merge('power_on' => saved['power_on'] ^ 1) }
    assert_refused 'SAVED_ALTERED', { file: saved.merge('hmac' => saved['hmac'].tr('0-9a-f', '1-9a-f0')) }
    assert_refused 'SAVED_OTHER_ROBOT', { file: saved.merge('robot' => 'bench2') }
    assert_refused 'SAVED_OTHER_TABLE', { file: saved.merge('checksum' => saved['checksum'].tr('0-9a-f', '1-9a-f0')) }
    assert_refused 'SAVED_OTHER_FORMAT', { file: saved.merge('format' => 'boresight-positions/2') }
    assert_refused 'SAVED_BAD_AXES', { file: saved.merge('axes' => saved['axes'].drop(1)) }
    assert_refused 'SAVED_BAD_VALUE', { file: saved.merge('saved_utc' => '2026-02-30T00:00:00Z') }
    unsealed = saved.except('hmac')
    assert_refused 'SAVED_TOO_OLD', { file: unsealed.merge('saved_utc' => '2020-02-01T00:00:00Z') }
    assert_refused 'SAVED_FROM_FUTURE', { file: unsealed.merge('saved_utc' => '2120-02-01T00:00:00Z') }
    assert_refused 'BAD_BODY', { file: saved.merge('more' => 1) }
    assert_refused 'SAVED_NOT_ONE', {}
    assert_refused 'SAVED_NOT_ONE', { file: saved, motors: motors(0) }
    assert_refused 'SAVED_BAD_SLOTS', { motors: motors(0).drop(1) }
  end

  def test_SWR_STORE_020_positions_are_restored_as_they_were_shown_and_confirmed_by_hand
    shown = preview({ motors: motors(-350) })
    assert_described "#{PATH}/preview", 'POST', @last
    assert_equal 'done', restore(shown['token'])['state'], engineer.last.body
    assert_described "#{PATH}/restore", 'POST', engineer.last
    assert_restored shown, -350
    assert_equal 'done', restore(shown['token'], id: engineer.id)['state'] # An act that was done is not judged again.
    assert_equal 'PREVIEW_CHANGED', restore(shown['token'])['code']
    assert_described "#{PATH}/restore", 'POST', engineer.last
    confirm
  end

  def test_SWR_STORE_030_only_what_was_shown_last_is_restored
    first = preview({ motors: motors(-3) })['token']
    second = preview({ motors: motors(-4) })
    assert_equal 'PREVIEW_GONE', restore(first)['code']
    assert_equal 'PREVIEW_GONE', restore(0)['code']
    assert_equal 'done', restore(second['token'])['state'], engineer.last.body
    assert_restored second, -4
  end

  def test_SWR_STORE_030_where_there_is_nothing_to_restore_that_is_said
    shown = preview({ motors: motors(0).map { |motor| motor.merge(homed: false) } })
    assert_equal ['not_known'], shown['axes'].map { |axis| axis['why'] }.uniq
    assert_equal 'SAVED_NOTHING', restore(shown['token'])['code']
  end

  def test_SWR_STORE_023_the_axis_that_cannot_stand_there_is_named
    strange = motors(0).each_with_index.map { |motor, index| index == 4 ? motor.merge(current_ticks: 1_000_000) : motor }
    reported = restore(preview({ motors: strange })['token'])
    assert_equal ['OUT_OF_RANGE', axes[4]['name']], reported.values_at('code', 'axis')
    assert_described "#{PATH}/restore", 'POST', engineer.last
  end

  def test_SWR_STORE_021_control_says_why_it_does_not_restore
    token = preview({ motors: motors(-6) })['token']
    boresight.simctl('pedal', 'press')
    wait_until('the pedal is pressed') { status['pedal'] != 'released' }
    assert_equal 'NOT_AT_REST', restore(token)['code']
  ensure
    boresight.simctl('pedal', 'release')
  end

  def test_SWR_STORE_021_who_is_no_engineer_or_has_no_authority_restores_nothing
    anna = client('anna')
    assert_equal 'ROLE_REFUSED', preview({ motors: motors(0) }, by: anna)['code']
    assert_equal '403', anna.act('positions/restore', { token: 1 }).code
    token = preview({ motors: motors(-7) })['token']
    engineer.give_up
    assert_equal '423', engineer.act('positions/restore', { token: token }).code
  end
end

# The same over the power-on of a box.
class TestHttpPositionsAnew < SystemTest
  include LoneBox

  PATH = '/api/v1/positions'

  def start
    @boresight = Boresight.start(box: @box, recordings: @directory, arguments: ['--robot', ROBOT, '--accounts', Accounts.make_for_a_while])
  end

  def save
    JSON.parse(Net::HTTP.get(URI("http://127.0.0.1:#{@boresight.http_port}#{PATH}")))
  end

  def axes
    @boresight.motors['axes']
  end

  def engineer
    SessionClient.new(@boresight.http_port).tap do |one|
      one.log_in('egon')
      wait_until('there is authority') { one.take.code == '200' }
    end
  end

  def test_SWR_STORE_024_after_the_box_was_switched_off_its_file_brings_the_positions_back_for_the_operator_to_confirm
    start.press_and_command('START_UP')
    wait_until('nothing is saved in a motion') { save['code'] == 'NOT_AT_REST' }
    wait_until('every axis is homed') { @boresight.status['is_homed'] }
    @boresight.simctl('pedal', 'release')
    wait_until('the axes rest') { save['hmac'] }
    saved = save
    @boresight.stop
    switch_box_off
    switch_box_on
    start
    assert_equal(['fresh'], axes.map { |axis| axis['reference'] }.uniq)
    wait_until('the axes rest') { save['hmac'] }
    page = engineer
    shown = JSON.parse(page.request('post', "#{PATH}/preview", JSON.generate(file: saved)).body)
    assert_equal(['other_power_on'], shown['axes'].map { |axis| axis['why'] }.uniq)
    assert_equal '200', page.act('positions/restore', { token: shown['token'] }).code, page.last.body
    assert_equal(saved['axes'].map { |axis| [axis['position_ticks'], 'unverified'] },
                 axes.map { |axis| axis.values_at('position_ticks', 'reference') })
    @boresight.simctl('button', 'press')
    wait_until('the operator has confirmed them') { axes.all? { |axis| axis['reference'] == 'verified' } }
  end
end
