# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: a client that reads with the standard's own library gets the force of the running robot while it is believed,
# and the reason while it is not.

require_relative '../support/igtl_client'
require_relative '../support/page_test'

class TestIgtlForces < Minitest::Test
  include PageTest

  TREMBLE_N = 0.05 # The zero of a hand, which trembles, is not exact.

  def self.boresight
    @boresight ||= Boresight.start(arguments: ['--robot', 'prostate', '--accounts', accounts, *Boresight::FAST]).tap(&:home_fast)
  end

  # The answers on both ports.
  def ask(name)
    [boresight.brp_port, boresight.igtl_port].map do |port|
      IgtlClient.open(port) do |client|
        orders = ["ask GET_SENSOR #{name}", 'ask GET_STATUS ping', 'wait STATUS ping']
        orders.flat_map { |order| client.run(order) }.find { |message| message['name'] == name }
      end
    end
  end

  def zero
    anna = holder
    wait_until('it is zeroed') { anna.act('force/zero').code == '200' }
    wait_until('both are believed') { forces.all? { |force| force['doubts'].empty? } }
  end

  def forces
    fetch_json('/api/v1/status').fetch('forces')
  end

  def test_SWR_IGTL_611_a_running_robot_sends_a_force_that_is_believed_and_else_its_doubt
    ask('FORCE_HAND').each { |answer| assert_equal [13, 'FORCE_DOUBTFUL'], answer.values_at('code', 'error_name') }
    zero
    boresight.simctl('force', 'hand', '2083')
    wait_until('the push is sent') { ask('FORCE_HAND').all? { |answer| (answer['values'].first - 1).abs <= TREMBLE_N } }
    ask('FORCE_NEEDLE').each do |answer|
      assert_equal 'N', answer['unit']
      assert_in_delta 0, answer['values'].first, TREMBLE_N
    end
    boresight.simctl('force', 'hand', '4095')
    wait_until('the wire is broken') { forces.first['doubts'].any? }
    ask('FORCE_HAND').each { |answer| assert_match(/BROKEN_WIRE: /, answer['text']) }
    ask('FORCE_NEEDLE').each { |answer| assert_in_delta 0, answer['values'].first, TREMBLE_N }
  end
end
