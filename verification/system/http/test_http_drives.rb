# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: a robot with a piezo motor on an analog card is started by its name, homes and jogs as any other, and reports
# its type of card.

require_relative '../support/page_test'

class TestHttpDrives < Minitest::Test
  include PageTest

  # The bench: its needle has such a motor.
  def self.boresight
    @boresight ||= Boresight.start(arguments: ['--robot', 'bench2', '--accounts', accounts, *Boresight::FAST]).tap(&:home_fast)
  end

  def needle
    fetch_json('/api/v1/motors').fetch('axes').find { |axis| axis['name'] == 'needle' }
  end

  def test_SWR_DRIVE_014_the_piezo_motor_of_an_analog_card_homes_and_jogs
    types = fetch_json('/api/v1/status').fetch('cards').to_h { |card| card.values_at('axis', 'type') }
    assert_equal({ 'slide' => 'non_pwm', 'needle' => 'analog' }, types.slice('slide', 'needle'))
    assert_equal 'verified', needle.fetch('reference')
    anna = holder
    assert_answer '200', 'done', anna.act('workphase', { workphase: 'MANUAL' })
    assert_answer '202', 'accepted', anna.act('motors/needle/jog', { position: 5, unit: 'mm' })
    boresight.simctl('pedal', 'press')
    wait_until('the jog is done') { JSON.parse(anna.act('motors/needle/jog', { position: 5, unit: 'mm' }, id: anna.id).body)['state'] == 'done' }
    assert_in_delta 5, needle.fetch('position'), 0.002
  ensure
    boresight.simctl('pedal', 'release')
  end
end
