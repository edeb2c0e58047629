# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'request'

module Interface
  # Why the HTTP server refuses a request. `whose`: of which routes.
  Problem = Struct.new(:name, :http, :says, :whose, :node, keyword_init: true) do
    def self.read(node, model)
      nodes = node.mapping(%w[http when], %w[name says status])
      node.refuse('needs name and says, or status') unless
        nodes.key?('status') ? (nodes.keys & %w[name says]).empty? : (%w[name says] - nodes.keys).empty?
      name, says = nodes.key?('status') ? of_status(nodes['status'], model) : own(nodes)
      new(name: name, http: nodes['http'].integer(400..599), says: says, node: node,
          whose: nodes['when'].choice(%w[any path body query session written page act route none]))
    end

    def self.own(nodes)
      [nodes['name'].identifier(capitals: true), nodes['says'].text]
    end

    def self.of_status(node, model)
      name = node.identifier(capitals: true)
      value = model.enumeration('status')&.values&.find { |one| one.name == name }
      value ? [name, value.says] : node.refuse("is #{name}, which is no status")
    end
  end

  # A path with a method.
  class Route
    METHODS = %w[GET POST PUT DELETE].freeze
    PATH = %r{\A/(([a-z0-9_.-]+|\{[a-z]+\})(/|\z))*\z}.freeze
    VALUES = %w[axis number name].freeze # of a path
    NOTED = %w[always refused never].freeze # in the log
    BODY_MOST = 1_048_576
    REQUIRED = %w[name path method handler who says].freeze
    OPTIONAL = %w[answer media parameters headers body body_most sends events problems refused lenient noted page authority].freeze
    Header = Struct.new(:name, :type, :says, keyword_init: true)

    # `handler`: nil: it is generated. `command`: value of command_kind that it sends; nil: none.
    attr_reader :name, :path, :method, :handler, :who, :says, :command, :answer, :media, :parameters, :headers, :body, :body_most, :sends, :events, :node

    def initialize(node, nodes = node.mapping(REQUIRED, OPTIONAL))
      @node = node
      @nodes = nodes
      @name = nodes['name'].identifier
      @path = nodes['path'].text
      check_path(nodes['path'])
      @method = nodes['method'].choice(METHODS)
      @handler = nodes['handler']&.identifier
      @who = nodes['who'].word
      @says = nodes['says'].text
      @media = nodes['media']&.word
      @sends = nodes['sends']&.word
      members = list('parameters') { |one| RequestMember.new(one) }
      @parameters = RequestMessage.new("#{name}_query", "The parameters of #{path}.", members, node)
      @headers = list('headers') { |one| header(one) }
      @body_most = nodes['body_most']&.integer(0..BODY_MOST).to_i
    end

    ANYONE = 'anyone'

    def check(model, routes)
      check_who(model)
      @answer = message(@nodes['answer'], model)
      @body = @nodes['body'] && (routes.request(@nodes['body'].identifier) || @nodes['body'].refuse('is no request'))
      @events = read_events(model)
      @problems = list('problems') { |one| routes.problem(one.identifier(capitals: true)) || one.refuse('is no problem') }
      @parameters.check(model, [])
      refuse_odd
    end

    def lenient?
      flag('lenient')
    end

    # When the log has it, with its answer.
    def noted
      @nodes['noted']&.choice(NOTED) || (get? ? 'refused' : 'always')
    end

    # Control may refuse it, with the name of any status.
    def refused?
      flag('refused')
    end

    # A page does something, and learns what becomes of it.
    def act?
      answer&.name == 'act'
    end

    # The request names its page.
    def page?
      flag('page') || act? || authority?
    end

    # GET /api/v1/modes lists its command.
    def listed?
      false
    end

    # Its page has authority.
    def authority?
      flag('authority')
    end

    # Part of the path in braces.
    def value
      path[/\{(.*)\}/, 1]
    end

    # It is served without a session.
    def anyone?
      who == ANYONE
    end

    def get?
      method == 'GET'
    end

    # All that it may be refused with.
    def problems(all)
      all.select do |problem|
        belongs?(problem.whose) || @problems.include?(problem)
      end
    end

    # Its requests hold the token of the session.
    def written?
      !anyone? && !get?
    end

    private

    def belongs?(whose)
      { 'any' => true, 'path' => value, 'body' => body || sends, 'query' => parameters.members.any?, 'session' => !anyone?,
        'written' => written?, 'page' => page?, 'act' => act? }[whose]
    end

    def check_path(node)
      node.refuse("is #{path}; expected a path of a-z, 0-9, _, ., - and /") unless path.match?(PATH)
      values = path.scan(/\{(.*?)\}/).flatten
      node.refuse("has #{values.join(', ')}; expected at most one of #{VALUES.join(', ')}") \
        unless values.size <= 1 && (values - VALUES).empty?
    end

    def check_who(model)
      roles = model.enumeration('role')&.values.to_a.map(&:name)
      @nodes['who'].refuse("is #{who}; expected #{[ANYONE, *roles].join(', ')}") unless anyone? || roles.include?(who)
    end

    def flag(key)
      @nodes.key?(key) && @nodes[key].true?
    end

    def list(key, &block)
      @nodes.key?(key) ? @nodes[key].sequence.map(&block) : []
    end

    def message(node, model)
      node && (model.message(node.identifier) || node.refuse("is #{node.word}, which is no message"))
    end

    def header(node)
      nodes = node.mapping(%w[name type says])
      Header.new(name: nodes['name'].word, type: nodes['type'].choice(%w[uint32 text]), says: nodes['says'].text)
    end

    def read_events(model)
      return {} unless @nodes.key?('events')

      @nodes['events'].all.transform_values { |node| message(node, model) }
    end

    def refuse_odd
      node.refuse('has neither answer nor media') unless answer || media
      node.refuse('has both body and sends') if body && sends
      node.refuse('has body or sends without body_most, or it without them') if (body || sends).nil? != body_most.zero?
      node.refuse('has a body, but is a GET') if (body || sends) && get?
      node.refuse('is of a page, but is a GET or for anyone') if page? && !written?
      node.refuse('is an act, but its body has no id') if act? && body&.members&.none? { |one| one.name == 'id' }
      @parameters.members.each { |one| one.node.refuse('is a list or an object') if one.list? || one.message }
    end
  end

  # A route that sends a command: `http` of the command's row, an object as in routes.yml. The most usual need not be said: POST by an
  # operator that has authority, answered as an act, whose body is its id. Further keys:
  #
  #   handler  without one the route fills the payload as body and path say it: each field from the member of its name, or from {axis}
  #   by_hand  why the handler is written and not generated; it stands with each
  #   takes    {FIELD: MEMBER} of a member with another name; {FIELD: {MEMBER: {WORD: VALUE}}} of one with words of its own
  #   leaves   fields that the request does not say: they stay 0
  #   listed   false: GET /api/v1/modes does not list whether the command is allowed
  #
  # @satisfies SWR-TOOL-082
  # @satisfies SWR-TOOL-310
  # @satisfies SWR-TOOL-342
  class CommandRoute < Route
    OWN = %w[name method handler by_hand who says takes leaves listed].freeze
    SENDER = 'HTTP'
    ACT = 'act'
    BARE = { 'body' => 'bare_act', 'body_most' => 256 }.freeze # The body of an act without a payload, and its most bytes.

    # The routes of a row; none if another command's request sends it too.
    def self.of(value, commands)
      node = value.more['http']
      return [] unless node
      return shared(value, node, commands) if node.scalar?

      node.refuse("is of a command that #{SENDER} may not send") unless commands.senders_of(value).include?(SENDER)
      node.refuse('has no label') unless value.more.key?('label')
      (node.list? ? node.sequence : [node]).map { |one| new(one, value, commands.mode(value)) }
    end

    def self.shared(value, node, commands)
      other = commands.find(node.word)
      node.refuse("is #{node.word}, whose row has no request") if other.nil? || other == value || !other.more.key?('http')
      []
    end
    private_class_method :shared

    # What the handler sets in the payload: {field => expression in C}; nil: the handler is written. `tables`: the values of words
    # by their places in the body's member: {field => constants}.
    attr_reader :fields, :tables

    def initialize(node, value, mode)
      own = node.mapping(%w[path], OPTIONAL + OWN)
      @takes = own.delete('takes')&.all.to_h
      @leaves = own.delete('leaves')&.sequence.to_a.map(&:word)
      @by_hand = own.delete('by_hand')
      @tables = {}
      @is_listed = own.delete('listed')&.true? != false
      super(node, usual(node, value, mode, own).merge(own))
      @command = value
    end

    def check(model, routes)
      @says = model.commands.with_workphases(says, command)
      super
      @fields = read_fields(model.commands.payloads.of(command)) unless handler
      refuse_without_reason
    end

    def listed?
      @is_listed
    end

    private

    def usual(node, value, mode, own)
      plain = { 'name' => value.name.downcase, 'method' => 'POST', 'who' => 'OPERATOR', 'authority' => true, 'answer' => ACT }
      plain['body'] = BARE['body'] unless own.key?('answer')
      plain['body_most'] = BARE['body_most'] if plain.key?('body') || own.key?('body')
      says = mode ? "#{mode.value.says.delete_suffix('.')}, under the pedal." : value.says
      node.stands_for(plain, 'says' => says).all
    end

    def refuse_without_reason
      node.refuse('has a handler, but not by_hand, why it is written') if handler && @by_hand.nil?
      @by_hand&.refuse('stands without a handler') unless handler
      @by_hand&.text
    end

    def read_fields(payload)
      node.refuse('has no handler and no body') unless body
      names = payload ? filled(payload).to_h { |field| [field, member_of(field)] } : {}
      unread = body.members.map(&:name) - ['id'] - names.values
      node.refuse("needs a handler for #{unread.join(', ')} of its body") unless unread.empty?
      names.to_h { |field, name| [field.name, expression(field, name)] }
    end

    def filled(payload)
      payload.structure.fields.reject { |field| @leaves.include?(field.name) }
    end

    def member_of(field)
      taken = @takes[field.name]
      return field.name unless taken

      taken.scalar? ? taken.word : taken.all.keys.first
    end

    def expression(field, name)
      return "call->path.#{name}" if value == name

      member = body.members.find { |one| one.name == name }
      return translated(field, member) if member&.words && @takes.key?(field.name) && !@takes[field.name].scalar?

      is_same = member && !member.list? && !member.optional? && field.count.nil? &&
                (member.enumeration ? member.enumeration == field.type.enumeration : member.type == field.type.name)
      node.refuse("needs a handler for the field #{field.name} of its command") unless is_same
      "body->#{name}"
    end

    # Words of the body alone, each with its value of the field's enumeration.
    def translated(field, member)
      words = @takes[field.name].all.fetch(member.name).all
      node.refuse("has the words #{words.keys.join(', ')}; expected #{member.words.join(', ')}") unless words.keys == member.words
      enumeration = field.type.enumeration || node.refuse("needs a handler for the field #{field.name} of its command")
      @tables[field.name] = words.values.map do |one|
        enumeration.constant(enumeration.values.find { |value| value.name == one.choice(enumeration.values.map(&:name)) })
      end
      "#{field.name}_values[body->#{member.name}]"
    end
  end

  # Everything of routes.yml, and the requests of commands.
  #
  # @satisfies SWR-TOOL-021
  class Routes
    attr_reader :problems, :requests, :routes

    def initialize(node, model)
      nodes = node.mapping(%w[problems requests routes])
      @problems = nodes['problems'].sequence.map { |one| Problem.read(one, model) }
      @requests = nodes['requests'].sequence.map { |one| RequestMessage.read(one) }
      all = nodes['routes'].sequence.map { |one| Route.new(one) } + model.commands.to_a.flat_map { |one| CommandRoute.of(one, model.commands) }
      @routes = all.group_by(&:path).values.flatten
      unique(@problems, &:name)
      unique(@routes, &:name)
      unique(@routes) { |route| [route.method, route.path] }
    end

    def check(model)
      requests.each { |request| request.check(model, requests) }
      requests.each(&:check_depth)
      routes.each { |route| route.check(model, self) }
    end

    def request(name)
      requests.find { |request| request.name == name }
    end

    def problem(name)
      problems.find { |problem| problem.name == name }
    end

    # "GET, HEAD" for its path.
    def allowed(path)
      methods = routes.select { |route| route.path == path }.map(&:method)
      methods.flat_map { |method| method == 'GET' ? %w[GET HEAD] : [method] }.join(', ')
    end

    # A body of one route alone has the name of the route, a body of several its own.
    def body_name(route)
      routes.one? { |other| other.body == route.body } ? route.name : route.body.name
    end

    private

    def unique(all, &key)
      all.group_by(&key).each_value { |same| same[1]&.node&.refuse("is the second #{key.call(same[1])}") }
    end
  end
end
