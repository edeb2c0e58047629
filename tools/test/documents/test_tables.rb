# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: the manual states a reason, a status or a limit as its source does, or a gate fails.

require 'fileutils'
require 'minitest/autorun'
require 'open3'
require 'tmpdir'
require_relative '../../documents/card_tables'

class TestTables < Minitest::Test
  TOOL = File.expand_path('../../tables.rb', __dir__)

  COLOURS = <<~YAML
    header: colour
    says: Colours.
    enumerations:
      - name: colour
        says: Why not.
        values:
          - {code: 0, name: RED, says: "It is red: wait."}
          - {code: 1, name: BLUE, says: "It is blue | green: go."}
    structures:
      - name: paint
        fields:
          - {name: colour, type: colour, says: "Of the paint.", shown: {in: tin, as: name}}
          - {name: tins, type: uint32, count: TIN_COUNT}
          - {name: price, type: int32, column: {place: 1, name: costs}}
  YAML

  MESSAGES = <<~YAML
    messages:
      - {name: tin, says: A tin.}
  YAML

  LIMITS = <<~YAML
    - id: SWR-AREA-001
      title: A limit
      limits:
        - {name: wait_us, value: 250, unit: us, status: proposed}
  YAML

  MANUAL = <<~MARKDOWN
    # Manual

    <!-- table:colour -->
    | an old row |
    <!-- end -->

    Between.

    <!-- table:limits -->
    <!-- end -->
    After.

    <!-- table:paint -->
    <!-- end -->
  MARKDOWN

  FILLED = <<~'MARKDOWN'
    # Manual

    <!-- table:colour -->
    | No. | Name | What it says |
    | --- | --- | --- |
    | 0 | `RED` | It is red: wait. |
    | 1 | `BLUE` | It is blue \| green: go. |
    <!-- end -->

    Between.

    <!-- table:limits -->
    | Limit | Value | Unit | Requirement |
    | --- | --- | --- | --- |
    | `wait_us` | 250 | us | SWR-AREA-001 |
    <!-- end -->
    After.

    <!-- table:paint -->
    | Field | Type | What it says | JSON | Column of the replay |
    | --- | --- | --- | --- | --- |
    | `colour` | uint32_t | colour_t. Of the paint. | `tin.colour` |  |
    | `tins` | uint32_t[TIN_COUNT] |  |  |  |
    | `price` | int32_t |  |  | `costs` |
    <!-- end -->
  MARKDOWN

  def test_SWR_TRACE_001_manual_of_this_project_is_not_stale
    output, status = Open3.capture2e('ruby', TOOL, '--check')
    assert status.success?, output
  end

  def test_SWR_TRACE_001_blocks_are_filled_and_the_rest_is_kept
    in_project(MANUAL) do |root|
      assert_empty run_tool(root).first
      assert_equal FILLED, File.read(File.join(root, 'docs', 'user-manual.md'))
    end
  end

  WAITS = <<~YAML
    - {command: make a, when: ' later', seconds: [3, 10], says: mostly}
    - {command: make b, seconds: [60, 240]}
    - {command: make c, seconds: gates, machine: an abacus}
  YAML

  # The last one alone, after the others beside each other.
  GATES = <<~YAML
    - {name: one, says: One., seconds: 600, run: 'true'}
    - {name: two, says: Two., seconds: 300, run: 'true'}
    - {name: last, says: Last., seconds: 60, alone: true, run: 'true'}
  YAML

  def test_SWR_TOOL_036_how_long_commands_take_is_filled_from_the_gates_and_from_what_was_measured
    assert_equal ['| `make a` later | 3 to 10 s; mostly |', '| `make b` | 1 to 4 minutes |'], waits_of(GATES).first(2)
  end

  def test_SWR_TOOL_045_how_long_the_gates_take_follows_their_sum_and_names_the_machine
    assert_equal '| `make c` | 11 minutes on an abacus |', waits_of(GATES).last
    assert_equal '| `make c` | 21 minutes on an abacus |', waits_of(GATES.sub('600', '1200')).last
  end

  def waits_of(gates)
    in_project("<!-- table:waits -->\n<!-- end -->\n") do |root|
      FileUtils.mv("#{root}/docs/user-manual.md", "#{root}/README.md")
      FileUtils.mkdir_p(["#{root}/tools/documents", "#{root}/verification"])
      File.write("#{root}/tools/documents/waits.yml", WAITS)
      File.write("#{root}/verification/gates.yml", gates)
      assert_empty run_tool(root).first
      return File.readlines("#{root}/README.md", chomp: true)[3..5]
    end
  end

  def test_SWR_TRACE_001_filling_twice_changes_nothing
    in_project(FILLED) do |root|
      run_tool(root)
      assert_equal FILLED, File.read(File.join(root, 'docs', 'user-manual.md'))
    end
  end

  def test_SWR_TRACE_001_check_names_each_stale_table_and_leaves_the_file
    in_project(MANUAL) do |root|
      output, is_passed = run_tool(root, '--check')
      refute is_passed
      assert_equal <<~TEXT, output
        docs/user-manual.md:3: table colour is stale; run ruby tools/tables.rb
        docs/user-manual.md:9: table limits is stale; run ruby tools/tables.rb
        docs/user-manual.md:13: table paint is stale; run ruby tools/tables.rb
      TEXT
      assert_equal MANUAL, File.read(File.join(root, 'docs', 'user-manual.md'))
    end
  end

  def test_SWR_TRACE_001_check_finds_a_changed_sentence
    in_project(FILLED, colours: COLOURS.sub('wait.', 'wait longer.')) do |root|
      output, is_passed = run_tool(root, '--check')
      refute is_passed
      assert_equal "docs/user-manual.md:3: table colour is stale; run ruby tools/tables.rb\n", output
    end
  end

  def test_SWR_TRACE_001_check_passes_a_fresh_manual
    in_project(FILLED) do |root|
      assert_equal ['', true], run_tool(root, '--check')
    end
  end

  def test_SWR_TRACE_001_axes_are_those_of_the_robots
    in_project("<!-- table:robots -->\n<!-- end -->\n") do |root|
      folder = File.join(root, 'core/robot/bench2')
      FileUtils.mkdir_p(folder)
      text = File.read(File.expand_path('../../../core/robot/bench2/robot.yml', __dir__))
      File.write(File.join(folder, 'robot.yml'), text.sub('minimum_ticks: -6000', 'minimum_ticks: -5900'))
      assert_empty run_tool(root).first
      assert_includes File.read(File.join(root, 'docs', 'user-manual.md')),
                      '| `bench2` | slide | 2 | -59.0 to 0.0 mm | switch, upper end | 2 |  |'
    end
  end

  def test_SWR_TRACE_001_refuses_a_table_without_source
    in_project("<!-- table:shape -->\n<!-- end -->\n") do |root|
      output, is_passed = run_tool(root)
      refute is_passed
      cards = CardTables::NAMES.keys.sort.join(', ')
      assert_equal "docs/user-manual.md:1: there is no table shape; there are answers, bound, #{cards}, colour, commands, decisions, known_limits, " \
                   "limits, modes, paint, problems, proofs, proved, robots, rooms, routes, waits\n", output
    end
  end

  def test_SWR_TRACE_001_refuses_a_block_without_end
    in_project("<!-- table:colour -->\n<!-- table:limits -->\n<!-- end -->\n") do |root|
      output, is_passed = run_tool(root)
      refute is_passed
      assert_equal "docs/user-manual.md:1: the block has no end; write <!-- end -->\n", output
    end
  end

  private

  def run_tool(root, *arguments)
    output, status = Open3.capture2e('ruby', TOOL, *arguments, '--root', root)
    [output, status.success?]
  end

  def in_project(manual, colours: COLOURS)
    Dir.mktmpdir do |root|
      { 'core/interface/colours.yml' => colours, 'core/interface/messages.yml' => MESSAGES,
        'requirements/area.yml' => LIMITS, 'docs/user-manual.md' => manual }.each do |file, text|
        path = File.join(root, file)
        FileUtils.mkdir_p(File.dirname(path))
        File.write(path, text)
      end
      yield root
    end
  end
end
