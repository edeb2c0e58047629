# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'json'
require_relative 'schema'

module Interface
  # The description of the HTTP server for clients: an OpenAPI 3.1 document.
  #
  # @satisfies SWR-TOOL-019
  # @satisfies SWR-HTTP-036
  class Openapi
    VERSION = '1.0.0'
    JSON_MEDIA = 'application/json'
    BY_CONTROL = 'Control refuses it; the code is the name of the status'
    PROBLEM_MEDIA = 'application/problem+json'
    SAYS = 'Shows what the control core of the robot does, and takes commands. Lengths are in mm, angles in degrees. ' \
           'Whole numbers are written without fraction and exponent. Refusals are problems as of RFC 9457: `code` is ' \
           'to be compared, `detail` to be read. Requests must name the host and port that they go to, and no page of ' \
           'another origin may send any. Who logs in (POST /api/v1/session) gets a cookie, to be sent with every request, ' \
           'and a token, for the header of that name. Who commands draws a number for itself (X-Boresight-Page), takes ' \
           'authority with it (POST /api/v1/authority), renews that every 2 s (PUT) and gives it up in the end (DELETE). ' \
           'Each act has an `id`, higher than those before it; sent again after a lost answer, with the same body, it does ' \
           'nothing and is answered with what has become of it. An act that is begun (202) ends later: as the event act of ' \
           '/api/v1/events, or by asking again. Nothing moves unless the pedal is pressed at the robot.'

    VALUES = {
      'axis' => ['An axis, by its name or its number, the first one being 0.', { 'type' => 'string' }],
      'number' => ['Of what is meant.', Schema::UINT32],
      'name' => ['Of what is meant.', { 'type' => 'string', 'pattern' => '^[A-Za-z0-9][A-Za-z0-9_.-]{0,63}$' }]
    }.freeze
    MARKS = [
      ['X-Boresight-Token', 'The token of the session.', { 'type' => 'string' }],
      ['X-Boresight-Page', 'Which page or program of the session asks: a number that each draws for itself when it starts.',
       Schema::UINT32.merge('minimum' => 1)]
    ].freeze

    SESSION = { 'type' => 'apiKey', 'in' => 'cookie', 'name' => 'boresight-boresight',
                'description' => 'Set by the login. The name ends with that of the instance, which is boresight unless it was ' \
                                 'started with another; over TLS it begins with __Host-.' }.freeze

    def initialize(model)
      @model = model
    end

    def files
      @model.routes ? { 'openapi.json' => "#{JSON.pretty_generate(document)}\n" } : {}
    end

    def document
      schema = Schema.new(@model)
      paths = @model.routes.routes.group_by(&:path).transform_values { |routes| operations(routes, schema) }
      { 'openapi' => '3.1.0',
        'info' => { 'title' => 'Boresight', 'version' => VERSION, 'description' => SAYS,
                    'license' => { 'name' => 'Apache-2.0', 'identifier' => 'Apache-2.0' } },
        'servers' => [{ 'url' => '/' }], 'paths' => paths,
        'components' => { 'schemas' => schema.all, 'securitySchemes' => { 'session' => SESSION } } }
    end

    private

    def operations(routes, schema)
      routes.each_with_object({}) do |route, found|
        found[route.method.downcase] = operation(route, schema)
        found['head'] = head(found['get']) if route.get?
      end
    end

    def operation(route, schema)
      operation = { 'operationId' => route.name, 'description' => route.says }
      parameters = parameters(route, schema)
      operation['parameters'] = parameters unless parameters.empty?
      operation['requestBody'] = body(route) if route.body || route.sends
      operation['security'] = security(route)
      operation['responses'] = responses(route)
      operation.merge!(answers(route))
      operation['x-events'] = route.events.transform_values { |one| Schema.ref(one.typescript) } unless route.events.empty?
      operation
    end

    # The statuses with which control may refuse what is sent, and may end it early.
    #
    # @satisfies SWR-TOOL-341
    def answers(route)
      return {} unless @model.answers && route.command && (route.act? || route.refused?)

      { 'x-refused' => @model.answers.of_route(route, :refused), 'x-ended' => @model.answers.of_route(route, :ended) }.reject { |_, names| names.empty? }
    end

    # A GET of an observer needs no session at the plain loopback listener.
    def security(route)
      return [] if route.anyone?

      (route.get? && route.who == 'OBSERVER' ? [{}] : []) + [{ 'session' => [] }]
    end

    # The same without any body.
    def head(get)
      responses = get['responses'].transform_values { |response| response.slice('description', 'headers') }
      get.slice('description', 'parameters', 'security').merge('operationId' => "#{get['operationId']}_head", 'responses' => responses)
    end

    def parameters(route, schema)
      values(route) + marks(route) +
        route.parameters.members.map { |one| parameter(one.name, 'query', !one.optional?, one.says, schema.member(one)) } +
        route.headers.map { |one| parameter(one.name, 'header', false, one.says, schema.header(one)) }
    end

    # Parameter of the path.
    def values(route)
      [route.value].compact.map { |name| parameter(name, 'path', true, *VALUES.fetch(name)) }
    end

    # Headers that identify the client.
    def marks(route)
      [(MARKS.first if route.written?), (MARKS.last if route.page?)].compact.map { |name, *rest| parameter(name, 'header', true, *rest) }
    end

    def parameter(name, where, is_required, says, schema)
      { 'name' => name, 'in' => where, 'required' => is_required, 'description' => says, 'schema' => schema }.compact
    end

    def body(route)
      return { 'required' => true, 'content' => { route.sends => { 'schema' => { 'type' => 'string' } } } } if route.sends

      needed = route.body.members.any? { |member| !member.optional? }
      { 'required' => needed,
        'content' => { route.lenient? ? '*/*' : JSON_MEDIA => { 'schema' => Schema.ref(route.body.typescript) } } }
    end

    def responses(route)
      good = { 'description' => route.answer&.says || route.says,
               'content' => { route.media || JSON_MEDIA => { 'schema' => content(route) } } }
      refusals = route.problems(@model.routes.problems).group_by { |problem| problem.http.to_s }
      found = { '200' => good }.merge(refusals.transform_values { |same| refusal(same) })
      found['202'] = good.merge('description' => 'Begun; its end comes as the event act of the stream.') if route.act?
      found['409'] = refusal(refusals.fetch('409', []), by_control(route)) if route.refused? || route.act?
      found.sort.to_h
    end

    # "... the name of the status: BUSY, NOT_ALIGNED."
    def by_control(route)
      names = answers(route)['x-refused']
      "#{[BY_CONTROL, names&.join(', ')].compact.join(': ')}."
    end

    def content(route)
      return Schema.ref(route.answer.typescript) if route.answer

      { 'type' => route.media == JSON_MEDIA ? 'object' : 'string' }
    end

    def refusal(problems, *also)
      says = problems.map { |problem| "#{problem.name}: #{problem.says}" } + also
      { 'description' => says.join(' '), 'content' => { PROBLEM_MEDIA => { 'schema' => Schema.ref('Problem') } } }
    end
  end
end
