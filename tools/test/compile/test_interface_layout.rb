# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: the number of a layout differs when a byte of the shared state means something else, and only then.

require 'minitest/autorun'
require_relative 'interface_folder'

class TestInterfaceLayout < Minitest::Test
  include InterfaceFolder

  ROOT = File.expand_path('../../..', __dir__)

  AGREED = {
    'a field has another name' => ['name: rest_ml', 'name: left_ml'],
    'a field has another type' => ['type: uint32', 'type: int32'],
    'a field is gone' => [/^ *- {name: is_dry, type: flag}\n/, ''],
    'an enumerator has another name' => ['name: LAST', 'name: FINAL'],
    'an enumerator has another number' => ['code: 7', 'code: 8']
  }.freeze

  AGREED.each do |what, (old, new)|
    define_method("test_SWR_TOOL_013_layout_differs_when_#{what.tr(' ', '_')}") do
      refute_equal layout, layout('colours.yml' => COLOURS.sub(old, new))
    end
  end

  def test_SWR_TOOL_013_layout_differs_when_a_chart_has_another_state
    refute_equal layout, layout('charts.json' => JSON.generate(CHARTS).sub('dark', 'dim'))
  end

  # Charts are states of the core, and stand in its checkpoints.
  def test_SWR_TOOL_013_layout_differs_when_a_chart_keeps_its_state_in_another_order
    chart = "typedef struct {\n    uint32_t lamp;\n    uint32_t motor;\n} lamp_chart_t;\n"
    swapped = "typedef struct {\n    uint32_t motor;\n    uint32_t lamp;\n} lamp_chart_t;\n"
    refute_equal layout('lamp_chart.h' => chart), layout('lamp_chart.h' => swapped)
  end

  def test_SWR_TOOL_013_each_header_of_the_state_counts
    headers, = Open3.capture2('make', '--no-print-directory', '--eval', 'names: ; @echo $(LAYOUT_HEADERS)', 'names', chdir: ROOT)
    reached, status = Open3.capture2('gcc', '-std=c99', '-Icore', '-Ibuild/gen', '-MM', 'core/controller/controller.h', chdir: ROOT)
    assert status.success?
    counted = headers.split.map { |header| header.delete_prefix("#{ROOT}/") }
    left = reached.scan(%r{[\w/]+\.h}).uniq - counted
    assert_empty(left.grep_v(%r{\Abuild/gen/(interface/|charts/\w+_chart\.h\z)}))
  end

  def test_SWR_TOOL_013_layout_differs_when_a_further_header_declares_something_else
    ["#define A 1\n", "#define B \\\n 2\n", 'typedef enum { A, B } a_t;',
     "typedef struct {\n    union { struct { int x; int y; } a; int b; } u;\n    int c;\n} a_t;"].each do |text|
      without, with, again, other = ['', text, "/* Words. */\n#{text.gsub(' ', '  ')}", text.sub(/\d|B|x/, 'z')]
                                    .map { |more| layout({ 'more.h' => more }, 'more.h') }
      assert_equal with, again, text
      refute_equal with, without, text
      refute_equal with, other, text
    end
  end

  def test_SWR_TOOL_013_layout_is_the_same_when_functions_of_a_further_header_differ
    type = 'typedef struct { int a; } a_t;'
    more = "#{type}\nvoid a_init(a_t *self);\nstatic inline int a_get(const a_t *self)\n{\n    return self->a;\n}\n"
    assert_equal layout({ 'more.h' => type }, 'more.h'), layout({ 'more.h' => more }, 'more.h')
  end

  def test_SWR_EXCH_022_the_fields_that_every_process_may_write_are_listed_with_their_counts
    segment = <<~C
      typedef struct {
          struct {
              uint32_t count SEGMENT_ON_LINE; /**< Of beats; not listed. */
          } beats[PROCESSES];
          uint64_t stops SEGMENT_ON_LINE; /**< A semicolon; in words. */
          uint32_t files[3] SEGMENT_ON_LINE;
          segment_note_t note;
      } segment_others_t;
    C
    in_folder('more.h' => segment) do |folder, output|
      run_tool(folder, output, 'more.h')
      listed = File.read(File.join(output, 'segment_fields.h'))[/#define SEGMENT_OTHERS_FIELDS.*/m].scan(/^    FIELD\((.*?)\)/).flatten
      assert_equal ['beats, PROCESSES', 'stops, 1U', 'files, 3', 'note, 1U'], listed
    end
  end

  def test_SWR_TOOL_013_layout_is_the_same_when_words_differ
    assert_equal layout, layout('colours.yml' => COLOURS.gsub('The last.', 'The very last.').gsub('tin.', 'can.'))
  end
end
