# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'node'
require_relative 'units'

module Interface
  # A member of a request's body, or a parameter of its query.
  class RequestMember
    # Type in C, and the bounds that a number has unless its member says others.
    PLAIN = {
      'flag' => ['bool', nil], 'uint32' => ['uint32_t', 0..(2**32) - 1], 'int32' => ['int32_t', -(2**31)..(2**31) - 1],
      'number' => ['double', -1_000_000_000..1_000_000_000], 'text' => ['char', nil]
    }.freeze
    WHOLE = %w[uint32 int32].freeze
    NAME_MOST = 47 # REQUEST_NAME_SIZE
    KEYS = %w[optional minimum maximum size list only unit].freeze

    attr_reader :name, :says, :node, :type, :words, :enumeration, :message, :size, :list, :minimum, :maximum, :unit

    def initialize(node)
      nodes = node.mapping(%w[name type], %w[says] + KEYS)
      @node = node
      @name = nodes['name'].identifier
      @says = nodes['says']&.text
      @is_optional = nodes.key?('optional') && nodes['optional'].true?
      @words = nodes['type'].sequence.map(&:identifier) if nodes['type'].list?
      @type = @words ? 'word' : nodes['type'].identifier
      @size = nodes['size']&.integer(1..65_535)
      @list = read_list(nodes['list'])
      @only = nodes['only']
      @unit = nodes['unit']
      read_bounds(nodes)
      node.refuse("has a name longer than #{NAME_MOST}") if name.size > NAME_MOST
    end

    def check(model, requests)
      find(model, requests) unless @words || PLAIN.key?(@type)
      node.refuse('is a text without a size') if (@type == 'text') != !@size.nil?
      check_some
      node.refuse('has bounds, but is no number') if @given && PLAIN[@type]&.last.nil?
      node.refuse("has the bounds #{minimum} to #{maximum}") if minimum && minimum > maximum
    end

    def optional?
      @is_optional
    end

    def list?
      !@list.nil?
    end

    def plain?
      PLAIN.key?(@type)
    end

    def whole?
      WHOLE.include?(@type)
    end

    def number?
      whole? || @type == 'number'
    end

    # [word, value] of a word.
    def choices
      return @words.each_with_index.to_a if @words

      values = @enumeration&.values.to_a
      values = values.select { |value| some.include?(value.name) } if some
      values.map { |value| [value.name, value.code] }
    end

    # The words of its enumeration that it may be; nil: all.
    def some
      @only&.sequence&.map(&:word)
    end

    def c_type
      return "request_#{@message.name}_t" if @message

      plain? ? PLAIN[@type].first : 'uint32_t'
    end

    private

    def read_bounds(nodes)
      range = PLAIN[@type]&.last
      @given = nodes.key?('minimum') || nodes.key?('maximum')
      return unless range

      @minimum, @maximum = %w[minimum maximum].map do |key|
        nodes[key] && (whole? ? nodes[key].integer(range) : nodes[key].decimal(range))
      end
      @minimum ||= range.begin
      @maximum ||= range.end
    end

    def check_some
      others = some.to_a - @enumeration&.values.to_a.map(&:name)
      @only.refuse("holds #{others.join(', ')}, which its type has not") unless others.empty?
    end

    def read_list(node)
      return unless node

      ends = node.sequence.map { |one| one.integer(0..10_000) }
      node.refuse('is not [least, most]') unless ends.size == 2 && ends.first <= ends.last && ends.last.positive?
      ends
    end

    def find(model, requests)
      @enumeration = model.enumeration(@type)
      @message = requests.find { |request| request.name == @type }
      node.refuse("is of #{@type}; expected #{PLAIN.keys.join(', ')}, [words], an enumeration or a request") \
        unless @enumeration || @message
    end
  end

  # Members of a body, or the parameters of a query.
  class RequestMessage
    DEPTH = 8 # REQUEST_DEPTH
    MEMBERS_MOST = 32 # REQUEST_FIELDS_MOST

    # Sets of optional members of which a body has exactly one; empty: it may have any.
    attr_reader :name, :says, :members, :choices

    def self.read(node)
      nodes = node.mapping(%w[name says members], %w[one_of])
      new(nodes['name'].identifier, nodes['says'].text, nodes['members'].sequence.map { |one| RequestMember.new(one) }, node,
          nodes['one_of'])
    end

    def initialize(name, says, members, node, choices = nil)
      @name = name
      @says = says
      @members = members
      @node = node
      @choices = choices ? choices.sequence.map { |set| set.sequence.map(&:identifier) } : []
    end

    def check(model, requests)
      members.each { |member| member.check(model, requests) }
      members.select(&:number?).each { |one| Units.check(one.node, one.name, one.unit, members.map(&:name)) }
      members.group_by(&:name).each_value { |same| same[1]&.node&.refuse("is the second #{same.first.name} in #{name}") }
      others = @choices.flatten - members.select(&:optional?).map(&:name)
      @node.refuse("one_of of #{name} names #{others.join(', ')}, no optional member") unless others.empty?
      @node.refuse("#{name} has more than #{MEMBERS_MOST} members") if members.size > MEMBERS_MOST
    end

    # Once all are checked: none may hold itself.
    def check_depth(depth = 1)
      @node.refuse("#{name} holds more than #{DEPTH} objects in each other") if depth > DEPTH
      members.filter_map(&:message).each { |inner| inner.check_depth(depth + 1) }
    end

    def typescript
      "#{name.split('_').map(&:capitalize).join}Request"
    end
  end
end
