# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: each board that is not simulated is built beside the others, its programs are those of its folder, and one
# that cannot be opened ends the start with its own sentence.

require_relative '../../../verification/system/support/session_client'
require_relative '../../../verification/system/support/system_test'

class TestBuiltBoards < SystemTest
  PROGRAMS = File.expand_path('../../../build/boards/sbrio/bin', __dir__)
  WIRING = 'spidev:/dev/nowhere,slots=1-7,clock=5000000;gpio:/dev/gpiochip0,power=0'

  def test_SWR_TOOL_016_a_board_that_was_built_beside_has_its_own_options_and_support
    help = Open3.capture2e(File.join(PROGRAMS, 'boresight'), '--help').first
    assert_match(/^  --wiring TEXT +how the box is wired/, help)
    refute_match(/--slow|--fast|--real-time/, help)
    names = Open3.capture2e('nm', File.join(PROGRAMS, 'boresight-control')).first
    assert_match(/U gpiod_line_get_value/, names)
    refute_match(/ wire_attach/, names)
  end

  def test_SWR_TOOL_016_building_it_leaves_the_programs_of_the_simulated_box_as_they_are
    help = Open3.capture2e(Boresight.program('boresight'), '--help').first
    assert_match(/--slow/, help)
    refute_match(/--wiring/, help)
  end

  def test_SWR_TOOL_016_a_wiring_that_lacks_a_line_ends_the_start_with_a_sentence
    one = start(WIRING)
    assert_includes one.output, 'The wiring lacks the line "pedal_a"; add it to "gpio: ...".'
  end

  def test_SWR_TOOL_016_a_wiring_that_is_not_there_ends_the_start_with_a_sentence
    one = start('/nowhere/wiring')
    assert_includes one.output, 'The wiring "/nowhere/wiring" cannot be read (No such file or directory)'
  end

  private

  def start(wiring)
    Dir.mktmpdir do |folder|
      one = Boresight.new(arguments: ['--accounts', Accounts.make(File.join(folder, 'accounts')), '--wiring', wiring],
                          programs: PROGRAMS)
      one.launch
      refute_equal 0, one.wait_for_end
      one
    end
  end
end
