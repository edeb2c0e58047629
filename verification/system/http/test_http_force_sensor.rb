# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the forces of a robot with a force sensor are sent with the status, and an operator who commands zeroes them.

require_relative '../support/page_test'

class TestHttpForceSensor < Minitest::Test
  include PageTest

  TREMBLE_MN = 50 # The zero of a hand, which trembles, is not exact.

  def self.boresight
    @boresight ||= Boresight.start(arguments: ['--robot', 'prostate', '--accounts', accounts, *Boresight::FAST]).tap(&:home_fast)
  end

  def forces
    fetch_json('/api/v1/status').fetch('forces').to_h { |force| [force.fetch('channel'), force] }
  end

  def doubts(channel)
    forces.fetch(channel).fetch('doubts').map { |doubt| doubt.fetch('name') }
  end

  def test_SWR_FORCE_579_forces_are_sent_with_the_status_and_zeroed_by_who_commands
    assert_equal %w[HAND NEEDLE], forces.keys
    assert_equal ['NOT_ZEROED'], doubts('HAND')
    boresight.simctl('force', 'hand', '1980')
    wait_until('the reading is there') { forces.fetch('HAND').fetch('reading') == 1980 }
    anna = holder
    wait_until('everything rests, and it is zeroed') { anna.act('force/zero').code == '200' }
    wait_until('the hand reads the same each time') { doubts('HAND') == ['TOO_QUIET'] && doubts('NEEDLE').empty? }
    assert_equal [0, 88], forces.fetch('HAND').values_at('force_mn', 'zero_mn')
    boresight.simctl('force', 'hand', 'normal')
    assert_equal '200', anna.act('force/zero').code
    wait_until('both are believed') { doubts('HAND').empty? && doubts('NEEDLE').empty? }
    boresight.simctl('force', 'hand', '2083')
    wait_until('the force is there') { (forces.fetch('HAND').fetch('force_mn') - 1000).abs <= TREMBLE_MN }
    boresight.simctl('force', 'hand', '4095')
    wait_until('the wire is broken') { doubts('HAND').include?('BROKEN_WIRE') }
    assert_empty doubts('NEEDLE')
  end
end
