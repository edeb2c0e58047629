# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'command/answer_forms'
require_relative 'command/answers'
require_relative 'commands'
require_relative 'events'
require_relative 'message'
require_relative 'modes'
require_relative 'routes'
require_relative 'statuses'
require_relative 'structure'

module Interface
  # One `enum`: the only source of its names, numbers and sentences.
  class Enumeration
    KEYS = (%w[severity subject value unsaid of peer sets] + Statuses::KEYS + Modes::KEYS | Commands::KEYS).freeze
    # `robot`: whose own it is, nil for all.
    Value = Struct.new(:code, :name, :says, :node, :more, :robot, keyword_init: true)
    # Values that have something in common: bits of a number.
    Set = Struct.new(:name, :says, :values)
    SET_BITS = 64

    attr_reader :name, :prefix, :says, :values, :header, :sets

    # `added`: what others add to an enumeration that asks for it, by the key that asks: lists of nodes, by robot where each has
    # its own.
    def initialize(node, header, added = {})
      nodes = node.mapping(%w[name says values], %w[prefix count robots modes sets])
      @header = header
      @name = nodes['name'].identifier
      @says = nodes['says'].text
      @prefix = nodes.key?('prefix') ? nodes['prefix'].identifier(capitals: true) : @name.upcase
      @is_counted = nodes.key?('count') && nodes['count'].true?
      @has_robots = nodes.key?('robots') && nodes['robots'].choice(%w[refusals]) == 'refusals'
      has_modes = nodes.key?('modes') && nodes['modes'].choice(%w[commands]) == 'commands'
      @values = nodes['values'].sequence.map { |value| read(value) }
      node.refuse('has no values') if @values.empty?
      add(added.fetch('refusals', {})) if robots?
      add(nil => added.fetch('commands', [])) if has_modes
      unique(:code)
      unique(:name)
      @values.sort_by!(&:code) if robots? || has_modes
      check_gaps if counted?
      @sets = read_sets(nodes['sets'])
    end

    # Some of its values may belong to one robot alone.
    def robots?
      @has_robots
    end

    def counted?
      @is_counted
    end

    def c_type
      "#{name}_t"
    end

    def constant(value)
      "#{prefix}_#{value.name}"
    end

    # Layout that two programs must agree on.
    def layout
      "enum #{name} #{values.map { |value| "#{constant(value)}=#{value.code}#{value.more['payload']&.identifier}" }.join(' ')}"
    end

    private

    def read(node)
      nodes = node.mapping(%w[code name says], KEYS)
      Value.new(code: nodes['code'].number, name: nodes['name'].identifier(capitals: true), says: nodes['says'].text,
                node: node, more: nodes.slice(*KEYS))
    end

    # Each set, of the values that it lists and of those that list it.
    #
    # @satisfies SWR-TOOL-073
    def read_sets(node)
      sets = (node ? node.sequence : []).map { |set| read_set(set) }
      values.each { |value| value.more['sets']&.sequence.to_a.each { |one| add_to(sets, one, value) } }
      empty = sets.find { |set| set.values.empty? }
      node.refuse("has #{empty.name}, which has no values") if empty
      sets
    end

    def read_set(node)
      nodes = node.mapping(%w[name says], %w[values])
      node.refuse("is of a value with a code above #{SET_BITS - 1}") if values.any? { |value| value.code >= SET_BITS }
      names = nodes['values']&.sequence.to_a.map { |value| value.choice(values.map(&:name)) }
      Set.new(nodes['name'].identifier(capitals: true), nodes['says'].text,
              values.select { |value| names.include?(value.name) })
    end

    def add_to(sets, node, value)
      name = node.choice(sets.map(&:name))
      sets.find { |set| set.name == name }.values << value
    end

    def add(robots)
      robots.each { |robot, nodes| nodes.each { |node| @values << read(node).tap { |value| value.robot = robot } } }
    end

    # A counted value is an index, or a bit.
    def check_gaps
      gap = values.each_with_index.find { |value, index| value.code != index }
      gap&.first&.node&.refuse("has the code #{gap.first.code}; expected #{gap.last}, as it is counted")
    end

    def unique(key)
      values.group_by(&key).each_value do |same|
        same.drop(1).each { |other| other.node.refuse("has the #{key} of #{same.first.name}: #{other[key]}") }
      end
    end
  end

  # Values that the folders of robots add: the refusals that belong to one of them alone.
  #
  # @satisfies SWR-ROBOT-020
  module Robots
    # The nodes of each robot by its name, none without folders.
    def self.refusals(folder)
      parts(folder, 'refusals').transform_values { |refusals| refusals ? refusals.sequence : [] }
    end

    # The refusals of coupled limits, by name.
    def self.shared(folder)
      parts(folder, 'coupled_limits').values.compact.flat_map do |limits|
        limits.all.values.map { |limit| limit.at('refusal').word }
      end
    end

    # The part `name` of each robot's file; nil: it has none.
    def self.parts(folder, name)
      Dir.glob('*/kinematics.yml', base: folder).sort.to_h do |path|
        file = File.join(folder, path)
        [File.dirname(path), Node.parse(file, File.read(file, encoding: 'UTF-8')).at(name)]
      end
    end
  end

  # Everything that core/interface says, and core/robot beside it.
  class Model
    Header = Struct.new(:name, :says, :enumerations, :structures, :file)
    # Refusal by the soft limits of an axis.
    AXIS_LIMIT = 'AXIS_LIMIT'

    attr_reader :headers, :messages, :charts, :routes

    # `charts`: the leaves of "axis.power" in their order, as the chart compiler lists them; nil if no value asks.
    def initialize(folder, charts = nil)
      @charts = charts
      files = Dir[File.join(folder, '*.yml')].sort
      raise Refused.new(folder, 'folder', 'holds no *.yml') if files.empty?

      nodes = files.map { |file| [file, Node.parse(file, File.read(file, encoding: 'UTF-8'))] }
      @added = { 'refusals' => Robots.refusals(File.join(folder, '../robot')), 'commands' => Modes.commands(nodes.map(&:last)) }
      @shared = Robots.shared(File.join(folder, '../robot'))
      @messages = []
      @headers = nodes.filter_map { |file, node| read(file, node) }
      node = nodes.to_h.find { |file, _| file.end_with?('/routes.yml') }&.last
      @routes = Routes.new(node, self) if node
      check
    end

    def enumerations
      headers.flat_map(&:enumerations)
    end

    def structures
      headers.flat_map(&:structures)
    end

    def enumeration(name)
      enumerations.find { |enumeration| enumeration.name == name }
    end

    def structure(name)
      structures.find { |structure| structure.name == name }
    end

    def message(name)
      messages.find { |message| message.name == name }
    end

    def events
      @events ||= Events.new(self) if enumeration('event_id')
    end

    def modes
      @modes ||= Modes.new(self) if enumeration('mode_kind')
    end

    # None without workphases that they could be obeyed in.
    def commands
      @commands ||= Commands.new(self) if enumeration('command_kind')&.counted? && enumeration('workphase')
    end

    # Data of the values of an enumeration beside their kind; nil: none.
    def payloads(name)
      { 'command_kind' => commands&.payloads, 'answer_kind' => answer_forms }[name]
    end

    def statuses
      @statuses ||= Statuses.new(self) if enumeration(Statuses::NAME)
    end

    # None without commands or a verdict on them.
    def answers
      @answers ||= Answers.new(self) if commands && enumeration(Answers::KIND) && statuses
    end

    # None without answers that carry data.
    def answer_forms
      @answer_forms ||= AnswerForms.new(self) if answers && structure('answer')&.carries?('answer_kind')
    end

    # Whether a coupled limit of a robot, or a soft limit of an axis, refuses with `status`: then a refusal names the end.
    def limit_end?(status)
      status.name == AXIS_LIMIT || @shared.include?(status.name)
    end

    # The structures whose fields are shown in `message`, each with these fields and how.
    def sources(message)
      structures.to_h { |structure| [structure, structure.shown_in(message.name)] }.reject { |_, fields| fields.empty? }
    end

    # Type of the words of an enumeration or a region, for clients: no message has its name.
    def union_name(name)
      pascal = name.split('_').map(&:capitalize).join
      messages.any? { |message| message.typescript == pascal } ? "#{pascal}Name" : pascal
    end

    # Possible names of a problem.
    def problem_codes
      (routes.problems.map(&:name) + enumeration('status')&.values.to_a.map(&:name)).uniq
    end

    private

    def read(file, node)
      return if file.end_with?('/routes.yml')

      if file.end_with?('messages.yml')
        @messages = node.mapping(%w[messages])['messages'].sequence.map { |message| Message.new(message) }
        return
      end
      nodes = node.mapping(%w[header says], %w[enumerations structures])
      header = nodes['header'].identifier
      Header.new(header, nodes['says'].text,
                 list(nodes['enumerations']).map { |one| Enumeration.new(one, header, @added) },
                 list(nodes['structures']).map { |one| Structure.new(one, header) }, file)
    end

    def list(node)
      node ? node.sequence : []
    end

    def check
      names = (enumerations + structures).map(&:name)
      twice = names.find { |name| names.count(name) > 1 }
      raise Refused.new('core/interface', twice, 'is defined twice') if twice

      structures.each { |structure| structure.check(self) }
      messages.each { |message| message.check(self) }
      events
      modes
      statuses
      answers
      commands&.complete
      routes&.check(self)
    end
  end
end
