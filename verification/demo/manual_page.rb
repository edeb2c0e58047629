# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'json'
require_relative '../system/support/session_client'

# A page that commands a homed robot in MANUAL, for a demonstration over HTTP.
module ManualPage
  private

  # Page of a robot that no client commands.
  def page(robot)
    one = SessionClient.new(robot.http_port)
    one.log_in('anna')
    robot.wait_until('authority is free') { one.take.code == '200' }
    expect(one.act('workphase', { workphase: 'MANUAL' }), 'done')
    one
  end

  def state(response)
    JSON.parse(response.body)['state']
  end

  def expect(response, word)
    raise "not #{word}: #{response.body}" unless state(response) == word
  end
end
