# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: a route is served, read, documented and known to the console as it is described; a wrong
# description is refused with its line.

require 'fileutils'
require 'json'
require 'json_schemer'
require 'minitest/autorun'
require 'open3'
require 'stringio'
require 'tmpdir'
require_relative '../../compile/interface_compiler'

class TestInterfaceRoutes < Minitest::Test
  ROOT = File.expand_path('../../..', __dir__)

  COLOURS = <<~YAML
    header: role
    says: Colours.
    enumerations:
      - name: colour
        says: What is painted.
        values:
          - {code: 3, name: RED, says: "Red."}
          - {code: 7, name: BLUE, says: "Blue."}
      - name: status
        says: Why not.
        values:
          - {code: 0, name: OK, igtl_code: OK, says: "Done."}
          - {code: 1, name: DRY, igtl_code: BUSY, says: "It is dry."}
      - name: role
        says: Who may.
        values:
          - {code: 0, name: GUEST, says: "Looks."}
          - {code: 1, name: PAINTER, says: "Paints."}
  YAML

  MESSAGES = <<~YAML
    messages:
      - name: tin
        says: A tin.
        members:
          - {name: litres, type: number, or_null: true, unit: reading}
          - {name: kind, type: [oil, water]}
          - {name: colour, type: colour}
          - {name: parts, type: uint32, list: true, unit: count}
      - name: problem
        says: Why not.
        by_hand: true
        members:
          - {name: code, type: problem_code}
          - {name: place, type: text, optional: true}
  YAML

  ROUTES = <<~YAML
    problems:
      - {name: BAD, http: 400, when: any, says: "Bad."}
      - {status: DRY, http: 409, when: route}
      - {name: LONG, http: 413, when: body, says: "Too long."}
      - {name: WHO, http: 401, when: session, says: "Who are you?"}
      - {name: TOKEN, http: 403, when: written, says: "No token."}
    requests:
      - name: stripe
        says: A stripe.
        members:
          - {name: width_mm, type: number, minimum: -1.5, maximum: 2}
      - name: paint
        says: What to paint.
        members:
          - {name: colour, type: colour, says: "Of it."}
          - {name: coats, type: uint32, unit: count, minimum: 1, maximum: 9}
          - {name: shift, type: int32, unit: count}
          - {name: wet, type: flag}
          - {name: kind, type: [oil, water]}
          - {name: name, type: text, size: 6}
          - {name: stripes, type: stripe, list: [1, 2]}
          - {name: note, type: text, size: 3, optional: true}
          - {name: first, type: stripe, optional: true}
    routes:
      - {name: tin, path: /tin, method: GET, handler: http_tin_show, who: anyone, answer: tin, problems: [DRY], says: "The tin.", parameters: [{name: of, type: colour}]}
      - {name: paint, path: /tin, method: PUT, handler: http_tin_paint, who: PAINTER, answer: tin, body: paint, body_most: 300, says: "Paint."}
      - {name: hit, path: /hit, method: POST, handler: http_tin_paint, who: anyone, answer: tin, body: stripe, body_most: 30, lenient: true, refused: true, says: "Hit."}
      - name: live
        path: /live
        method: GET
        handler: http_live
        who: GUEST
        media: text/event-stream
        events: {tin: tin}
        says: Live.
        headers: [{name: Last-Event-ID, type: uint32, says: "The last."}]
  YAML

  MAIN = <<~C
    #include "interface/app/routes.h"
    #include "request/request_body.h"
    #include <stdio.h>
    #include <string.h>
    int main(void)
    {
        char line[400];
        while (fgets(line, sizeof line, stdin) != NULL) {
            request_paint_t paint;
            memset(&paint, 0, sizeof paint);
            const request_result_t result = request_read_body(routes[ROUTE_PAINT].body, line, strlen(line), &paint);
            printf("%d %s %u %u %d %d %u %s %u %.1f %d%s %d\\n", (int)result.fault, result.place, (unsigned)paint.colour,
                   (unsigned)paint.coats, (int)paint.shift, paint.wet, (unsigned)paint.kind, paint.name,
                   (unsigned)paint.stripes_count, paint.stripes[1].width_mm, paint.has_note, paint.note, paint.has_first);
        }
        for (unsigned i = 0U; i < ROUTE_COUNT; i++) {
            printf("%s %s %s %d %u\\n", routes[i].method, routes[i].path, routes[i].allowed, routes[i].is_lenient,
                   (unsigned)routes[i].body_most);
        }
        printf("%d %s %s\\n", problems[PROBLEM_DRY].http, problems[PROBLEM_DRY].code, problems[PROBLEM_DRY].detail);
        return 0;
    }
  C

  GOOD = '{"colour":"BLUE","coats":9,"shift":-3,"wet":true,"kind":"water","name":"abcdef",' \
         '"stripes":[{"width_mm":0},{"width_mm":-1.5}],"note":"abc","first":{"width_mm":1}}'

  def test_SWR_TOOL_019_what_is_described_is_read_and_served
    with_output do |folder|
      wrong = { '"coats":9' => '"coats":10', '"abcdef"' => '"abcdefg"', '"BLUE"' => '"blue"', ':-1.5' => ':-1.6' }
      lines = [GOOD, *wrong.map { |old, new| GOOD.sub(old, new) }, '{}']
      read = output_of(folder, lines.join("\n")).lines(chomp: true)
      assert_equal '0  7 9 -3 1 1 abcdef 2 -1.5 1abc 1', read.shift
      assert_equal ['8 /coats', '6 /name', '8 /colour', '8 /stripes/1/width_mm', '4 /colour'],
                   read.shift(5).map { |line| line[/\A\d \S+/] }
      assert_equal ['GET /tin GET, HEAD, PUT 0 0', 'PUT /tin GET, HEAD, PUT 0 300', 'POST /hit POST 1 30',
                    'GET /live GET, HEAD 0 0', '409 DRY It is dry.'], read
    end
  end

  # The server that the handlers are of.
  SERVER = {
    'http/call/http_context.h' => "typedef struct { int wet; } http_server_t;\n",
    'http/call/http_call.h' => "#include \"interface/app/routes.h\"\ntypedef struct { const route_t *route; } http_call_t;\n"
  }.freeze
  HANDLED = <<~C
    #include "interface/app/handlers.h"
    #include <stdio.h>
    int http_tin_show(http_server_t *server, const http_call_t *call)
    {
        (void)call;
        return server->wet;
    }
    int http_tin_paint(http_server_t *server, const http_call_t *call)
    {
        return server->wet + 100 * (int)call->route->id;
    }
    int http_live(http_server_t *server, const http_call_t *call)
    {
        (void)call;
        return -server->wet;
    }
    int main(void)
    {
        http_server_t server = {7};
        for (unsigned i = 0U; i < ROUTE_COUNT; i++) {
            const http_call_t call = {&routes[i]};
            (void)printf("%d\\n", http_handlers[i](&server, &call));
        }
        return 0;
    }
  C

  def test_SWR_TOOL_070_each_route_is_answered_by_the_handler_that_it_names
    with_output do |folder|
      SERVER.each do |name, text|
        file = File.join(File.dirname(folder), name)
        FileUtils.mkdir_p(File.dirname(file))
        File.write(file, text)
      end
      assert_equal "7\n107\n207\n-7\n", output_of(folder, '', HANDLED, %w[app/handlers.c])
      header = File.read(File.join(folder, 'app/handlers.h'))
      assert_includes header, "/** GET /tin: The tin. */\nint http_tin_show("
      assert_includes header, "/** PUT /tin, POST /hit. */\nint http_tin_paint("
    end
  end

  def test_SWR_TOOL_070_refuses_a_route_without_a_handler
    message = in_folder('routes.yml' => ROUTES.sub('handler: http_tin_show, ', '')) { |folder, output| run_tool(folder, output) }
    assert_match(/routes\.yml:25: .*handler: is missing/, message)
  end

  def test_SWR_TOOL_070_what_several_routes_send_has_one_name
    with_output(with_acts("body: stroke\n" => "body: stripe\n", 'answer: act' => 'answer: tin')) do |folder|
      union = File.read(File.join(folder, 'app/requests.h'))[/typedef union \{[^}]*\} request_body_t;/]
      assert_equal %w[paint paint stripe stripe], union.scan(/request_(\w+)_t (\w+);/).flatten
    end
  end

  def test_SWR_TOOL_019_the_console_knows_the_same
    with_output do |folder|
      types = File.read(File.join(folder, 'app/api.ts'))
      assert_includes types, <<~CODE
        /** What to paint. */
        export interface PaintRequest {
          /** Of it. */
          colour: Colour;
          coats: number;
          shift: number;
          wet: boolean;
          kind: "oil" | "water";
          name: string;
          stripes: (StripeRequest)[];
          note?: string;
          first?: StripeRequest;
        }

        /** Its longest texts, in bytes. */
        export const PaintRequestBytes = { name: 6, note: 3 } as const;
      CODE
      assert_includes types, %(  "PUT /tin": { answer: Tin; body: PaintRequest };\n)
      assert_includes types, %(export type Path =\n  | "/tin"\n  | "/hit"\n  | "/live";)
      assert_includes types, %(export interface Problem {\n  code: ProblemCode;\n  place?: string;\n})
    end
  end

  def test_SWR_TOOL_019_the_document_says_the_same
    document = document_of(ROUTES)
    assert_equal %w[/tin /hit /live], document['paths'].keys
    assert_equal %w[get head put], document.dig('paths', '/tin').keys
    paint = document.dig('components', 'schemas', 'PaintRequest')
    assert_equal({ 'type' => 'integer', 'minimum' => 1, 'maximum' => 9 }, paint.dig('properties', 'coats'))
    assert_equal [false, %w[colour coats shift wet kind name stripes]], paint.values_at('additionalProperties', 'required')
    assert_equal %w[200 400 409], document.dig('paths', '/tin', 'get', 'responses').keys
    assert_equal %w[200 400 401 403 413], document.dig('paths', '/tin', 'put', 'responses').keys
    assert_equal %w[BAD DRY LONG OK TOKEN WHO], document.dig('components', 'schemas', 'ProblemCode', 'enum').sort
    assert_equal 'query', document.dig('paths', '/tin', 'get', 'parameters', 0, 'in')
  end

  # The schema and the table give the same verdict.
  def test_SWR_TOOL_019_schema_and_table_agree
    schema = { '$ref' => '#/components/schemas/PaintRequest' }.merge(document_of(ROUTES).slice('components'))
    texts = [GOOD, GOOD.sub('"note":"abc",', ''), GOOD.sub('9', '0'), GOOD.sub('true', '1'), GOOD.sub('water', 'oil'),
             GOOD.sub('water', 'air'), GOOD.sub('"name"', '"nam"'), GOOD.sub('[{"width_mm":0},', '['), '{}', '[]',
             GOOD.sub('[{"width_mm":0},', '[{"width_mm":0},{"width_mm":0},'), GOOD.sub('-3', '-3.5'), GOOD.sub('-3', 'null')]
    with_output do |folder|
      read = output_of(folder, texts.join("\n")).lines.first(texts.size).map { |line| line.start_with?('0 ') }
      assert_equal read, texts.map { |text| JSONSchemer.schema(schema).valid?(JSON.parse(text)) }
      assert_equal 4, read.count(true) + read.first(1).count(false)
    end
  end

  def test_SWR_TOOL_020_the_document_of_the_product_is_valid
    document = JSON.parse(File.read(File.join(ROOT, 'build/gen/interface/app/openapi.json')))
    assert_valid document
    assert_equal '3.1.0', document['openapi']
  end

  def test_SWR_TOOL_020_the_document_says_which_members_stand_for_each_other
    schemas = JSON.parse(File.read(File.join(ROOT, 'build/gen/interface/app/openapi.json'))).dig('components', 'schemas')
    assert_equal [%w[name password], %w[code]], schemas.dig('LoginRequest', 'oneOf').map { |one| one['required'] }
    assert_equal [%w[file], %w[motors]], schemas.dig('PreviewRequest', 'oneOf').map { |one| one['required'] }
    refute schemas.fetch('StopRequest').key?('oneOf')
  end

  def test_SWR_TOOL_020_the_document_says_what_needs_a_session
    paths = JSON.parse(File.read(File.join(ROOT, 'build/gen/interface/app/openapi.json')))['paths']
    session = { 'session' => [] }
    assert_equal [{}, session], paths.dig('/api/v1/status', 'get', 'security')
    assert_equal [{}, session], paths.dig('/api/v1/status', 'head', 'security')
    assert_equal [session], paths.dig('/api/v1/workphase', 'post', 'security')
    assert_equal [], paths.dig('/api/v1/stop', 'post', 'security')
  end

  def test_SWR_TOOL_020_every_document_is_valid_and_one_that_is_not_is_found
    document = document_of(ROUTES)
    assert_valid document
    document['paths']['/tin']['get'].delete('responses')['x'] = 1
    document['paths']['tin'] = {}
    refute JSONSchemer.openapi(document).valid?
  end

  def test_SWR_TOOL_020_every_reference_leads_somewhere
    document = document_of(ROUTES)
    JSON.generate(document).scan(%r{"#/components/schemas/(\w+)"}).flatten.each do |name|
      assert_includes document.dig('components', 'schemas'), name
    end
  end

  ACT = <<~YAML.gsub(/^(?=.)/, '  ')
    - name: act
      says: What became of it.
      members:
        - {name: id, type: uint32, unit: id}
        - {name: code, type: problem_code}
  YAML

  WHY = <<~YAML.gsub(/^(?=.)/, '  ')
    - {name: PAGE, http: 423, when: page, says: "Another page."}
    - {name: AGAIN, http: 409, when: act, says: "Again."}
    - {name: GONE, http: 404, when: path, says: "It is gone."}
  YAML

  BODY = <<~YAML.gsub(/^(?=.)/, '  ')
    - name: stroke
      says: A stroke.
      members:
        - {name: id, type: uint32, unit: id}
        - {name: colour, type: colour, only: [BLUE]}
  YAML

  STROKE = <<~YAML.gsub(/^(?=.)/, '  ')
    - name: stroke
      path: /walls/{axis}/stroke-now
      method: POST
      handler: http_wall_stroke
      who: PAINTER
      authority: true
      body: stroke
      body_most: 99
      answer: act
      says: Strokes.
  YAML

  def with_acts(change = {})
    text = ROUTES.sub("requests:\n") { "#{WHY}requests:\n" }.sub("routes:\n") { "#{BODY}routes:\n" } + STROKE
    change.each { |old, new| text = text.sub(old, new) }
    { 'routes.yml' => text, 'messages.yml' => MESSAGES + ACT }
  end

  def document_of_acts(change = {})
    with_output(with_acts(change)) { |folder| JSON.parse(File.read(File.join(folder, 'app/openapi.json'))) }
  end

  def test_SWR_TOOL_019_an_act_is_described_with_all_that_can_become_of_it
    document = document_of_acts
    assert_valid document
    stroke = document.dig('paths', '/walls/{axis}/stroke-now', 'post')
    assert_equal %w[200 202 400 401 403 404 409 413 423], stroke['responses'].keys
    assert_equal %w[path axis header X-Boresight-Token header X-Boresight-Page],
                 stroke['parameters'].flat_map { |one| one.values_at('in', 'name') }
    assert_equal ['BLUE'], document.dig('components', 'schemas', 'StrokeRequest', 'properties', 'colour', 'enum')
  end

  def test_SWR_HTTP_300_a_number_has_its_unit_for_people
    written = { ['depth_mm', nil] => 'mm', ['angle_deg', nil] => 'degrees', ['position', 'axis'] => 'the unit of its axis',
                ['speed_per_s', 'axis'] => 'the unit of its axis per second', ['id', 'id'] => nil, ['matrix', 'pose'] => nil }
    assert_equal(written, written.keys.to_h { |name, unit| [[name, unit], Interface::Units.written(name, unit)] })
  end

  def test_SWR_TOOL_019_the_console_and_the_server_know_what_a_path_holds
    with_output(with_acts) do |folder|
      types = File.read(File.join(folder, 'app/api.ts'))
      assert_includes types, '| `/walls/${string}/stroke-now`'
      assert_includes types, %(  colour: "BLUE";\n)
      assert_match(/"BLUE", 7U\}\};/, File.read(File.join(folder, 'app/requests.c')))
      assert_match(/ROUTE_STROKE, "POST", [^,]*, ROUTE_OF_AXIS, "POST",\s+false, ROLE_PAINTER, true, true, 0U, false, false, ROUTE_NOTED_ALWAYS, 99U/,
                   File.read(File.join(folder, 'app/routes.c')))
    end
  end

  { 'a_value_that_is_none' => ['{axis}', '{wall}', 'has wall; expected at most one of axis, number, name'],
    'two_values' => ['/walls/', '/walls/{name}/', 'has name, axis; expected at most one'],
    'a_word_that_the_type_has_not' => ['[BLUE]', '[GREEN]', 'holds GREEN, which its type has not'],
    'an_act_without_an_id' => ['{name: id, type: uint32,', '{name: it, type: uint32,', 'its body has no id'],
    'authority_for_anyone' => ["stroke\n    who: PAINTER", "stroke\n    who: anyone", 'is of a page, but is a GET or for anyone'] }
    .each do |what, (old, new, reason)|
    define_method("test_SWR_TOOL_021_refuses_#{what}") do
      changed = with_acts(old => new)
      changed['messages.yml'] = MESSAGES + ACT
      message = in_folder(changed) { |folder, output| run_tool(folder, output) }
      assert_includes message, reason
    end
  end

  # [what is written instead of what, the line, what the refusal says]
  REFUSALS = {
    'a status that is none' => ['status: DRY', 'status: WET', 3, 'is WET, which is no status'],
    'a problem without a sentence' => [', says: "Bad."', '', 2, 'needs name and says, or status'],
    'a status of HTTP that is no refusal' => ['http: 400', 'http: 200', 2, 'is 200; expected 400 to 599'],
    'a type that is none' => ['type: int32', 'type: int33', 17, 'is of int33; expected flag, uint32'],
    'a text without a size' => ['size: 6', 'list: [1, 2]', 20, 'is a text without a size'],
    'bounds of what is no number' => ['type: flag', 'type: flag, minimum: 1', 18, 'has bounds, but is no number'],
    'bounds the wrong way round' => ['minimum: 1,', 'minimum: 10,', 16, 'has the bounds 10 to 9'],
    'bounds that the type has not' => ['minimum: 1,', 'minimum: -1,', 16, 'is -1; expected 0 to 4294967295'],
    'a list the wrong way round' => ['[1, 2]', '[2, 1]', 21, 'is not [least, most]'],
    'two members of one name' => ['name: shift', 'name: coats', 17, 'is the second coats in paint'],
    'an object in itself' => ['type: number, minimum: -1.5, maximum: 2', 'type: stripe', 8, 'holds more than 8 objects'],
    'a path that is none' => ['path: /hit', 'path: hit', 27, 'is hit; expected a path'],
    'a method that is none' => ['method: PUT', 'method: PAT', 26, 'is PAT; expected GET or POST'],
    'a handler that is none in C' => ['handler: http_tin_paint', 'handler: http-tin', 26, 'is http-tin; expected a name of a-z'],
    'a role that is none' => ['who: PAINTER', 'who: painter', 26, 'is painter; expected anyone, GUEST, PAINTER'],
    'a route twice' => ['method: PUT', 'method: GET', 26, 'is the second'],
    'an answer that is none' => ['answer: tin, problems', 'answer: can, problems', 25, 'is can, which is no message'],
    'a problem that is none' => ['[DRY]', '[WET]', 25, 'is no problem'],
    'a request that is none' => ['body: paint,', 'body: pain,', 26, 'is no request'],
    'a body without its size' => [', body_most: 300', '', 26, 'has body or sends without body_most, or it without them'],
    'a body and another medium' => ['body_most: 300', 'body_most: 300, sends: text/csv', 26, 'has both body and sends'],
    'a body of a GET' => ['says: "The tin."', 'says: "The tin.", body: stripe, body_most: 9', 25, 'has a body, but is a GET'],
    'a route without an answer' => ["    media: text/event-stream\n", '', 28, 'has neither answer nor media'],
    'a list in a query' => ['{name: of, type: colour}', '{name: of, type: uint32, unit: id, list: [1, 2]}', 25, 'is a list or an object'],
    'an unknown key' => ['lenient: true', 'lenent: true', 27, 'lenent: is unknown'],
    'a name beyond its room' => ['name: shift', "name: #{'a' * 48}", 17, 'has a name longer than 47']
  }.freeze

  REFUSALS.each do |what, (old, new, line, reason)|
    define_method("test_SWR_TOOL_021_refuses_#{what.tr(' ', '_')}") do
      changed = ROUTES.sub(old, new)
      refute_equal ROUTES, changed
      message = in_folder('routes.yml' => changed) { |folder, output| run_tool(folder, output) }
      assert_match(/routes\.yml:#{line}: /, message)
      assert_includes message, reason
    end
  end

  def test_SWR_TOOL_021_refuses_what_only_messages_by_hand_may_hold
    message = in_folder('messages.yml' => MESSAGES.sub("    by_hand: true\n", '')) { |folder, output| run_tool(folder, output) }
    assert_match(/messages\.yml:\d+: .*is for messages by_hand alone/, message)
  end

  private

  def assert_valid(document)
    faults = JSONSchemer.openapi(document).validate.first(3).map { |fault| "#{fault['data_pointer']}: #{fault['error']}" }
    assert_empty faults
  end

  def document_of(routes)
    with_output('routes.yml' => routes) { |folder| JSON.parse(File.read(File.join(folder, 'app/openapi.json'))) }
  end

  def with_output(files = {})
    in_folder(files) do |folder, output|
      assert_equal '', run_tool(folder, output)
      yield output
    end
  end

  def in_folder(files)
    Dir.mktmpdir do |core|
      folder = File.join(core, 'interface')
      FileUtils.mkdir_p(folder)
      { 'colours.yml' => COLOURS, 'messages.yml' => MESSAGES, 'routes.yml' => ROUTES,
        'charts.json' => JSON.generate('charts' => []) }.merge(files).each do |name, text|
        File.write(File.join(folder, name), text)
      end
      yield folder, File.join(core, 'out/interface')
    end
  end

  # Its complaint.
  def run_tool(folder, output)
    errors = StringIO.new
    FileUtils.mkdir_p(output)
    Interface::Command.run([folder, File.join(folder, 'charts.json'), output], errors: errors)
    errors.string
  end

  def output_of(folder, input, main = MAIN, more = [])
    program = File.join(folder, 'main')
    File.write("#{program}.c", main)
    sources = [*%w[app/routes.c app/requests.c], *more].map { |name| File.join(folder, name) } + Dir["#{ROOT}/app/request/*.c"]
    output, status = Open3.capture2e('gcc', '-std=c99', '-pedantic', '-Wall', '-Wextra', '-Werror',
                                     '-Wconversion', '-Wmissing-prototypes',
                                     "-I#{File.dirname(folder)}", "-I#{ROOT}/app", '-o', program, "#{program}.c", *sources, '-lm')
    assert status.success?, output
    Open3.capture2(program, stdin_data: input).first
  end
end
