# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: single axes are homed, cleared, confirmed and given their home over HTTP by a page that has authority, the
# last and the clearing by an engineer alone; what control refuses is answered by its name, and nothing moves without the
# pedal or is confirmed without the button.

require_relative 'support/http_client'
require_relative 'support/openapi'
require_relative 'support/session_client'

class TestHttpAxes < Minitest::Test
  include HttpClient

  # One running system with accounts.
  module WithAccounts
    def boresight
      @boresight ||= Boresight.start(arguments: ['--accounts', Accounts.make_for_a_while]).tap(&:home)
    end
  end
  extend WithAccounts

  def setup
    @clients = []
    self.class.boresight.leave
    wait_until('nobody has authority') { fetch_json('/api/v1/authority').fetch('state') == 'nobody' }
  end

  def teardown
    simctl('pedal', 'release')
    simctl('button', 'release')
    @clients.each(&:log_out)
  end

  # A page that has authority, in MANUAL.
  def holder(name)
    SessionClient.new(port).tap do |one|
      @clients << one
      assert_equal('200', one.log_in(name).code)
      assert_answer '200', 'done', one.take
      assert_answer '200', 'done', one.act('workphase', { workphase: 'MANUAL' })
    end
  end

  def simctl(*words)
    self.class.boresight.simctl(*words)
  end

  def assert_answer(code, state, response)
    told = JSON.parse(response.body)
    assert_equal [code, state], [response.code, told['state'] || told['code']], response.body
    told
  end

  def assert_described(act, response)
    fault = Openapi.new(get('/api/v1/openapi.json').body)
                   .fault("/api/v1/motors/{axis}/#{act}", 'POST', response.code, response['Content-Type'], response.body)
    assert_nil fault, "#{act}: #{fault}\n#{response.body}"
  end

  def reference(axis)
    fetch_json('/api/v1/motors').fetch('axes').find { |one| one['name'] == axis }.fetch('reference')
  end

  def test_SWR_AXIS_044_one_axis_homes_under_the_pedal_alone
    anna = holder('anna')
    assert_answer '202', 'accepted', anna.act('motors/yaw/home')
    assert_described 'home', anna.last
    assert_equal 'lost', reference('yaw')
    simctl('pedal', 'press')
    wait_until('it is done') { JSON.parse(anna.act('motors/yaw/home', id: anna.id).body)['state'] == 'done' }
    assert_equal 'verified', reference('yaw')
  end

  def test_SWR_AXIS_044_a_home_that_an_engineer_sets_counts_once_the_button_has_confirmed_it
    egon = holder('egon')
    assert_answer '200', 'done', egon.act('motors/feet/clear')
    assert_described 'clear', egon.last
    assert_equal 'lost', reference('feet')
    assert_answer '200', 'done', egon.act('motors/feet/set-home')
    assert_equal 'unverified', reference('feet')
    assert_answer '200', 'done', egon.act('motors/feet/confirm')
    told = fetch_json('/api/v1/authority')
    assert_equal ['CONFIRM_AXIS', 1], told.values_at('request', 'request_axis')
    assert_equal 'unverified', reference('feet')
    simctl('button', 'press')
    wait_until('it is confirmed') { egon.keep && reference('feet') == 'verified' }
  end

  def test_SWR_AXIS_044_a_refusal_has_its_name
    egon = holder('egon')
    { 'feet/home' => 'HOMES_OTHERWISE', 'yaw/set-home' => 'HOMES_OTHERWISE', 'yaw/confirm' => 'NOTHING_TO_CONFIRM' }.each do |path, code|
      assert_answer '409', code, egon.act("motors/#{path}")
      assert_described path.split('/').last, egon.last
    end
    egon.act('workphase', { workphase: 'PLANNING' })
    assert_answer '409', 'WRONG_WORKPHASE', egon.act('motors/yaw/clear')
    assert_equal 'verified', reference('yaw')
    assert_answer '404', 'NOT_THERE', egon.act('motors/nose/clear')
  end

  def test_SWR_AXIS_044_an_operator_neither_clears_nor_sets
    anna = holder('anna')
    %w[clear set-home].each { |act| assert_answer '403', 'ROLE_REFUSED', anna.act("motors/feet/#{act}") }
    anna.give_up
    %w[home confirm].each { |act| assert_answer '423', 'NO_AUTHORITY', anna.act("motors/feet/#{act}") }
  end
end
