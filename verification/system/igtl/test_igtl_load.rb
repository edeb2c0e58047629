# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: fifteen clients that ask as fast as they are answered while the robot moves are all answered, and STOP
# is obeyed. How long it takes is shown by `make bench`, and judged nowhere.

require_relative '../support/system_test'
require_relative '../../bench/load'

class TestIgtlLoad < SystemTest
  SECONDS = 2

  def test_SWR_IGTL_048_every_question_of_fifteen_clients_is_answered_during_a_move
    seen = Load.measure(boresight, 'START_UP', SECONDS)
    assert_operator seen['questions'], :>, 100
    assert_equal seen['questions'], seen['answers']
    assert_equal seen['commands'], seen['acknowledgements']
    assert seen['was_moving']
    wait_until('nothing is driven') { !boresight.moving? }
    assert_equal 'STOP', boresight.status.dig('workphase', 'name')
  end
end
