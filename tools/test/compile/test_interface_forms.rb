# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the rows of commands and statuses decide which data an answer has; each form has a structure, a member of the union
# and an accessor.

require 'minitest/autorun'
require_relative 'interface_folder'

class TestInterfaceForms < Minitest::Test
  ROOT = File.expand_path('../../..', __dir__)
  CORE = File.join(ROOT, 'core')

  def test_SWR_TOOL_480_a_form_is_a_member_of_the_union_with_an_accessor
    header = Interface::Headers.new(model(File.join(CORE, 'interface'))).files['answer.h']
    assert_includes header, '    answer_point_t point; /**< Accepted: ENTRY, ACCEPT_ENTRY. */'
    assert_includes header, 'const answer_point_t *answer_as_point(const answer_t *answer);'
    assert_includes header, '    answer_data_t as;'
  end

  def test_SWR_TOOL_480_the_largest_member_is_the_first_so_that_an_initializer_clears_all
    forms = model(File.join(CORE, 'interface')).answer_forms
    first = forms.union[/answer_\w+_t (\w+);/, 1]
    assert_equal forms.bytes, forms.structures.fetch("ANSWER_FORM_#{first.upcase}").bytes
  end

  def test_SWR_TOOL_480_the_column_of_a_status_decides_the_form_of_its_refusals
    source = model(File.join(CORE, 'interface')).answer_forms.files['answer.c']
    assert_includes source, "    case (uint32_t)STATUS_NEEDLE_IN:\n    case (uint32_t)STATUS_TRAJECTORY_SPEED:\n        " \
                            'form = (command == (uint32_t)COMMAND_LIST_ROW) ? ANSWER_FORM_AXIS : ANSWER_FORM_NONE;'
    assert_match(/case \(uint32_t\)STATUS_SEPARATION_LIMIT:\n.*?form = ANSWER_FORM_SHARED_LIMIT;/m, source)
  end

  # [file, what is written, what is written instead, what the refusal says]
  REFUSALS = {
    'a form without its structure' => ['commands.yml', 'gives: pose', 'gives: place', 'answer_place: is missing'],
    'a structure that no answer has' => ['answers.yml', 'name: answer_pose', 'name: answer_place', 'answer_pose: is missing'],
    'a form that is left' => ['commands.yml', 'gives: pose, ', '', 'answer_pose: is the form of no answer']
  }.freeze

  REFUSALS.each do |what, (name, old, new, reason)|
    define_method("test_SWR_TOOL_480_refuses_#{what.tr(' ', '_')}") do
      Dir.mktmpdir do |folder|
        FileUtils.cp_r([File.join(CORE, 'interface'), File.join(CORE, 'robot')], folder)
        file = File.join(folder, 'interface', name)
        text = File.read(file)
        assert_includes text, old
        File.write(file, text.sub(old, new))
        error = assert_raises(Interface::Refused) { model(File.join(folder, 'interface')) }
        assert_includes error.message, reason
      end
    end
  end

  private

  def model(folder)
    Interface::Model.new(folder, Interface::Command.leaves(File.join(ROOT, 'build/gen/charts/charts.json')))
  end
end
