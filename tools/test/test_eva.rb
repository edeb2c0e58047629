# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: Eva finds an error that is put into the core. A small part of it is followed, which takes seconds.

require 'fileutils'
require 'minitest/autorun'
require 'tmpdir'
require_relative '../eva/alarm_list'
require_relative '../eva/analysis'

class TestEva < Minitest::Test
  ROOT = File.expand_path('../..', __dir__)
  COPIED = %w[core build/gen verification/eva].freeze
  SOURCE = 'core/robot/robot_cards.c'
  CHECK = ' && (i < ROBOT_AXIS_MAX)'

  def test_SWR_TOOL_231_an_index_check_that_is_removed_is_a_new_alarm
    assert_empty problems_of_part { |code| code }
    assert_equal ["new alarm: #{SOURCE}: robot_cards_axis: index_bound: i < 10U"],
                 problems_of_part { |code| code.sub(CHECK, '') }
  end

  def test_SWR_TOOL_231_sources_that_cannot_be_read_are_no_result
    error = assert_raises(Eva::Failed) { problems_of_part { |code| code.sub('uint32_t found', 'unknown_t found') } }
    assert_includes error.message, 'Eva ended badly'
  end

  private

  # Of a small part of the core, with what the block makes of its source.
  def problems_of_part
    Dir.mktmpdir do |folder|
      COPIED.each do |name|
        FileUtils.mkdir_p(File.join(folder, File.dirname(name)))
        FileUtils.cp_r(File.join(ROOT, name), File.join(folder, name))
      end
      code = File.read(File.join(folder, SOURCE))
      File.write(File.join(folder, SOURCE), yield(code))
      analysis = Eva::Analysis.new('any_slot', [SOURCE, 'verification/eva/damaged_table.c'], "#{folder}/report", root: folder)
      Eva::AlarmList.new('', {}).problems('part', analysis.run.alarms)
    end
  end
end
