# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: an engineer who has nothing but /api/v1/openapi.json writes a client that takes the robot through its whole workflow, and
# the robot moves when the pedal is pressed at it, and at no other time.

require_relative '../../demo/targets'
require_relative '../support/document_client'
require_relative '../support/page_test'

class TestHttpClient < Minitest::Test
  include HttpClient
  extend PageTest::OneWithAccounts

  # It homes in a quarter of the default one's time. A page renews its authority by the clock of the world, so time is not fast.
  ROBOT = 'bench2'
  TARGETS = Targets.new(File.expand_path("../../../core/robot/#{ROBOT}/targets.yml", __dir__))

  def self.pace
    ['--robot', ROBOT]
  end

  def boresight
    self.class.boresight
  end

  def client
    @client ||= DocumentClient.new("http://127.0.0.1:#{port}").tap do |one|
      assert_equal 200, one.log_in(name: 'anna', password: Accounts::PASSWORDS['anna'].last).code
      assert_equal 'done', one.call('take').body['state']
    end
  end

  # True state of the axes, as the box reports it: places and drives.
  def truth
    boresight.box_axes.map { |words| words.first(6) }
  end

  # Keeps authority meanwhile.
  def wait_until(reason)
    super do
      @client&.call('renew_authority')
      yield
    end
  end

  # Asks again until the act `id` has ended.
  def await(operation, id, **values)
    wait_until("#{operation} has ended") { client.call(operation, id:, **values).body['state'] != 'accepted' }
    client.call(operation, id:, **values).body
  end

  # Begins it, sees that nothing moves, and presses the pedal.
  def under_pedal(operation, **values)
    begun = client.call(operation, **values)
    assert_equal [202, 'accepted'], [begun.code, begun.body['state']], begun.body
    id = client.id
    assert_nothing_moves
    boresight.simctl('pedal', 'press')
    wait_until('an axis is driven') { boresight.driven_axes.any? }
    ended = await(operation, id, **values)
    assert_equal 'done', ended['state'], ended
  ensure
    boresight.simctl('pedal', 'release')
    boresight.await_released_pedal
  end

  def assert_nothing_moves
    before = truth
    cycle = client.call('status').body['cycle']
    wait_until('some time has passed') { client.call('status').body['cycle'] > cycle + 200 }
    assert_empty boresight.driven_axes
    assert_equal before, truth
  end

  def go(workphase)
    answer = client.call('workphase', workphase:)
    assert_equal [200, workphase], [answer.code, answer.body['workphase']], answer.body
  end

  def matrix(rows)
    [*rows, 0, 0, 0, 1]
  end

  def target
    one = TARGETS.each_target.first
    matrix(Geometry.rows(one.rotation, one.point))
  end

  def test_SWR_HTTP_036_a_client_of_the_document_alone_moves_the_robot_under_the_pedal
    under_pedal('workphase', workphase: 'START_UP')
    %w[PLANNING CALIBRATION].each { |workphase| go(workphase) }
    assert_equal 'done', client.call('registration', matrix: matrix(TARGETS.registration)).body['state']
    go('TARGETING')
    preview = client.call('preview_target', matrix: target).body
    axes = client.call('motors').body['axes'].map { |axis| axis['name'] }
    assert_equal [true, axes], [preview['is_reachable'], preview['axes'].map { |axis| axis['name'] }], preview
    assert_equal 'done', client.call('target', matrix: target).body['state']
    under_pedal('workphase', workphase: 'MOVE_TO_TARGET')
    targeting = client.call('targeting').body
    assert_in_delta 0, targeting['distance_mm'], 0.1
    assert_equal(['page of anna'] * 2, targeting.values_at('registration_by', 'target_by').map { |one| one['name'] })
    targeting['scanner_treatment'].zip(target).each { |is, asked| assert_in_delta asked, is, 1.0 }
    assert_equal 'nobody', client.call('release').body['state']
    assert_equal 423, client.call('workphase', workphase: 'PLANNING').code
  end
end
