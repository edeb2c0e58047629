# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: the manual says of a command neither a name that no element of the console shows, nor a request that does not
# send it.

require 'fileutils'
require 'minitest/autorun'
require 'open3'
require 'tmpdir'

class TestConsoleNames < Minitest::Test
  ROOT = File.expand_path('../../..', __dir__)
  MANUAL = 'docs/user-manual.md'

  # A tree with the interface, the elements of the console and the table of commands, filled.
  def with_manual
    Dir.mktmpdir do |folder|
      %w[core/interface core/robot app/console/src].each do |path|
        FileUtils.mkdir_p(File.dirname(File.join(folder, path)))
        FileUtils.cp_r(File.join(ROOT, path), File.join(folder, path))
      end
      FileUtils.mkdir_p(File.join(folder, 'docs'))
      File.write(File.join(folder, MANUAL), "<!-- table:commands -->\n<!-- end -->\n")
      assert_equal ['', true], tables(folder)
      yield folder, File.read(File.join(folder, MANUAL))
    end
  end

  # Output, and whether it succeeded.
  def tables(folder, *arguments)
    output, status = Open3.capture2e('ruby', File.join(ROOT, 'tools/tables.rb'), *arguments, '--root', folder)
    [output, status.success?]
  end

  def row(manual, command)
    manual.lines.find { |line| line.start_with?("| `#{command}` |") }.split('|').map(&:strip).drop(2)
  end

  def test_SWR_TOOL_320_a_command_without_an_element_has_no_name_in_the_console
    with_manual do |_, manual|
      %w[RENEW LIST_BEGIN PROGRAM_BEGIN ACCEPT_NO_BLACK_BOX].each { |command| assert_empty row(manual, command).first, command }
      { 'RELEASE' => 'Give up command', 'REQUEST' => 'Ask for the button', 'RESTORE' => 'Restore positions', 'JOG' => 'Jog',
        'RETRACT' => 'Retract needle', 'RUN_PROGRAM' => 'Run program', 'ENABLE_AXIS' => 'Enable' }.each do |command, name|
        assert_equal name, row(manual, command).first
      end
    end
  end

  def test_SWR_TOOL_320_a_name_whose_element_is_gone_is_found
    with_manual do |folder, _|
      element = File.join(folder, 'app/console/src/panels/log/LogNote.tsx')
      File.write(element, File.read(element).gsub('commands.NOTE', 'noted'))
      output, is_good = tables(folder, '--check')
      refute is_good
      assert_match(/#{MANUAL}/, output)
    end
  end

  def test_SWR_TOOL_321_a_request_that_empties_a_list_sends_its_beginning_alone
    with_manual do |_, manual|
      assert_equal '`POST /api/v1/trajectory`, `DELETE /api/v1/trajectory`', row(manual, 'LIST_BEGIN')[1]
      %w[LIST_ROW LIST_END].each { |command| assert_equal '`POST /api/v1/trajectory`', row(manual, command)[1] }
      %w[PROGRAM_STEP PROGRAM_END].each { |command| assert_equal '`POST /api/v1/program`', row(manual, command)[1] }
    end
  end
end
