# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'node'
require_relative 'units'

module Interface
  # How a value looks in JSON: the C that adds `value` to `object` as `key`, and its type in TypeScript.
  module Forms
    Form = Struct.new(:c, :typescript, :needs, keyword_init: true)
    ALL = {
      'number' => Form.new(c: 'json_add_number(object, %<key>s, (double)%<value>s)', typescript: 'number'),
      'flag' => Form.new(c: 'json_add_flag(object, %<key>s, %<value>s != 0U)', typescript: 'boolean'),
      'is_zero' => Form.new(c: 'json_add_flag(object, %<key>s, %<value>s == 0U)', typescript: 'boolean'),
      'bit' => Form.new(c: 'json_add_flag(object, %<key>s, (%<value>s & %<of>s) != 0U)', typescript: 'boolean'),
      'named' => Form.new(c: 'json_add_named(object, %<key>s, %<of>s_name((int32_t)%<value>s), ' \
                             '%<of>s_text((int32_t)%<value>s))', typescript: 'Named<%<union>s>', needs: :enumeration),
      'name' => Form.new(c: 'json_add_text(object, %<key>s, %<of>s_name((int32_t)%<value>s))', typescript: '%<union>s',
                         needs: :enumeration),
      'set' => Form.new(c: 'json_add_set(object, %<key>s, %<value>s, %<count>dU, %<of>s_name, %<of>s_text)',
                        typescript: 'Named<%<union>s>[]', needs: :enumeration),
      'state' => Form.new(c: 'json_add_text(object, %<key>s, chart_%<of>s_name(%<value>s))', typescript: '%<union>s',
                          needs: :leaves),
      'matrix' => Form.new(c: 'json_add_matrix(object, %<key>s, &%<value>s)', typescript: 'number[]'),
      'point' => Form.new(c: 'json_add_point(object, %<key>s, &%<value>s)', typescript: 'number[]'),
      'position' => Form.new(c: 'json_add_number(object, %<key>s, telemetry_units_position(axis, %<value>s))',
                             typescript: 'number', needs: :axis),
      'speed' => Form.new(c: 'json_add_number(object, %<key>s, telemetry_units_speed(axis, %<value>s))',
                          typescript: 'number', needs: :axis)
    }.freeze
    SPECIAL = { 'matrix' => 'rigid', 'point' => 'point' }.freeze

    def self.check(shown, field, model)
      form = ALL[shown.form] || shown.node.refuse("has the form #{shown.form}; expected #{ALL.keys.join(', ')}")
      fits?(shown, field, form, model) ||
        shown.node.refuse("has the form #{shown.form}, which #{field.type.name} has not")
      shown.node.refuse('has the form bit; expected bit MACRO') if (shown.form == 'bit') == shown.argument.nil?
    end

    def self.fits?(shown, field, form, model)
      return false if field.type.structure
      return field.type.name == SPECIAL[shown.form] if [field.type.name, SPECIAL[shown.form]].intersect?(SPECIAL.values)

      case form.needs
      when :enumeration then field.type.enumeration && (shown.form == 'set') == field.type.name.start_with?('bits')
      when :leaves then field.type.name.start_with?('chart')
      when :axis then model.message(shown.message).axis?
      else true
      end
    end
  end

  # Member that the server adds to a message.
  class Member
    # Type in C and in TypeScript, and the C that adds it.
    TYPES = {
      'uint32' => ['uint32_t', 'number', 'json_add_number(object, %<key>s, (double)%<value>s)'],
      'int32' => ['int32_t', 'number', 'json_add_number(object, %<key>s, (double)%<value>s)'],
      'uint64' => ['uint64_t', 'number', 'json_add_number(object, %<key>s, (double)%<value>s)'],
      'number' => ['double', 'number', 'json_add_number(object, %<key>s, %<value>s)'],
      'flag' => ['bool', 'boolean', 'json_add_flag(object, %<key>s, %<value>s)'],
      'text' => ['const char *', 'string', 'json_add_text(object, %<key>s, %<value>s)']
    }.freeze
    ITEM = ['cJSON *', nil, 'json_add_item(object, %<key>s, %<value>s)'].freeze
    # Ranges of whole numbers; a script's are exact up to 2**53.
    WHOLE = { 'uint32' => [0, (2**32) - 1], 'int32' => [-(2**31), (2**31) - 1], 'uint64' => [0, (2**53) - 1] }.freeze
    # The names of all problems and statuses.
    CODES = 'problem_code'

    # `bounds`: least and most of a whole number, nil of all others.
    attr_reader :name, :says, :node, :type, :words, :enumeration, :message, :bounds, :unit

    def initialize(node)
      nodes = node.mapping(%w[name type], %w[says or_null optional list minimum maximum unit])
      @node = node
      @name = nodes['name'].identifier
      @says = nodes['says']&.text
      @is_null = nodes.key?('or_null') && nodes['or_null'].true?
      @is_optional = nodes.key?('optional') && nodes['optional'].true?
      @is_list = nodes.key?('list') && nodes['list'].true?
      @words = nodes['type'].sequence.map(&:identifier) if nodes['type'].list?
      @type = @words ? 'text' : nodes['type'].identifier
      @bounds = read_bounds(nodes)
      @unit = nodes['unit']
    end

    def check(model)
      return if TYPES.key?(@type) || codes?

      @message = model.message(@type)
      @enumeration = model.enumeration(@type) unless @message
      node.refuse("is of #{@type}; expected #{TYPES.keys.join(', ')}, an enumeration or a message") unless
        @enumeration || @message
      @type = 'text' if @enumeration
    end

    def codes?
      @type == CODES
    end

    def number?
      WHOLE.key?(@type) || @type == 'number'
    end

    def optional?
      @is_optional
    end

    def list?
      @is_list
    end

    def c
      type = item? ? ITEM.first : TYPES[plain_type].first
      @is_null && @type == 'number' && !item? ? 'const double *' : type
    end

    def add(value)
      return "json_add_item(object, \"#{name}\", #{value})" if item?

      format(TYPES[plain_type].last, key: "\"#{name}\"", value: @type == 'number' && @is_null ? "*#{value}" : value)
    end

    def null?
      @is_null
    end

    def typescript
      type = @message ? @message.typescript : TYPES.dig(@type, 1)
      type = @words.map { |word| "\"#{word}\"" }.join(' | ') if @words
      type += '[]' if @is_list
      type += ' | null' if @is_null
      type
    end

    private

    def read_bounds(nodes)
      range = WHOLE[@type]
      given = %w[minimum maximum].filter_map { |key| nodes[key] }
      given.first&.refuse('bounds what is no whole number') unless range
      range && %w[minimum maximum].zip(range).map { |key, end_of_all| nodes[key]&.integer(Range.new(*range)) || end_of_all }
    end

    def item?
      @is_list || @message
    end

    def plain_type
      codes? ? 'text' : @type
    end
  end

  # An object that the HTTP server sends.
  class Message
    attr_reader :name, :says, :members

    def initialize(node)
      nodes = node.mapping(%w[name says], %w[axis by_hand members])
      @node = node
      @name = nodes['name'].identifier
      @says = nodes['says'].text
      @is_by_hand = nodes.key?('by_hand') && nodes['by_hand'].true?
      @is_axis = nodes.key?('axis') && nodes['axis'].true?
      @members = nodes.key?('members') ? nodes['members'].sequence.map { |member| Member.new(member) } : []
    end

    def axis?
      @is_axis
    end

    # It has no generated writer.
    def by_hand?
      @is_by_hand
    end

    def check(model)
      members.each { |member| member.check(model) }
      shown = model.sources(self).values.flatten(1)
      keys = shown.map { |_, one| [one.key, one.node] } + members.map { |member| [member.name, member.node] }
      @node.refuse("#{name} holds nothing") if keys.empty?
      stray = members.find(&:optional?) unless by_hand?
      stray&.node&.refuse('is for messages by_hand alone')
      keys.group_by(&:first).each_value { |same| same[1]&.last&.refuse("is the second #{same[1].first} in #{name}") }
      check_units(shown, keys.map(&:first))
    end

    def typescript
      name.split('_').map(&:capitalize).join
    end

    private

    def check_units(shown, names)
      shown.each do |field, one|
        Units.check_form(one, names) if Units::FORMS.key?(one.form)
        Units.check(one.node, one.key, field.unit, names) if Units::NUMBERS.include?(one.form)
      end
      members.select(&:number?).each { |one| Units.check(one.node, one.name, one.unit, names) }
    end
  end
end
