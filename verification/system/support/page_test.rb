# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'http_client'
require_relative 'openapi'
require_relative 'session_client'

# Common parts of tests of pages: one running system with accounts for all tests of a file, pages that are logged out with the test,
# and answers that are held against their description.
module PageTest
  include HttpClient

  def self.included(test)
    test.extend(OneWithAccounts)
  end

  # One running system with accounts serves all tests of a file.
  module OneWithAccounts
    def boresight
      @boresight ||= Boresight.start(arguments: ['--accounts', accounts, *pace])
    end

    def pace
      []
    end

    def accounts
      @accounts ||= Accounts.make_for_a_while
    end
  end

  # It is homed, in fast time; the tests look at what follows.
  module Homed
    def boresight
      @boresight ||= super.tap(&:home_fast)
    end

    def pace
      Boresight::FAST
    end
  end

  # Each test begins without authority.
  def setup
    super
    boresight.leave
  end

  def teardown
    clients.select(&:cookie).each(&:log_out)
    super
  end

  def boresight
    self.class.boresight
  end

  def clients
    @clients ||= []
  end

  # A page, of nobody without a name.
  def client(name = nil)
    SessionClient.new(port).tap do |one|
      clients << one
      assert_equal('200', one.log_in(name).code) if name
    end
  end

  # A page that has authority.
  def holder(name = 'anna')
    client(name).tap { |one| assert_answer '200', 'done', one.take }
  end

  def authority
    fetch_json('/api/v1/authority')
  end

  def code(response)
    JSON.parse(response.body)['code']
  end

  # Outcome of an act.
  def assert_answer(code, state, response)
    reported = JSON.parse(response.body)
    assert_equal [code, state], [response.code, reported['state'] || reported['code']], response.body
    reported
  end

  def openapi
    @openapi ||= Openapi.new(get('/api/v1/openapi.json').body)
  end

  def assert_described(path, method, response)
    fault = openapi.fault(path, method, response.code, response['Content-Type'], response.body)
    assert_nil fault, "#{method} #{path}: #{fault}\n#{response.body}"
    response
  end
end
