# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: a mode and its command are one row, from which the tables, the calls into its folder and the words of
# OpenIGTLink are made; a wrong row is refused with its line.

require 'minitest/autorun'
require_relative 'interface_folder'

class TestInterfaceModes < Minitest::Test
  include InterfaceFolder

  MODES = <<~YAML
    header: mode_list
    says: Modes.
    enumerations:
      - {name: workphase, says: Where., values: [{code: 0, name: HERE, says: "Here."}, {code: 1, name: THERE, says: "There."}]}
      - {name: mode_axes, says: Whose., values: [{code: 0, name: ALL, says: "All."}]}
      - {name: mode_needle, says: What., values: [{code: 0, name: NONE, says: "None."}]}
      - name: command_kind
        prefix: COMMAND
        says: By what.
        modes: commands
        values: [{code: 0, name: NONE, says: "No."}, {code: 1, name: WORKPHASE, says: "W."}]
      - name: mode_kind
        prefix: MODE
        says: What.
        count: true
        values:
          - {code: 0, name: NONE, command: NONE, workphases: [], unhomed: true, axes: ALL, needle: NONE, says: "Nothing."}
          - {code: 1, name: WAIT, command: WORKPHASE, workphases: [HERE], unhomed: true, axes: ALL, needle: NONE, says: "It waits."}
          - {code: 2, name: GO, workphases: [HERE, THERE], unhomed: false, axes: ALL, needle: NONE, says: "It goes.", own: true,
             ask: [own], judge: [axis], step: [own, leg], commands: [{code: 2, name: GO, from: [PAGE, NETWORK], says: "Go."}]}
          - {code: 3, name: REST, command: WORKPHASE, workphases: [THERE], unhomed: true, axes: ALL, needle: NONE, says: "It rests."}
      - {name: mode_aim, says: What., values: [{code: 0, name: NONE, says: "None."}]}
  YAML

  def test_SWR_TOOL_011_the_table_of_modes_says_what_is_special_about_each
    with_output('modes.yml' => MODES) do |folder|
      assert_includes File.read(File.join(folder, 'mode_list.c')), <<~CODE
        [MODE_GO] = {.command = (uint32_t)COMMAND_GO,
                 .workphases = IN(WORKPHASE_HERE) | IN(WORKPHASE_THERE),
                 .axes = (uint32_t)MODE_AXES_ALL,
                 .needle = (uint32_t)MODE_NEEDLE_NONE,
                 .aim = (uint32_t)MODE_AIM_NONE,
                 .is_by_hand = false,
                 .may_be_unhomed = false},
      CODE
    end
  end

  def test_SWR_TOOL_081_a_row_becomes_the_calls_that_it_names
    with_output('modes.yml' => MODES) do |folder|
      source = File.read(File.join(folder, 'mode_dispatch.c'))
      assert_equal ['go_mode_ask(asked, &request.own.go)', 'go_mode_judge(request->sealed.way.axis, robot, axes)',
                    'go_mode_step(&self->request.own.go, &self->sealed.leg, frame, result)'], source.scan(/go_mode_\w+\(.*\)/)
      assert_includes source, "case (uint32_t)COMMAND_GO:\n        found = MODE_GO;"
      assert_includes source, '[MODE_GO] = {.from = (uint32_t)offsetof(mode_own_t, go),'
      assert_includes source, '#include "mode/go/go_mode.h"'
      refute_match(/wait|rest_mode/i, source)
      assert_match(/typedef struct \{\n    go_mode_t go;\n\} mode_own_t;/, File.read(File.join(folder, 'mode_own.h')))
    end
  end

  def test_SWR_TOOL_081_an_axis_that_a_command_says_is_that_of_its_mode
    text = COMMANDS.sub('from: [PAGE, NETWORK]', 'payload: axis, from: [PAGE]').sub('ask: [own], ', '')
                   .sub('structures:', "structures:\n  - {name: command_axis, fields: [{name: axis, type: uint32}]}")
    with_output('commands.yml' => text) do |folder|
      assert_includes File.read(File.join(folder, 'mode_dispatch.c')), 'request.sealed.way.axis = command_as_axis(asked->command)->axis;'
    end
  end

  def test_SWR_TOOL_081_other_modes_are_another_layout
    refute_equal layout('modes.yml' => MODES),
                 layout('modes.yml' => MODES.sub(', own: true', '').sub('ask: [own], ', '').sub('step: [own, leg]', 'step: [leg]'))
  end

  def test_SWR_TOOL_083_the_words_of_a_command_are_of_its_row
    rows = COMMANDS.sub('payload: workphase, says', 'payload: workphase, words: [{word: STAY, as: {workphase: HERE}}], says')
                   .sub('payload: turn, workphases', 'payload: turn, words: [{word: TURN, form: "TURN 5"}], workphases')
    with_output('commands.yml' => rows) do |folder|
      assert_includes File.read(File.join(folder, 'app', 'igtl_words.c')), <<~CODE
        const workphase_command_t workphase_commands[] = {
            {.word = "STAY",
             .kind = COMMAND_WORKPHASE,
             .as.workphase = {.workphase = (uint32_t)WORKPHASE_HERE}},
            {.word = "TURN",
             .kind = COMMAND_TURN,
             .reader = workphase_read_turn,
             .form = "TURN 5"},
        };
      CODE
    end
    old = 'from: [PAGE, NETWORK], says'
    assert_refused('commands.yml', COMMANDS, old, 'from: [PAGE], words: [{word: GO, form: "GO 1"}], says', 26,
                   'has as or form, but its command says nothing more')
  end

  COMMANDS = MODES.sub('prefix: COMMAND', "prefix: COMMAND\n    count: true")
                  .sub(/^    values: \[\{code: 0, name: NONE, says: "No.*$/, <<~YAML.gsub(/^/, '    ').rstrip)
                    values:
                      - {code: 0, name: NONE, from: [], says: "No."}
                      - {code: 1, name: WORKPHASE, from: [PAGE], obeyed_by: workphase, payload: workphase, says: "W."}
                      - {code: 3, name: TURN, from: [PAGE], obeyed_by: turn, payload: turn, workphases: [THERE], says: "Turn."}
                      - {code: 4, name: TURN_BACK, from: [], obeyed_by: turn, payload: turn, says: "Turn back."}
                  YAML
                  .sub('  - name: mode_kind', <<~YAML.gsub(/^/, '  ').rstrip).concat(<<~YAML)
                    - {name: command_source, says: Who., values: [{code: 0, name: NETWORK, says: "N."}, {code: 1, name: PAGE, says: "P."}]}
                    - name: mode_kind
                  YAML
                    structures:
                      - {name: command_workphase, fields: [{name: workphase, type: workphase}]}
                      - {name: command_turn, fields: [{name: axis, type: uint32}, {name: by_ticks, type: int32}]}
                      - {name: command, fields: [{name: kind, type: command_kind}, {name: as, type: payload command_kind}]}
                  YAML

  def test_SWR_TOOL_011_the_table_of_commands_says_where_each_is_obeyed
    with_output('commands.yml' => COMMANDS) do |folder|
      source = File.read(File.join(folder, 'command.c'))
      assert_includes source, '[COMMAND_WORKPHASE] = {.workphases = IN_ALL,'
      assert_includes source, "[COMMAND_GO] = {.workphases = IN(WORKPHASE_HERE) |\n        IN(WORKPHASE_THERE),"
      assert_includes source, '[COMMAND_TURN] = {.workphases = IN(WORKPHASE_THERE),'
      assert_includes File.read(File.join(folder, 'mode_list.h')), '/** Turn. Only in THERE. */'
      assert_includes File.read(File.join(folder, 'app', 'names.c')), 'return "Only in HERE or THERE.";'
    end
  end

  def test_SWR_TOOL_080_what_a_command_says_is_a_member_of_one_union_with_an_accessor
    with_output('commands.yml' => COMMANDS) do |folder|
      assert_includes File.read(File.join(folder, 'mode_list.h')), <<~CODE
        typedef union {
            command_workphase_t workphase; /**< WORKPHASE. */
            command_turn_t turn; /**< TURN, TURN_BACK. */
        } command_payload_t;
      CODE
      assert_includes File.read(File.join(folder, 'command_access.c')), <<~CODE
        const command_turn_t *command_as_turn(const command_t *command)
        {
            REQUIRE(2U, has_form(command, COMMAND_FORM_TURN));
            return &command->as.turn;
        }
      CODE
      assert_match(/case 3:\n    case 4:\n        return fields_command_turn;/, File.read(File.join(folder, 'app', 'fields.c')))
    end
  end

  def test_SWR_TOOL_080_who_may_send_a_command_and_what_carries_it_out_are_of_its_row
    with_output('commands.yml' => COMMANDS) do |folder|
      assert_includes File.read(File.join(folder, 'command.c')), '.sources = BY(COMMAND_SOURCE_PAGE) | BY(COMMAND_SOURCE_NETWORK),'
      assert_includes File.read(File.join(folder, 'command_dispatch.c')), <<~CODE
        case (uint32_t)COMMAND_TURN:
            case (uint32_t)COMMAND_TURN_BACK:
                status = controller_obey_turn(self, cycle, command, answer);
      CODE
    end
  end

  COMMAND_REFUSALS = {
    'a command without senders' => ['from: [PAGE, NETWORK], says', 'says', 26, 'has no from'],
    'a sender that there is not' => ['from: [PAGE, NETWORK]', 'from: [NOBODY]', 26, 'is NOBODY; expected NETWORK or PAGE'],
    'a command that nothing carries out' => ['from: [], obeyed_by: turn,', 'from: [],', 16, 'has no obeyed_by and arms no mode'],
    'a function for a command that arms a mode' => ['name: GO, from: [PAGE, NETWORK],', 'name: GO, from: [PAGE, NETWORK], obeyed_by: go,',
                                                    26, 'stands with a command that arms a mode'],
    'a payload without its structure' => ['payload: workphase', 'payload: phase', 14, 'is phase; expected a structure command_NAME']
  }.freeze

  COMMAND_REFUSALS.each do |what, (old, new, line, reason)|
    define_method("test_SWR_TOOL_080_refuses_#{what.tr(' ', '_')}") { assert_refused('commands.yml', COMMANDS, old, new, line, reason) }
  end

  def test_SWR_TOOL_080_refuses_a_structure_that_is_of_no_command
    changed = COMMANDS.sub('name: command_turn', 'name: command_bend').gsub('payload: turn, ', '')
    assert_includes refusal('commands.yml' => changed), 'command_bend: is the payload of no command'
  end

  def test_SWR_TOOL_012_refuses_workphases_of_a_command_that_arms_a_mode
    old = 'name: GO, from: [PAGE, NETWORK], says: "Go."'
    assert_refused('commands.yml', COMMANDS, old, old.sub('says', 'workphases: [HERE], says'), 26, 'stand with the mode GO')
  end

  MODE_REFUSALS = {
    'a mode without axes' => ['workphases: [HERE], unhomed: true, axes: ALL', 'workphases: [HERE], unhomed: true', 18, 'has no axes'],
    'a mode in no workphase' => ['[HERE, THERE]', '[NOWHERE]', 19, 'is NOWHERE; expected HERE or THERE'],
    'a mode by a command that is not of its row' => ['REST, command: WORKPHASE', 'REST, command: GO', 21, 'is GO; expected NONE or WORKPHASE'],
    'a mode by nothing' => ['REST, command: WORKPHASE,', 'REST,', 21, 'has both command and commands, or neither'],
    'two modes by one command' => ['REST, command: WORKPHASE', 'REST, commands: [{code: 3, name: GO, from: [], says: "Go."}]', 21,
                                   'has the name of GO: GO'],
    'two modes of one workphase' => ['[THERE]', '[HERE]', 21, 'is armed by WORKPHASE HERE like WAIT'],
    'a call with what there is not' => ['judge: [axis]', 'judge: [leg]', 20, 'is leg; expected way or move or span or axis or end or own'],
    'a call with its own of a mode that has none' => [', own: true', '', 20, 'has own, which the mode has not']
  }.freeze

  MODE_REFUSALS.each do |what, (old, new, line, reason)|
    define_method("test_SWR_TOOL_012_refuses_#{what.tr(' ', '_')}") do
      assert_refused('modes.yml', MODES, old, new, line, reason)
    end
  end
end
