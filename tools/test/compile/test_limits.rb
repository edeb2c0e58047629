# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: a limit is stated in one place, and what is generated from it says the same.

require 'fileutils'
require 'json'
require 'minitest/autorun'
require 'open3'
require 'tmpdir'

class TestLimits < Minitest::Test
  TOOL = File.expand_path('../../compile/limits.rb', __dir__)
  ROOT = File.expand_path('../../..', __dir__)

  ITEM = <<~YAML
    - id: SWR-PEDAL-004
      title: Channels must agree
      text: The gate shall close.
      parents: [RC-001]
      limits:
        - {name: pedal_discrepancy_us, value: 100000, unit: us, status: proposed}
  YAML

  def test_SWR_TRACE_001_writes_a_constant_with_requirement_and_unit
    header, json = generate('pedal.yml' => ITEM)
    assert_includes header, "#define LIMIT_PEDAL_DISCREPANCY_US (100000U) /**< SWR-PEDAL-004, us. */\n"
    assert_includes header, '#ifndef BORESIGHT_REQUIREMENT_LIMITS_H'
    assert_equal [{ 'name' => 'pedal_discrepancy_us', 'value' => 100_000, 'unit' => 'us',
                    'status' => 'proposed', 'requirement' => 'SWR-PEDAL-004' }], JSON.parse(json)
  end

  def test_SWR_TRACE_001_the_same_limits_leave_their_files_as_they_are
    Dir.mktmpdir do |folder|
      files = %w[requirement_limits.h limits.json].map { |name| File.join(folder, name) }
      before = [ITEM, "#{ITEM}- id: SWR-PEDAL-005\n", ITEM.sub('100000', '100001')].map do |items|
        FileUtils.mkdir_p(File.join(folder, 'requirements'))
        File.write(File.join(folder, 'requirements/a.yml'), items)
        assert system('ruby', TOOL, File.join(folder, 'requirements'), folder)
        files.map { |file| File.mtime(file) }.tap { files.each { |file| File.utime(0, 0, file) } }
      end
      assert_equal [Time.at(0)] * 2, before[1]
      refute_includes before[2], Time.at(0)
    end
  end

  def test_SWR_TRACE_001_refuses_a_limit_stated_twice
    other = ITEM.sub('SWR-PEDAL-004', 'SWR-PEDAL-005')
    message = refuse('a.yml' => ITEM, 'b.yml' => other)
    assert_includes message, 'b.yml:6: limit pedal_discrepancy_us is already stated at'
    assert_includes message, 'a.yml:6'
  end

  def test_SWR_TRACE_001_refuses_a_value_that_is_no_32_bit_number
    ['-1', '1.5', '4294967296', 'five', '010'].each do |value|
      assert_includes refuse('a.yml' => ITEM.sub('100000', value)), "has the value \"#{value}\""
    end
  end

  def test_SWR_TRACE_001_takes_the_largest_32_bit_number
    header, = generate('a.yml' => ITEM.sub('100000', '4294967295'))
    assert_includes header, '(4294967295U)'
  end

  def test_SWR_TRACE_001_refuses_a_limit_without_unit_or_with_an_unknown_status
    assert_includes refuse('a.yml' => ITEM.sub('unit: us, ', '')), 'a.yml:6: limit pedal_discrepancy_us has no unit'
    assert_includes refuse('a.yml' => ITEM.sub('proposed', 'guessed')), 'has the status "guessed"'
  end

  def test_SWR_TRACE_001_refuses_a_file_that_is_no_list_of_items
    assert_includes refuse('a.yml' => "key: value\n"), 'a.yml:1: expected a list of items'
    assert_includes refuse('a.yml' => "- title: none\n"), 'a.yml:1: an item has no id'
    assert_includes refuse('a.yml' => "- id: SWR-A-001\n  id: SWR-A-002\n"), 'a.yml:2: id is given twice'
    assert_match(/a\.yml:\d+: /, refuse('a.yml' => "- id: [\n"))
  end

  def test_SWR_TRACE_001_gives_equal_bytes_on_each_run
    assert_equal generate_from(File.join(ROOT, 'requirements')), generate_from(File.join(ROOT, 'requirements'))
  end

  private

  def generate(files)
    with_folder(files) { |folder| generate_from(folder) }
  end

  def generate_from(folder)
    Dir.mktmpdir do |out|
      output, status = Open3.capture2e('ruby', TOOL, folder, out)
      assert status.success?, output
      %w[requirement_limits.h limits.json].map { |name| File.read(File.join(out, name)) }
    end
  end

  def refuse(files)
    with_folder(files) do |folder|
      output, status = Open3.capture2e('ruby', TOOL, folder, File.join(folder, 'out'))
      refute status.success?
      refute File.exist?(File.join(folder, 'out')), 'a refused input leaves nothing behind'
      output
    end
  end

  def with_folder(files)
    Dir.mktmpdir do |folder|
      files.each { |name, text| File.write(File.join(folder, name), text) }
      yield folder
    end
  end
end
