# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: a document says no span of time, size or count but that of its source.

require 'fileutils'
require 'minitest/autorun'
require 'tmpdir'
require 'yaml'
require_relative '../../documents/prose_numbers'

class TestProseNumbers < Minitest::Test
  ROOT = File.expand_path('../../..', __dir__)
  FILES = {
    'requirements/a.yml' => "- {id: SWR-A-001, title: A, text: A., limits: [{name: wait_us, value: 10000000, unit: us, status: proposed}]}\n",
    'requirements/b.yml' => <<~YAML,
      - id: SWR-B-001
        title: B
        text: B.
        limits: [{name: turn_bam, value: 5965232, unit: bam, status: proposed}, {name: way_nm, value: 625000, unit: nm, status: proposed}]
    YAML
    'app/a.ts' => "export const OLD_MS = 1_500;\nexport const SEATS = 8;\n",
    'app/rows.rb' => "ROWS = 4_096\n"
  }.freeze

  def complaints_of(text, *entries)
    Dir.mktmpdir do |root|
      FILES.merge('docs/manual.md' => text, ProseNumbers::LIST => YAML.dump('docs/manual.md' => entries)).each do |file, content|
        FileUtils.mkdir_p(File.dirname(File.join(root, file)))
        File.write(File.join(root, file), content)
      end
      ProseNumbers.new(root).complaints
    end
  end

  def limit(says)
    { 'says' => says, 'limit' => 'wait_us' }
  end

  def constant(says)
    { 'says' => says, 'constant' => 'OLD_MS', 'file' => 'app/a.ts', 'unit' => 'ms' }
  end

  def test_SWR_TOOL_037_the_documents_say_what_their_sources_say
    assert_empty ProseNumbers.new(ROOT).complaints
  end

  def test_SWR_TOOL_037_what_is_equal_in_any_unit_is_accepted
    assert_empty complaints_of("It waits 10 s.\n\nIt is old after\n1.5 s.\n", limit('waits 10 s'), constant('after 1.5 s'))
    assert_empty complaints_of("Within ten seconds.\n", limit('Within ten seconds'))
  end

  def test_SWR_TOOL_037_another_value_is_named_with_its_source
    assert_equal ["docs/manual.md: 'waits 20 s', but wait_us is 10000000 us"], complaints_of("It waits 20 s.\n", limit('waits 20 s'))
    assert_equal ["docs/manual.md: 'after 2 s', but OLD_MS is 1500 ms"], complaints_of("Old after 2 s.\n", constant('after 2 s'))
  end

  def test_SWR_TOOL_037_a_span_without_a_source_is_named_with_its_line
    assert_equal ["docs/manual.md:3: '20 minutes' has no source in tools/documents/prose_numbers.yml"], complaints_of("# A\n\nIt takes 20\nminutes.\n")
  end

  def test_SWR_TOOL_037_a_source_of_what_is_not_said_is_named
    assert_equal ["tools/documents/prose_numbers.yml: docs/manual.md does not say 'waits 10 s'"], complaints_of("# A\n", limit('waits 10 s'))
  end

  def test_SWR_TOOL_037_an_example_says_why_it_has_none
    assert_empty complaints_of("Such as 12 s.\n", { 'says' => 'as 12 s', 'because' => 'an example' })
  end

  def test_SWR_TOOL_046_sizes_and_counts_are_those_of_their_sources
    says = { 'within 0.5 degrees' => 'turn_bam', 'and 0.625 mm' => 'way_nm' }.map { |words, name| { 'says' => words, 'limit' => name } }
    rows = { 'says' => '4,096 rows', 'constant' => 'ROWS', 'file' => 'app/rows.rb', 'unit' => 'rows' }
    assert_empty complaints_of("It is within 0.5 degrees and 0.625 mm of it, in 4,096 rows.\n", rows, *says)
  end

  def test_SWR_TOOL_046_another_size_another_measure_and_a_size_without_a_source_are_named
    assert_equal ["docs/manual.md: 'waits 9 MB', but wait_us is 10000000 us"], complaints_of("It waits 9 MB.\n", limit('waits 9 MB'))
    ['60 MB', '6,162 entries', '100 %', '0.1 mm', '1 µm', '5 mm/s', '24 counts', '55 kHz', '16 cycles'].each do |size|
      assert_equal ["docs/manual.md:1: '#{size}' has no source in tools/documents/prose_numbers.yml"], complaints_of("At #{size}, it ends.\n")
    end
    assert_empty complaints_of("Two cards, 5 words, 3 mm/min, 7 filesystems.\n")
  end

  def test_SWR_TOOL_046_a_count_without_a_unit_is_compared_where_it_is_listed
    rows = { 'says' => 'Eight can be', 'constant' => 'SEATS', 'file' => 'app/a.ts', 'unit' => 'seats' }
    assert_empty complaints_of("Eight can be open, four of one account.\n", rows)
    assert_equal ["docs/manual.md: 'Four can be', but SEATS is 8 seats"], complaints_of("Four can be open.\n", rows.merge('says' => 'Four can be'))
  end

  def test_SWR_TOOL_037_code_and_filled_tables_are_left_out
    assert_empty complaints_of("```\n5 s\n```\n\n    sleep 5 s\n\n<!-- table:x -->\n5 s\n<!-- end -->\n")
  end
end
