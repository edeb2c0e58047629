# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: with any clients that compete for authority and any process killed meanwhile, one commands at a time and no other
# moves anything. The recording of one run is replayed under an oracle, and kept in build/authority_stress/ if a rule was broken;
# `make authority-stress MINUTES=5` is a longer one.

require_relative 'support/system_test'
require_relative '../authority_stress/authority_stress'

class TestAuthorityFight < SystemTest
  SECONDS = 20

  def self.verdict
    @verdict ||= AuthorityStress.judge(SECONDS, Random.new_seed % 1_000_000, Accounts.make_for_a_while)
  end

  def assert_held(*sentences)
    ['every cycle is there, and replays', *sentences].each do |sentence|
      refute_includes self.class.verdict.broken, "broken: #{sentence}"
    end
  end

  def test_SWR_AUTH_001_one_holds_at_a_time_in_a_fight
    assert_held 'one holds at a time, and it is who is shown'
    puts "SWR-AUTH-001: #{self.class.verdict.counts}"
  end

  def test_SWR_AUTH_003_nobody_is_obeyed_without_authority_in_a_fight
    assert_held 'nobody is obeyed who does not have it', 'each command is answered, and each refusal has a name'
    assert_operator self.class.verdict.counts['refused'], :>, 0
  end

  def test_SWR_AUTH_004_a_stop_is_everyones_in_a_fight
    assert_held 'a stop is refused to nobody for want of authority'
  end

  def test_SWR_AUTH_005_nothing_moves_after_its_holder_in_a_fight
    assert_held 'an order is of who has it, and does not outlive that', 'without who armed its order no axis is driven'
  end

  def test_SWR_AUTH_006_the_axes_rest_between_two_holders_in_a_fight
    assert_held 'between two holders the axes rest'
  end

  def test_SWR_AUTH_008_a_holder_loses_it_to_another_by_the_button_alone_in_a_fight
    assert_held 'who takes it has commanded it, or pressed the button for it'
  end
end
