# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: no document says what goes stale by itself, or where its reader would have to search.

require 'fileutils'
require 'minitest/autorun'
require 'tmpdir'
require_relative '../../prose'

class TestProse < Minitest::Test
  ROOT = File.expand_path('../../..', __dir__)

  def complaints_of(text, file = 'docs/manual.md')
    Dir.mktmpdir do |root|
      FileUtils.mkdir_p(File.join(root, File.dirname(file)))
      File.write(File.join(root, file), text)
      Prose.new(root).complaints
    end
  end

  def test_SWR_TOOL_027_the_documents_say_nothing_that_goes_stale
    assert_empty Prose.new(ROOT).complaints
  end

  Prose::STALE.each do |phrase|
    define_method("test_SWR_TOOL_027_#{phrase.tr(' ', '_')}_is_named_with_its_line") do
      assert_equal ["docs/manual.md:3: '#{phrase}' goes stale, or names no place"], complaints_of("# Manual\n\nThis is #{phrase} so.\n")
    end
  end

  def test_SWR_TOOL_027_a_phrase_over_two_lines_is_found
    assert_equal ["README.md:1: 'Not yet' goes stale, or names no place"], complaints_of("Not\nyet there.\n", 'README.md')
  end

  def test_SWR_TOOL_038_texts_of_the_console_and_of_the_interface_are_read_without_their_comments
    found = "docs/x: 'as above' goes stale, or names no place"
    %w[app/console/src/panels/procedure/Aim.tsx app/console/index.html core/interface/steps.yml].each do |file|
      assert_equal [found.sub('docs/x', "#{file}:2")], complaints_of("\n<p>As it is, as above.</p>\n", file)
    end
    assert_empty complaints_of("// As above.\n/* Not\n yet. */\n", 'app/console/src/a.ts')
    assert_empty complaints_of("# Not yet.\n", 'core/interface/a.yml')
    assert_empty complaints_of("as above\n", 'app/console/src/a.test.ts')
  end

  def test_SWR_TOOL_027_code_and_parts_of_words_are_none
    assert_empty complaints_of("```\nnot yet\n```\nThe state `not yet`, a concurrently running program.\n")
  end
end
