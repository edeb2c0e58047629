# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: operator and network receive the words of core/interface about a value, and a wrong file is
# refused with its line.

require 'minitest/autorun'
require_relative 'interface_folder'

class TestInterfaceCompiler < Minitest::Test
  include InterfaceFolder

  def test_SWR_CMD_004_compiled_names_and_sentences_are_those_of_the_file
    with_output do |folder|
      File.write(File.join(folder, 'main.c'), <<~CODE)
        #include "colour.h"
        #include "names.h"
        #include <stdio.h>
        int main(void)
        {
            for (int value = -1; value < 3; value++) {
                (void)printf("%s|%s\\n", colour_name(value), colour_text(value));
            }
            (void)printf("%s|%s\\n", colour_name(COLOUR_LAST), colour_text(COLOUR_LAST));
            return 0;
        }
      CODE
      assert_equal <<~TEXT, output_of(folder, 'main.c', 'app/names.c')
        UNKNOWN|Unknown.
        OK|Done.
        NOT_RED|It is not "red", but another colour.
        UNKNOWN|Unknown.
        LAST|The last.
      TEXT
    end
  end

  # Colours that two robots add.
  ROBOTS = {
    'colours.yml' => COLOURS.sub("says: Why something was refused.\n", "says: Why.\n    robots: refusals\n"),
    '../robot/ant/kinematics.yml' => <<~YAML,
      axes: {}
      refusals:
        - {code: 9, name: TOO_STEEP, says: "An ant cannot climb that."}
        - {code: 3, name: TOO_WET, says: "An ant cannot swim."}
    YAML
    '../robot/bee/kinematics.yml' => "axes: {}\n",
    '../robot/cat/kinematics.yml' => "refusals:\n  - {code: 8, name: TOO_COLD, says: \"No.\"}\n"
  }.freeze

  def test_SWR_ROBOT_020_what_robots_refuse_stands_among_the_others_by_its_code
    with_output(ROBOTS) do |folder|
      values = File.read(File.join(folder, 'colour.h')).scan(/COLOUR_\w+ = \d+/)
      assert_equal ['COLOUR_OK = 0', 'COLOUR_NOT_RED = 1', 'COLOUR_TOO_WET = 3', 'COLOUR_LAST = 7',
                    'COLOUR_TOO_COLD = 8', 'COLOUR_TOO_STEEP = 9'], values
      File.write(File.join(folder, 'main.c'), <<~CODE)
        #include "names.h"
        #include <stdio.h>
        int main(void)
        {
            (void)printf("%s|%s", colour_name(3), colour_text(9));
            return 0;
        }
      CODE
      assert_equal 'TOO_WET|An ant cannot climb that.', output_of(folder, 'main.c', 'app/names.c')
    end
  end

  def test_SWR_ROBOT_020_what_is_shared_is_the_same_wherever_it_stands
    alone = COLOURS.sub('      - {code: 7', %(      - {code: 3, name: TOO_WET, says: "An ant cannot swim."}\n\\0))
    with_robot = ROBOTS.slice('colours.yml').merge(
      '../robot/ant/kinematics.yml' => %(refusals:\n  - {code: 3, name: TOO_WET, says: "An ant cannot swim."}\n)
    )
    assert_equal layout('colours.yml' => alone), layout(with_robot)
  end

  def test_SWR_ROBOT_020_a_robot_has_no_code_and_no_name_that_another_has
    { 'code: 8' => ['code: 3', 'has the code of TOO_WET: 3'], 'name: TOO_COLD' => ['name: OK', 'has the name of OK: OK'],
      'says:' => ['said:', 'said: is unknown'] }.each do |old, (new, reason)|
      file = '../robot/cat/kinematics.yml'
      message = refusal(ROBOTS.merge(file => ROBOTS.fetch(file).sub(old, new)))
      assert_match(%r{cat/kinematics\.yml:2: }, message)
      assert_includes message, reason
    end
  end

  def test_SWR_ROBOT_020_robots_add_to_what_asks_for_it_alone
    with_output(ROBOTS.merge('colours.yml' => COLOURS)) do |folder|
      refute_includes File.read(File.join(folder, 'colour.h')), 'TOO_WET'
    end
  end

  def test_SWR_TOOL_011_structures_keep_their_documentation
    with_output do |folder|
      header = File.read(File.join(folder, 'colour.h'))
      assert_includes header, <<~CODE
        /** What is painted with. */
        typedef struct {
            /** colour_t. Of the paint. */
            uint32_t colour;
            /** lamp_state_t. */
            uint32_t lamp;
            /** Left in the tin. */
            uint32_t rest_ml;
            /** 0 or 1. */
            uint32_t is_dry;
        } paint_t;
      CODE
    end
  end

  COUNTED = COLOURS.sub('values:', "count: true\n    values:").sub('code: 7', 'code: 2')
                   .sub("structures:\n", "    sets:\n      - {name: SAD, says: \"Not wanted.\", values: [NOT_RED, LAST]}\nstructures:\n")

  def test_SWR_TOOL_011_a_set_is_a_bit_for_each_of_its_values
    with_output('colours.yml' => COUNTED) do |output|
      assert_includes(File.read(File.join(output, 'colour.h')), <<~'CODE')
        /** Bit n, value n: Not wanted. */
        #define COLOURS_SAD \
            (((uint64_t)1U << (uint32_t)COLOUR_NOT_RED) | \
             ((uint64_t)1U << (uint32_t)COLOUR_LAST))
      CODE
    end
  end

  def test_SWR_TOOL_012_refuses_a_set_of_what_there_is_not_or_that_has_no_bit
    assert_match(/GREEN/, refusal('colours.yml' => COUNTED.sub('[NOT_RED, LAST]', '[GREEN]')))
    uncounted = COUNTED.sub("    count: true\n", '')
    assert_match(/code above 63/, refusal('colours.yml' => uncounted.sub('code: 2', 'code: 64')))
    with_output('colours.yml' => uncounted.sub('code: 2', 'code: 63')) { |output| assert File.exist?(File.join(output, 'colour.h')) }
  end

  # A set whose values name it, where they stand.
  NAMING = COUNTED.sub(', values: [NOT_RED, LAST]', '').sub('of: axis', 'of: axis, sets: [SAD]').sub('name: OK', 'name: OK, sets: [SAD]')

  def test_SWR_TOOL_073_a_value_names_the_sets_that_it_is_in
    with_output('colours.yml' => NAMING) do |output|
      assert_includes(File.read(File.join(output, 'colour.h')), <<~'CODE')
        #define COLOURS_SAD \
            (((uint64_t)1U << (uint32_t)COLOUR_OK) | \
             ((uint64_t)1U << (uint32_t)COLOUR_LAST))
      CODE
    end
  end

  def test_SWR_TOOL_073_refuses_a_set_that_is_not_there_or_that_has_no_values
    assert_match(/colours\.yml:\d+: .* is GLAD; expected SAD/, refusal('colours.yml' => NAMING.sub('of: axis, sets: [SAD]', 'of: axis, sets: [GLAD]')))
    assert_match(/has SAD, which has no values/, refusal('colours.yml' => NAMING.gsub(', sets: [SAD]', '')))
  end

  def test_SWR_TOOL_011_an_event_has_severity_subject_and_value
    with_output do |folder|
      File.write(File.join(folder, 'main.c'), <<~CODE)
        #include "colour.h"
        #include "event_words.h"
        #include <stdio.h>
        int main(void)
        {
            (void)printf("%d %d %d\\n", (int)event_severity(EVENT_SPILT), (int)event_severity(EVENT_DRIED),
                         (int)event_severity((event_id_t)2));
            (void)printf("%s%s\\n", event_subject_name(EVENT_SPILT, 7U), event_value_unit(EVENT_SPILT));
            (void)printf("%d\\n", event_subject_owner(EVENT_SPILT, COLOUR_LAST) == EVENT_WORD_AXIS);
            (void)printf("%d %s\\n", event_subject_word(EVENT_DRIED) == EVENT_WORD_AXIS,
                         event_value_name(EVENT_DRIED, 1));
            (void)printf("%d\\n", event_peer_word(EVENT_CAUSE_AXIS) == EVENT_WORD_AXIS);
            return 0;
        }
      CODE
      assert_equal "1 0 1\nLAST ticks\n1\n1 at_last\n1\n",
                   output_of(folder, 'main.c', 'event.c', 'app/event_words.c', 'app/names.c')
    end
  end

  SHOWN = COLOURS.sub('says: "Of the paint."', 'says: "Of the paint.", shown: {in: tin, as: name, when: [is_dry]}')
                 .sub('lamp.state}', 'lamp.state, shown: tin}')
                 .sub('tin."}', 'tin.", unit: reading, shown: {in: tin, key: litres}}')

  def test_SWR_TOOL_011_a_value_that_is_none_of_those_counted_is_shown_as_null
    counted = SHOWN.sub('code: 7', 'code: 2').sub("says: Why something was refused.\n", "\\0    count: true\n")
                   .sub('when: [is_dry]', 'when: [colour]')
    with_output('colours.yml' => counted) do |folder|
      assert_includes File.read(File.join(folder, 'app/messages.c')), 'if ((paint->colour < COLOUR_COUNT)) {'
    end
  end

  def test_SWR_TOOL_011_console_knows_each_message_as_the_server_writes_it
    with_output('colours.yml' => SHOWN) do |folder|
      assert_includes File.read(File.join(folder, 'app/messages.c')), <<~CODE
        cJSON *json_tin(const paint_t *paint, const json_tin_t *also)
        {
            cJSON *const object = cJSON_CreateObject();
            if ((paint->is_dry != 0U)) {
                json_add_text(object, "colour", colour_name((int32_t)paint->colour));
            } else {
                json_add_null(object, "colour");
            }
            json_add_text(object, "lamp", chart_lamp_state_name(paint->lamp));
            json_add_number(object, "litres", (double)paint->rest_ml);
            if (also->maker != NULL) {
                json_add_text(object, "maker", also->maker);
            } else {
                json_add_null(object, "maker");
            }
            return object;
        }
      CODE
      types = File.read(File.join(folder, 'app/api.ts'))
      assert_includes types, <<~CODE
        export interface Tin {
          /** Of the paint. */
          colour: Colour | null;
          lamp: LampState;
          /** Left in the tin. */
          litres: number;
          maker: string | null;
        }
      CODE
      assert_includes types, %(export type Colour =\n  | "OK"\n  | "NOT_RED"\n  | "LAST";)
      assert_includes types, %(export type LampState =\n  | "dark"\n  | "bright";)
    end
  end

  def test_SWR_TOOL_011_console_checks_each_message_by_a_table
    messages = "#{MESSAGES}      - {name: size, type: [small, large]}\n      - {name: lid, type: lid}\n" \
               "      - {name: coats, type: uint32, maximum: 3, unit: count}\n      - {name: wear, type: int32, minimum: -5, unit: ratio}\n" \
               "  - name: lid\n    says: On top.\n    members:\n      - {name: tags, type: text, list: true}\n"
    with_output('colours.yml' => SHOWN, 'messages.yml' => messages) do |folder|
      types = File.read(File.join(folder, 'app/api.ts'))
      assert_includes types, <<~CODE
        export const Lid: Shape<Lid> = {
          members: {
            tags: ["list", "string"],
          },
        };

        export const Tin: Shape<Tin> = {
          members: {
            colour: ["null", Colour],
            lamp: LampState,
            litres: ["whole", 0, 4294967295],
            maker: ["null", "string"],
            size: ["words", ["small","large"]],
            lid: Lid,
            coats: ["whole", 0, 3],
            wear: ["whole", -5, 2147483647],
          },
        };
      CODE
      assert_includes types, %(export const LampState: Kind = ["words", ["dark","bright"]];)
    end
  end

  def test_SWR_TOOL_012_refuses_bounds_of_what_is_no_whole_number
    messages = MESSAGES.sub('or_null: true', 'maximum: 3')
    assert_includes refusal('colours.yml' => SHOWN, 'messages.yml' => messages), 'bounds what is no whole number'
  end

  # Fault of a number beside others of a tin; nil: none.
  def found_with(members)
    refusal('colours.yml' => SHOWN, 'messages.yml' => MESSAGES + members)
  end

  UNIT = "      - {name: unit, type: [mm, deg]}\n"

  def test_SWR_TOOL_028_a_number_has_its_unit_in_its_name_beside_it_or_says_what_it_is
    ["      - {name: width_mm, type: number}\n", "      - {name: bytes, type: uint64}\n",
     "#{UNIT}      - {name: width, type: number, unit: axis}\n", "      - {name: coats, type: uint32, unit: count}\n",
     "#{UNIT}      - {name: flow_per_s, type: number, unit: axis}\n",
     "      - {name: text, type: text}\n      - {name: value, type: int32, unit: text}\n"].each do |members|
      with_output('colours.yml' => SHOWN, 'messages.yml' => MESSAGES + members) { |folder| assert File.exist?(File.join(folder, 'app/api.ts')), members }
    end
  end

  def test_SWR_TOOL_028_refuses_a_number_without_a_unit
    { "      - {name: width, type: number}\n" => 'is the number width without a unit; end it in one of mm, um, deg',
      "      - {name: flow_per_s, type: number}\n" => 'is the number flow_per_s without a unit',
      "      - {name: summary, type: uint32}\n" => 'is the number summary without a unit',
      "      - {name: width, type: number, unit: axis}\n" => 'has the unit of width in unit, which is not there',
      "      - {name: value, type: int32, unit: text}\n" => 'has the unit of value in text, which is not there',
      "      - {name: width_mm, type: number, unit: count}\n" => 'is count, but width_mm ends in a unit',
      "      - {name: width, type: number, unit: inch}\n" => 'is inch; expected axis or count' }.each do |members, reason|
      message = found_with(members)
      assert_includes message, reason
      assert_match(/messages\.yml:6: /, message)
    end
    shown = SHOWN.sub('unit: reading, ', '')
    assert_includes refusal('colours.yml' => shown), 'is the number litres without a unit'
  end

  def test_SWR_TOOL_028_refuses_positions_and_speeds_of_axes_without_their_unit
    axis = "  - name: wheel\n    says: A wheel.\n    axis: true\n    members:\n      - {name: note, type: text}\n"
    messages = MESSAGES + axis
    field = ->(key, form) { SHOWN.sub('{in: tin, key: litres}', "{in: wheel, key: #{key}, as: #{form}}") }
    assert_includes refusal('colours.yml' => field.call('place', 'position'), 'messages.yml' => messages),
                    'has the unit of place in unit, which is not there'
    assert_includes refusal('colours.yml' => field.call('turn', 'speed'), 'messages.yml' => messages + UNIT),
                    'is the speed turn; expected a name that ends in _per_s'
    with_output('colours.yml' => field.call('turn_per_s', 'speed'), 'messages.yml' => messages + UNIT) do |folder|
      assert_includes File.read(File.join(folder, 'app/api.ts')), 'turn_per_s: number;'
    end
  end

  # The length of an array stands where its name says.
  def test_SWR_TOOL_011_a_header_includes_where_its_lengths_stand
    { 'COLOUR_COUNT' => [], 'LIMIT_TINS' => ['limits/requirement_limits.h'], 'ROBOT_AXIS_MAX' => ['robot/robot.h'] }
      .each do |count, expected|
        with_output('colours.yml' => TINS.sub('ROBOT_AXIS_MAX', count)) do |folder|
          assert_equal expected, File.read(File.join(folder, 'colour.h')).scan(/include "(.*)"/).flatten, count
        end
      end
  end

  TINS = <<~YAML
    #{COLOURS.chomp}
      - name: shelf
        fields:
          - {name: number, type: uint32}
          - {name: tins, type: paint, count: ROBOT_AXIS_MAX}
  YAML

  def test_SWR_TOOL_011_the_place_of_each_field_is_known
    with_output('colours.yml' => TINS) do |folder|
      FileUtils.mkdir_p(File.join(folder, 'robot'))
      File.write(File.join(folder, 'robot/robot.h'), "#define ROBOT_AXIS_MAX 3\n")
      File.write(File.join(folder, 'main.c'), <<~CODE)
        #include "fields.h"
        #include <stdio.h>
        int main(void)
        {
            for (const field_t *field = fields_shelf; field->name != NULL; field++) {
                (void)printf("%s %d %d %d %s\\n", field->name, (int)field->offset, (int)field->size,
                             (int)field->element_size, (field->inside == fields_paint) ? "paint" : "-");
            }
            (void)printf("%s\\n", fields_paint[2].name);
            (void)printf("%s\\n", fields_paint[0].word(0));
            return 0;
        }
      CODE
      assert_equal "number 0 4 4 -\ntins 4 48 16 paint\nrest_ml\nOK\n", output_of(folder, 'main.c', 'app/fields.c', 'app/names.c')
    end
  end

  def test_SWR_TOOL_011_same_bytes_on_every_run
    outputs = Array.new(2) { with_output { |folder| contents(folder) } }
    assert_equal outputs.first, outputs.last
  end

  # [what is written instead of what, the line, what the refusal says]
  REFUSALS = {
    'a value used twice' => ['code: 7', 'code: 1', 13, 'has the code of NOT_RED: 1'],
    'a name used twice' => ['name: LAST', 'name: OK', 13, 'has the name of OK: OK'],
    'a value without a sentence' => [', says: "The last."', '', 13, 'says: is missing'],
    'an empty sentence' => ['"The last."', '""', 13, 'is empty; expected a text'],
    'a name that is none in C' => ['name: LAST', 'name: Last', 13, 'is Last; expected a name of A-Z, 0-9 and _'],
    'a code that is no number' => ['code: 7', 'code: seven', 13, 'is seven; expected a whole number'],
    'an unknown key' => ['code: 7', 'codes: 7', 13, 'codes: is unknown'],
    'a gap in what is counted' => ["says: Why something was refused.\n", "says: Why.\n    count: true\n", 14,
                                   'has the code 7; expected 2, as it is counted'],
    'an unknown type' => ['type: uint32', 'type: uint33', 20, 'is uint33; expected uint32, int32'],
    'a chart that is none' => ['chart lamp.state', 'chart lamp.hue', 19, 'is of lamp.hue; expected one of lamp.state'],
    'bits of nothing' => ['type: uint32', 'type: bits shape', 20, 'is bits of shape, which is no enumeration'],
    'two fields of one name' => ['name: is_dry', 'name: rest_ml', 21, 'is the second rest_ml'],
    'padding behind it' => ['type: uint32', 'type: uint64', 21, 'has padding behind it'],
    'padding before a field' => ['{name: colour, type: colour',
                                 "{name: age, type: uint32}\n      - {name: c, type: uint64",
                                 19, 'has padding before c'],
    'a message that is none' => ['"Left in the tin."', '"x", shown: box', 20, 'is in box, which is no message'],
    'a form that is none' => ['"Left in the tin."', '"x", shown: {in: tin, as: cube}', 20, 'has the form cube'],
    'a form that does not fit' => ['"Left in the tin."', '"x", shown: {in: tin, as: named}', 20, 'uint32 has not'],
    'a condition that is none' => ['"Left in the tin."', '"x", shown: {in: tin, when: [colour]}', 20,
                                   'is shown when colour, which is no flag, no status and of nothing that is counted'],
    'the end of a comment' => ['"Left in the tin."', '"x */"', 20, 'holds the end of a comment']
  }.freeze

  REFUSALS.each do |what, (old, new, line, reason)|
    define_method("test_SWR_TOOL_012_refuses_#{what.tr(' ', '_')}") do
      assert_refused('colours.yml', COLOURS, old, new, line, reason)
    end
  end

  EVENT_REFUSALS = {
    'an event without severity' => [', severity: low', '', 20, 'has no severity'],
    'a severity that is none' => ['severity: low', 'severity: high', 20, 'is high; expected low or critical'],
    'a subject that is none' => ['subject: axis', 'subject: shape', 20, 'is shape; expected axis, card, part, length or an enumeration'],
    'a value that is none' => ['way: ticks', 'way: miles', 19,
                               'is miles; expected ticks, percent, nm, millionths, us, ms, min, hz, mn, tenths_c, count, number'],
    'a value without a name' => ['value: {way: ticks}', 'value: ticks', 19, 'has no name; expected {NAME: TYPE}'],
    'a value with two names' => ['{way: ticks}', '{way: ticks, time: ms}', 19, 'has 2 names; expected one'],
    'a unit that the sentence does not say' => ['way: ticks', 'way: tenths_c', 19, 'does not say tenths of a degree Celsius'],
    'a number as subject without a name' => ['subject: axis', 'subject: number', 20, 'is number without a name'],
    'three words for a flag' => ['[not_yet, at_last]', '[a, b, c]', 20, 'has 3 words; expected 2, for 0 and 1'],
    'a sentence with what is not there' => [', value: {way: ticks}', '', 19, 'says {value}, which it has not'],
    'a sentence without its value' => [' by {value}', '', 19, 'does not say {value}'],
    'a cause with what is not there' => [', peer: axis', '', 13, 'says {peer}, which it has not']
  }.freeze

  EVENT_REFUSALS.each do |what, (old, new, line, reason)|
    define_method("test_SWR_TOOL_012_refuses_#{what.tr(' ', '_')}") do
      assert_refused('events.yml', EVENTS, old, new, line, reason)
    end
  end

  def test_SWR_TOOL_483_the_value_of_an_event_has_a_name_and_a_type
    root = File.expand_path('../../..', __dir__)
    model = Interface::Model.new(File.join(root, 'core/interface'))
    values = model.events.events.to_h { |event| [event.value.name, event.about] }
    assert_equal ['correction, ticks', 'trouble, card_trouble', 'end, dwell or dose', nil],
                 values.values_at('AXIS_HOMED', 'CARD_UNWELL', 'PROGRAM_STEP', 'PEDAL_PRESSED')
    assert_includes Interface::EventWords.new(model).files['event_words.c'], "    case EVENT_CARD_HOT:\n        return \"temperature\";\n"
  end

  def test_SWR_TOOL_012_refuses_a_key_used_twice_in_a_message
    message = refusal('colours.yml' => COLOURS.sub('"Left in the tin."', '"x", shown: {in: tin, key: maker}'))
    assert_match(/messages\.yml:5: .* is the second maker in tin/, message)
  end

  def test_SWR_TOOL_012_refuses_a_name_defined_in_two_files
    assert_includes refusal('other.yml' => COLOURS.sub('header: colour', 'header: other')), 'colour: is defined twice'
  end

  def test_SWR_TOOL_012_refuses_what_is_no_yaml
    assert_match(/colours\.yml:\d+: file: is not YAML/, refusal('colours.yml' => "a: [\n"))
  end

  def test_SWR_TOOL_012_a_refusal_writes_nothing
    in_folder('colours.yml' => COLOURS.sub('code: 7', 'code: 1')) do |folder, output|
      run_tool(folder, output)
      refute File.exist?(output)
    end
  end
end
