# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: rows of commands, columns of statuses and traits of modes say together which answers a command may get; from
# them come the table for programs, the names in the OpenAPI document and the table of the manual.

require 'minitest/autorun'
require_relative 'interface_folder'
require_relative '../../tables'

class TestInterfaceAnswers < Minitest::Test
  ROOT = File.expand_path('../../..', __dir__)
  CORE = File.join(ROOT, 'core')

  def test_SWR_TOOL_340_a_row_lists_its_own_and_the_columns_of_statuses_add_to_them
    assert_equal %w[UNKNOWN_COMMAND WRONG_WORKPHASE OUT_OF_RANGE NOT_RIGID NOT_ALLOWED MEMORY_DAMAGED NO_AUTHORITY], refused('REGISTRATION')
    assert_equal %w[NOT_ALLOWED], refused('RELEASE')
    assert_equal %w[NOT_ALLOWED NO_AUTHORITY], refused('RENEW')
    assert_equal %w[UNKNOWN_COMMAND NOT_ALLOWED MEMORY_DAMAGED], refused('NONE')
  end

  def test_SWR_TOOL_340_a_mode_adds_the_ends_of_an_order_and_its_need_of_homed_axes
    assert_includes refused('ALIGN'), 'NOT_HOMED'
    refute_includes refused('RETRACT'), 'NOT_HOMED'
    assert_equal %w[NOT_HOMED FAULT_PRESENT DISCARDED EXPIRED MEMORY_DAMAGED NO_AUTHORITY], answers.ended(command('RETRACT'))
    assert_includes answers.ended(command('INSERT')), 'NOT_ALIGNED'
    assert_empty answers.ended(command('TARGET'))
  end

  def test_SWR_TOOL_340_the_refusals_of_the_robots_are_one_word
    assert_empty %w[SEPARATION_LIMIT ALPHA_LIMIT] - refused('TARGET')
    assert_empty %w[SEPARATION_LIMIT ALPHA_LIMIT] & refused('ENTRY')
  end

  def test_SWR_TOOL_340_the_table_says_which_answer_is_the_last
    text = answers.files['answer_list.c']
    assert_includes text, '{(uint32_t)COMMAND_TARGET, (uint32_t)ANSWER_ACCEPTED, (uint32_t)STATUS_OK, 1U},'
    refute_includes text, '{(uint32_t)COMMAND_TARGET, (uint32_t)ANSWER_ACCEPTED, (uint32_t)STATUS_OK, 0U},'
    refute_includes text, '{(uint32_t)COMMAND_ALIGN, (uint32_t)ANSWER_ACCEPTED, (uint32_t)STATUS_OK, 1U},'
    assert_includes text, '{(uint32_t)COMMAND_WORKPHASE, (uint32_t)ANSWER_ACCEPTED, (uint32_t)STATUS_OK, 0U},'
    assert_includes text, '{(uint32_t)COMMAND_WORKPHASE, (uint32_t)ANSWER_ACCEPTED, (uint32_t)STATUS_OK, 1U},'
    assert_includes text, '{(uint32_t)COMMAND_INSERT, (uint32_t)ANSWER_ABORTED, (uint32_t)STATUS_NOT_ALIGNED, 1U},'
  end

  # [file, what is written, what is written instead, what the refusal says]
  REFUSALS = {
    'a status that there is not' => ['commands.yml', 'refused: [BLACK_BOX_THERE]', 'refused: [BLACK_BOX]', 'is BLACK_BOX; expected'],
    'the refusal of one robot' => ['commands.yml', 'refused: [BLACK_BOX_THERE]', 'refused: [ALPHA_LIMIT]', 'is ALPHA_LIMIT; expected'],
    'a status that its columns add' => ['commands.yml', 'refused: [BLACK_BOX_THERE]', 'refused: [NO_AUTHORITY]',
                                        'names NO_AUTHORITY under refused, which its columns in status.yml add'],
    'an early end without an order' => ['commands.yml', 'refused: [BLACK_BOX_THERE]', 'ended: [BLACK_BOX_THERE]', 'is of a command that arms nothing'],
    'a status that the core does not give' => ['commands.yml', 'refused: [BLACK_BOX_THERE]', 'refused: [NO_ANSWER]', 'is NO_ANSWER; expected'],
    'a giver that there is not' => ['status.yml', 'given_by: processes', 'given_by: people', 'is people; expected processes'],
    'an unknown part' => ['commands.yml', 'refused: [BLACK_BOX_THERE]', 'failed: [BLACK_BOX_THERE]', 'failed'],
    'a group that there is not' => ['status.yml', 'refuses: every', 'refuses: all', 'is all; expected every or authorised']
  }.freeze

  REFUSALS.each do |what, (name, old, new, reason)|
    define_method("test_SWR_TOOL_340_refuses_#{what.tr(' ', '_')}") do
      Dir.mktmpdir do |folder|
        FileUtils.cp_r([File.join(CORE, 'interface'), File.join(CORE, 'robot')], folder)
        file = File.join(folder, 'interface', name)
        text = File.read(file)
        assert_includes text, old
        File.write(file, text.sub(old, new))
        error = assert_raises(Interface::Refused) { Interface::Model.new(File.join(folder, 'interface')) }
        assert_match(/#{name}:\d+: /, error.message)
        assert_includes error.message, reason
      end
    end
  end

  # A number of a status is written in C nowhere else.
  def test_SWR_TOOL_481_each_status_is_given_where_its_row_says
    of_limits = Dir[File.join(CORE, 'robot/*/kinematics.yml')].flat_map { |file| File.read(file).scan(/refusal: (\w+)/).flatten }
    of_core = sources('core') | of_limits
    of_processes = sources('app')
    model.enumeration('status').values.each do |status|
      is_of_core = model.statuses.of_core?(status)
      assert_equal is_of_core, of_core.include?(status.name), "#{status.name}, given_by"
      assert_includes of_processes, status.name unless is_of_core
    end
  end

  def test_SWR_TOOL_341_the_document_lists_them_with_the_request
    paths = Interface::Openapi.new(model).document['paths']
    insert = paths.dig('/api/v1/needle/insert', 'post')
    assert_equal refused('INSERT') - ['NOT_ALLOWED'], insert['x-refused']
    assert_equal answers.ended(command('INSERT')), insert['x-ended']
    assert_includes insert.dig('responses', '409', 'description'), ' NOT_ALIGNED'
    target = paths.dig('/api/v1/targeting/target', 'post')
    refute target.key?('x-ended')
    refute paths.dig('/api/v1/state', 'get')&.key?('x-refused')
  end

  def test_SWR_TOOL_341_a_request_that_sends_several_commands_lists_those_of_all
    listed = Interface::Openapi.new(model).document.dig('paths', '/api/v1/trajectory', 'post', 'x-refused')
    assert_empty %w[OUT_OF_RANGE TRAJECTORY_SPEED TRAJECTORY_SUM] - listed
  end

  def test_SWR_TOOL_341_the_manual_has_a_row_for_each_command
    rows = TableSources.new(ROOT).table('answers')
    assert_equal model.commands.to_a.size - 1, rows.size - 2
    assert_includes rows, '| `CLEAR_AXIS` | `UNKNOWN_COMMAND`, `WRONG_WORKPHASE`, `NOT_ALLOWED`, `MEMORY_DAMAGED`, `NO_AUTHORITY`, `NOT_AT_REST` |  |'
    assert_match(/`MOTION_ARMED`, a refusal of the robot's kinematics/, rows.grep(/`TARGET`/).first)
  end

  private

  # The statuses that the written sources of a folder name.
  def sources(folder)
    files = Dir[File.join(ROOT, folder, '**/*.{c,h}')].reject { |file| file.include?('/test/') }
    files.flat_map { |file| File.read(file).scan(/\bSTATUS_([A-Z_]+)\b/).flatten }.uniq
  end

  def model
    @model ||= Interface::Model.new(File.join(CORE, 'interface'), leaves)
  end

  def leaves
    Interface::Command.leaves(File.join(ROOT, 'build/gen/charts/charts.json'))
  end

  def answers
    model.answers
  end

  def command(name)
    model.commands.find(name)
  end

  def refused(name)
    answers.refused(command(name))
  end
end
