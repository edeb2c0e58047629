# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'fileutils'
require 'minitest/autorun'
require 'tmpdir'
require_relative '../functions'

# Rule under test: no written function of the product is longer or more complex than its limits; one that is, is named.
class TestFunctions < Minitest::Test
  ROOT = File.expand_path('../..', __dir__)
  CONSOLE = File.read(File.join(ROOT, 'app/console/eslint.config.js'))

  def test_SWR_TOOL_074_the_functions_of_the_product_are_within_their_limits
    assert_empty Functions.new(ROOT).problems
  end

  def test_SWR_TOOL_074_the_console_has_the_same_limits
    assert_includes CONSOLE, "complexity: [\"error\", #{Functions::COMPLEXITY}]"
    assert_includes CONSOLE, "\"max-lines-per-function\": [\"error\", #{Functions::LINES}]"
  end

  def test_SWR_TOOL_074_a_long_function_is_named_with_its_lines
    assert_empty problems_of(long(56))
    assert_equal ['core/base/a.c:2: a has 61 lines, at most 60'], problems_of(long(57))
  end

  def test_SWR_TOOL_074_a_complex_function_is_named_whether_it_asks_or_switches
    assert_empty problems_of(asking(14))
    assert_equal ['core/base/a.c:2: a has a complexity of 16, at most 15'], problems_of(asking(15))
    assert_equal ['core/base/a.c:2: a has a complexity of 17, at most 15'], problems_of(switching(16))
  end

  def test_SWR_TOOL_074_the_numbers_of_a_table_are_no_lines_of_its_function
    rows = "        {0x00000000U, 0xA2158B34U},\n" * 80
    assert_empty problems_of("\nint a(int x)\n{\n    static const int t[80][2] = {\n#{rows}    };\n    return t[x][0];\n}\n")
  end

  def test_SWR_TOOL_074_generated_code_and_tests_are_left_out
    in_tree('build/gen/a.c' => long(99), 'core/robot/ant/test/a.c' => long(99)) { |root| assert_empty Functions.new(root).problems }
  end

  private

  # With this many statements.
  def long(count)
    "\nint a(int x)\n{\n#{"    x++;\n" * count}    return x;\n}\n"
  end

  def asking(count)
    "\nint a(int x)\n{\n#{"    if (x > 1) { x++; }\n" * count}    return x;\n}\n"
  end

  def switching(count)
    cases = (1..count).map { |value| "    case #{value}:\n        return #{value};\n" }.join
    "\nint a(int x)\n{\n    switch (x) {\n#{cases}    default:\n        return 0;\n    }\n}\n"
  end

  def problems_of(text)
    in_tree('core/base/a.c' => text) { |root| Functions.new(root).problems }
  end

  def in_tree(files)
    Dir.mktmpdir do |root|
      files.each do |name, text|
        FileUtils.mkdir_p(File.dirname(File.join(root, name)))
        File.write(File.join(root, name), text)
      end
      yield root
    end
  end
end
