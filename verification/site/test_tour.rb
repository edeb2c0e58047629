# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the commands and the output that docs/tour.md gives to its reader are true. Its commands for the chart compiler are run as
# they are written, its link is played, and what the page says is what site.e2e.ts reads there. `make client`, `make run` and
# the replay are tested elsewhere.

require 'minitest/autorun'
require 'open3'

class TestTour < Minitest::Test
  ROOT = File.expand_path('../..', __dir__)
  TOUR = File.read("#{ROOT}/docs/tour.md")
  BROWSER = File.read("#{ROOT}/app/console/e2e/site.e2e.ts")
  MODULES = %w[robot served].map { |name| "#{ROOT}/build/site/#{name}.wasm" }
  CYCLES = '2500'

  # Commands and output of the part with that number.
  def part(number)
    text = TOUR[/^## #{number}\. .*?(?=^## |\z)/m]
    [text.scan(/^ {4}(\S.*)$/).flatten, text.scan(/^ *> (.*)$/).flatten]
  end

  def test_SWR_SITE_022_what_the_page_says_is_what_is_read_there
    _, read = part(1)
    assert_equal(BROWSER.scan(/read: \[(.*?)\]/m).flat_map { |lines| lines.first.scan(/"([^"]+)"/) }.flatten, read)
  end

  def test_SWR_SITE_027_the_link_loses_the_card_in_motion
    link = part(1).first.find { |line| line.start_with?('#robot=') }
    said, status = Open3.capture2e('node', '--no-warnings', "#{__dir__}/played.mjs", *MODULES, link.delete_prefix('#'), CYCLES)
    assert status.success?, said
    assert_match(/^event PEDAL_PRESSED .*^event CARD_LOST 3/m, said)
  end

  # As step 5 goes on: the fault of the link is mended, and START_UP leads on from it.
  MENDED = ';2000:pedal,release;2300:card,3,normal;2800:WORKPHASE,workphase=START_UP;3000:pedal,press'

  def test_SWR_SITE_024_the_card_that_was_mended_is_homed_by_the_next_start_up
    link = part(1).first.find { |line| line.start_with?('#robot=') }
    said, status = Open3.capture2e('node', '--no-warnings', "#{__dir__}/played.mjs", *MODULES, link.delete_prefix('#') + MENDED, '4500')
    assert status.success?, said
    assert_match(/^event CARD_LOST 3.*^answer 2 ACCEPTED OK.*^event AXIS_HOMED 3/m, said)
  end

  def test_SWR_CHART_013_the_broken_guard_is_refused_in_these_words
    commands, read = part(2)
    refute_empty read
    said, status = Open3.capture2e('sh', '-c', commands.join("\n"), chdir: ROOT)
    assert_equal 1, status.exitstatus, said
    assert_equal read, said.lines(chomp: true)
  end
end
