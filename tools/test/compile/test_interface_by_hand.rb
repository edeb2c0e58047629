# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the handler of a command's request is generated; one that is written stands in the row with its reason.

require 'minitest/autorun'
require_relative 'interface_folder'

class TestInterfaceByHand < Minitest::Test
  CORE = File.expand_path('../../../core', __dir__)

  def test_SWR_TOOL_342_each_written_handler_of_a_command_has_its_reason
    model = Interface::Model.new(File.join(CORE, 'interface'))
    written = model.routes.routes.select { |route| route.command && route.handler }
    refute_empty written
    rows = %w[commands modes].map { |name| File.read(File.join(CORE, 'interface', "#{name}.yml")) }.join
    assert_equal written.size, rows.scan('by_hand: "').size
  end

  def test_SWR_TOOL_310_words_of_the_body_become_values_of_the_field
    handlers = Interface::Handlers.new(Interface::Model.new(File.join(CORE, 'interface'))).files['handlers.c']
    assert_includes handlers, 'of_values[] = {(uint32_t)COMMAND_ENTRY, (uint32_t)COMMAND_PROPOSE_REGISTRATION, ' \
                              '(uint32_t)COMMAND_PROPOSE_ENTRY, (uint32_t)COMMAND_PROPOSE_TARGET};'
    assert_includes handlers, '.kind = (uint32_t)COMMAND_WITHDRAW, .as.withdrawal = {.of = of_values[body->what]}};'
  end

  # [requirement, what is written, what is written instead, what the refusal says]
  REFUSALS = {
    'a handler without a reason' => [342, 'by_hand: "Three numbers in mm become the place of a pose.",', '', 'has a handler, but not by_hand'],
    'a reason without a handler' => [342, 'leaves: [is_one_of_many],', 'leaves: [is_one_of_many], by_hand: "No reason.",', 'stands without a handler'],
    'a word that the body has not' => [310, '{entry: ENTRY, ', '{exit: ENTRY, ', 'has the words exit, proposed_registration'],
    'a value that the field has not' => [310, '{entry: ENTRY, ', '{entry: EXIT, ', 'is EXIT; expected'],
    'a field that nothing says and that is not left' => [310, ' leaves: [is_one_of_many],', '', 'needs a handler for the field is_one_of_many']
  }.freeze

  REFUSALS.each do |what, (id, old, new, reason)|
    define_method("test_SWR_TOOL_#{id}_refuses_#{what.tr(' ', '_')}") do
      Dir.mktmpdir do |folder|
        FileUtils.cp_r([File.join(CORE, 'interface'), File.join(CORE, 'robot')], folder)
        file = File.join(folder, 'interface', 'commands.yml')
        text = File.read(file)
        assert_includes text, old
        File.write(file, text.sub(old, new))
        error = assert_raises(Interface::Refused) { Interface::Model.new(File.join(folder, 'interface')) }
        assert_match(/commands\.yml:\d+: /, error.message)
        assert_includes error.message, reason
      end
    end
  end
end
