# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the row of a command has its request and its label; from these come the route, the handler that fills the
# payload, and the console's table of commands. A request that cannot fill the payload is refused with its line.

require 'minitest/autorun'
require_relative 'interface_folder'

class TestInterfaceRequests < Minitest::Test
  CORE = File.expand_path('../../../core', __dir__)

  def test_SWR_TOOL_082_a_bare_command_is_posted_with_its_id_and_has_a_button
    model = Interface::Model.new(File.join(CORE, 'interface'), leaves)
    route = model.routes.routes.find { |one| one.path == '/api/v1/align' }
    assert_equal ['POST', nil, 'ALIGN', 'OPERATOR', true], [route.method, route.handler, route.command.name, route.who, route.authority?]
    assert_equal 'The base lines up with the target, the needle out, under the pedal. Only in TARGETING.', route.says
    types = Interface::Typescript.new(model).files['api.ts']
    assert_includes types, '  ALIGN: { label: "Align", method: "POST", path: "/api/v1/align" },'
    buttons = %w[RETRACT ALIGN INSERT COOPERATE].map { |name| "  #{name}: commands.#{name},\n" }.join
    assert_includes types, "export const modeButtons = {\n#{buttons}}"
  end

  def test_SWR_TOOL_310_the_payload_is_filled_from_body_and_path
    handlers = Interface::Handlers.new(Interface::Model.new(File.join(CORE, 'interface'), leaves)).files
    { 'home_axis' => '.kind = (uint32_t)COMMAND_HOME_AXIS, .as.axis = {.axis = call->path.axis}}',
      'request' => '.kind = (uint32_t)COMMAND_REQUEST, .as.request = {.request = body->what}}',
      'align' => '.kind = (uint32_t)COMMAND_ALIGN}' }.each do |name, said|
      assert_match(/static int send_#{name}\(.*?\.id = body->id, #{Regexp.escape(said)};\n    return http_act_command/m, handlers['handlers.c'])
      assert_includes handlers['handlers.c'], "[ROUTE_#{name.upcase}] = send_#{name},"
      refute_includes handlers['handlers.h'], "send_#{name}"
    end
    assert_includes handlers['handlers.c'], '[ROUTE_JOG] = http_motion_jog,'
  end

  def test_SWR_TOOL_310_what_is_not_listed_is_said_in_the_table
    rows = Interface::RouteTable.new(Interface::Model.new(File.join(CORE, 'interface'), leaves)).files['routes.c']
    assert_match(/ROUTE_TAKE, .*?\b13U, false,/m, rows)
    assert_match(/ROUTE_ENTRY, .*?\b10U, true,/m, rows)
  end

  # [what is written, what is written instead, what the refusal says]
  REFUSALS = {
    'a request without a label' => ['label: Register,', '', 'has no label'],
    'a request of a command that pages may not send' => ['from: [HTTP], obeyed_by: restore', 'from: [IGTL], obeyed_by: restore',
                                                         'is of a command that HTTP may not send'],
    'a request of another command that has none' => ['http: LIST_BEGIN', 'http: ACCEPT_ENTRY', 'is ACCEPT_ENTRY, whose row has no request'],
    'a field that nothing says' => ['takes: {request: what}, ', '', 'needs a handler for what of its body'],
    'a payload that the body has not' => [', handler: http_targeting_enter', '', 'needs a handler for point_mm of its body'],
    'a field of another type' => ['takes: {request: what}, listed: false, authority: false, body: ask_button',
                                  'takes: {request: workphase}, listed: false, authority: false, body: next_workphase',
                                  'needs a handler for the field request of its command'],
    'a path that is none' => ['path: /api/v1/targeting/entry', 'path: entry!', 'is entry!; expected a path']
  }.freeze

  REFUSALS.each do |what, (old, new, reason)|
    define_method("test_SWR_TOOL_310_refuses_#{what.tr(' ', '_')}") do
      Dir.mktmpdir do |folder|
        FileUtils.cp_r([File.join(CORE, 'interface'), File.join(CORE, 'robot')], folder)
        file = File.join(folder, 'interface', 'commands.yml')
        text = File.read(file)
        assert_includes text, old
        File.write(file, text.sub(old, new))
        refused = assert_raises(Interface::Refused) { Interface::Model.new(File.join(folder, 'interface')) }
        assert_match(/commands\.yml:\d+: .*#{Regexp.escape(reason)}/, refused.message)
      end
    end
  end

  private

  def leaves
    Interface::Command.leaves(File.join(CORE, '../build/gen/charts/charts.json'))
  end
end
