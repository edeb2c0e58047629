# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: what the manual says of a reason, a status or a limit is what its source says, or a gate fails.

require 'fileutils'
require 'minitest/autorun'
require 'open3'
require 'tmpdir'

class TestTables < Minitest::Test
  TOOL = File.expand_path('../tables.rb', __dir__)

  HEADER = <<~C
    /** Why not. */
    typedef enum {
        COLOUR_RED = 0,   /**< It is red: wait. */
        COLOUR_BLUE = 1   /**< It is blue | green: go. */
    } colour_t;
  C

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
      TEXT
      assert_equal MANUAL, File.read(File.join(root, 'docs', 'user-manual.md'))
    end
  end

  def test_SWR_TRACE_001_check_finds_a_changed_sentence
    in_project(FILLED, header: HEADER.sub('wait.', 'wait longer.')) do |root|
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

  def test_SWR_TRACE_001_refuses_a_table_without_source
    in_project("<!-- table:shape -->\n<!-- end -->\n") do |root|
      output, is_passed = run_tool(root)
      refute is_passed
      assert_equal "docs/user-manual.md:1: there is no table shape; there are colour, limits\n", output
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

  def in_project(manual, header: HEADER)
    Dir.mktmpdir do |root|
      { 'core/base/colour.h' => header, 'requirements/area.yml' => LIMITS, 'docs/user-manual.md' => manual }
        .each do |file, text|
          path = File.join(root, file)
          FileUtils.mkdir_p(File.dirname(path))
          File.write(path, text)
        end
      yield root
    end
  end
end
