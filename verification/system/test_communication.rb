# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: who commands is told by name wherever people look, and so is each connection of OpenIGTLink; a connection
# is ended, and told whether it is kept alive, by who has authority.

require_relative 'support/http_client'
require_relative 'support/session_client'

class TestCommunication < Minitest::Test
  include HttpClient

  # One running system with accounts.
  module WithAccounts
    def boresight
      @boresight ||= Boresight.start(arguments: ['--accounts', Accounts.make_for_a_while])
    end
  end
  extend WithAccounts

  # Each test begins without connections, and without authority.
  def setup
    boresight.leave
    wait_until('nobody has authority') { authority['state'] == 'nobody' }
  end

  def boresight
    self.class.boresight
  end

  def authority
    boresight.status['authority']
  end

  # A connection that has authority.
  def command_by_igtl
    boresight.command('START_UP')
    wait_until('it has authority') { authority['state'] == 'held' }
  end

  def test_SWR_AUTH_017_status_stream_and_route_tell_who_commands_by_name
    assert_equal ['nobody', nil, nil, 0], authority.values_at('state', 'source', 'name', 'age_s')
    command_by_igtl
    wait_until('its age is told') { authority['age_s'] > 0.5 }
    told = authority
    assert_equal %w[held IGTL], told.values_at('state', 'source')
    assert_match(/\Aworkphases 127\.0\.0\.1:\d+\z/, told['name'])
    assert_equal told['name'], fetch_json('/api/v1/authority')['name']
    stream = open_stream
    assert_equal told['name'], stream.next_of('state').dig('status', 'authority', 'name')
  ensure
    stream&.close
  end

  def test_SWR_AUTH_018_the_line_of_status_tells_who_commands_by_name
    wait_until('nobody does') { last_line.include?(' | nobody commands | ') }
    command_by_igtl
    wait_until('it does') { last_line.match?(/ \| commanded by workphases 127\.0\.0\.1:\d+ for \d+ s \| /) }
  end

  private

  def last_line
    boresight.output.lines.grep(/links/).last.to_s
  end
end
