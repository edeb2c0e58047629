# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the programs of a board that is not simulated enable no drive on a computer that is not fit for it. They are
# those that are delivered; behind them are simulated cards, and no box.

require_relative 'support/page_test'

class TestRealBoard < Minitest::Test
  include PageTest

  BOARDS = File.expand_path('../../build/boards', __dir__)
  # Slow, so that the self test of its wires fails on no machine that pauses.
  WIRING = 'spidev:/dev/null,slots=1-7,clock=100000000;gpio:/dev/gpiochip0,pedal_a=0,pedal_b=1,estop=2,scanner=3,confirm=4,' \
           'dose=5,treatment=6,power=8,lamp_alive=9,lamp_may_move=10,lamp_moving=11,lamp_fault=12;slow:50'
  # Root gets the right to a priority whatever its limit is.
  WITHOUT_RIGHTS = [*%w[prlimit --rtprio=0 --memlock=65536],
                    *(%w[setpriv --bounding-set=-sys_nice,-ipc_lock] if Process.uid.zero?)].freeze

  def self.boresight
    @boresight ||= Boresight.start(
      arguments: ['--accounts', accounts, '--wiring', WIRING], programs: "#{BOARDS}/sbrio/bin",
      prefix: [*WITHOUT_RIGHTS, 'env', "LD_PRELOAD=#{BOARDS}/pretended_box.so"]
    )
  end

  def test_SWR_CHECK_008_no_drive_is_enabled_while_a_check_stands
    anna = client('anna').tap(&:take)
    assert_includes fetch_json('/api/v1/status').dig('loop', 'computer').map { |check| check['name'] }, 'RIGHTS'
    assert_includes boresight.output, 'control: this computer cannot drive a real robot:'
    assert_answer '409', 'COMPUTER_UNFIT', anna.act('workphase', { workphase: 'START_UP' })
    assert_answer '409', 'COMPUTER_UNFIT', anna.act('motors/yaw/enable')
    assert_equal ['disabled'], fetch_json('/api/v1/motors')['axes'].map { |axis| axis['power'] }.uniq
    assert_equal '200', boresight.post_stop.code
  end

  # The wiring that control opens is no name: another text of the wiring must find the same positions.
  def test_SWR_STORE_031_positions_are_kept_for_the_instance_whatever_its_wiring_says
    assert_operator WIRING.size, :>, 200
    wait_until('they are kept') { kept == ["positions-#{boresight.instance}", "positions-#{boresight.instance}.key"] }
  end

  def kept
    Dir.children(boresight.recordings).grep(/\Apositions-/).sort
  end
end
