# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'node'

module Interface
  # Type of a field: in C, in JSON and in TypeScript.
  class Type
    # C type, its header, bytes, and the form it has in JSON unless its field says another.
    PLAIN = {
      'uint32' => ['uint32_t', nil, 4, 'number'], 'int32' => ['int32_t', nil, 4, 'number'],
      'uint64' => ['uint64_t', nil, 8, 'number'], 'flag' => ['uint32_t', nil, 4, 'flag'],
      'point' => ['point_t', 'base/rigid', 12, 'point'], 'rigid' => ['rigid_t', 'base/rigid', 48, 'matrix']
    }.freeze
    KINDS = %w[chart bits payload].freeze

    # `payloads`: the structures of which it is one, by the kind or the form beside it; otherwise nil.
    attr_reader :enumeration, :structure, :leaves, :payloads

    def initialize(node)
      @node = node
      @kind, @of, rest = node.words
      is_paired = KINDS.include?(@kind)
      node.refuse("is #{node.words.join(' ')}; expected a type such as uint32 or chart axis.power") \
        if rest || is_paired == @of.nil?
    end

    def check(model)
      case @kind
      when 'chart' then chart(model)
      when 'bits'
        @enumeration = model.enumeration(@of) || @node.refuse("is bits of #{@of}, which is no enumeration")
      when 'payload'
        @payloads = model.payloads(@of) || @node.refuse("is the payload of #{@of}, whose values have none")
      else
        return if PLAIN.key?(@kind)

        @enumeration = model.enumeration(@kind)
        @structure = model.structure(@kind)
        @node.refuse("is #{@kind}; expected #{PLAIN.keys.join(', ')}, #{KINDS.join(' OF, ')} OF or a name of " \
                     'core/interface') unless @enumeration || @structure
      end
    end

    def c
      return PLAIN[@kind].first if PLAIN.key?(@kind)
      return @payloads.c_type if payload?

      @structure ? "#{@structure.name}_t" : 'uint32_t'
    end

    def header
      PLAIN.key?(@kind) ? PLAIN[@kind][1] : (@structure || @enumeration)&.header
    end

    def bytes
      return PLAIN[@kind][2] if PLAIN.key?(@kind)
      return @payloads.bytes if payload?

      @structure ? @structure.bytes : 4
    end

    def alignment
      return 8 if @kind == 'uint64'

      @structure ? @structure.fields.map { |field| field.type.alignment }.max : 4
    end

    def form
      return PLAIN[@kind].last if PLAIN.key?(@kind)
      return { 'chart' => 'state', 'bits' => 'set' }[@kind] if KINDS.include?(@kind)

      'named' if @enumeration
    end

    # Beginning of its C comment.
    def about
      case @kind
      when 'chart' then "#{@of.tr('.', '_')}_t."
      when 'bits' then "Bit mask of #{@of}_t."
      when 'flag' then '0 or 1.'
      else "#{@enumeration.c_type}." if @enumeration
      end
    end

    # "axis_power" of "chart axis.power".
    def chart_name
      @of.tr('.', '_')
    end

    def name
      [@kind, @of].compact.join(' ')
    end

    def bits?
      @kind == 'bits'
    end

    # One of several structures, as the kind beside it says.
    def payload?
      @kind == 'payload'
    end

    def flag?
      @kind == 'flag'
    end

    def status?
      @kind == 'status'
    end

    private

    def chart(model)
      return unless model.charts

      @leaves = model.charts[@of] || @node.refuse("is of #{@of}; expected one of #{model.charts.keys.join(', ')}")
    end
  end

  # How a field is shown in a message.
  class Shown
    attr_reader :message, :key, :form, :argument, :conditions, :node

    def initialize(node, field)
      @node = node
      return bare(node, field) if node.scalar?

      nodes = node.mapping(%w[in], %w[key as when])
      @message = nodes['in'].identifier
      @key = nodes.key?('key') ? nodes['key'].identifier : field
      @form, @argument = nodes['as'].words if nodes.key?('as')
      @conditions = nodes.key?('when') ? nodes['when'].sequence.map(&:identifier) : []
    end

    def check(model, structure, field)
      @node.refuse("is in #{message}, which is no message") unless model.message(message)
      @form ||= field.type.form || @node.refuse('has no form; say `as`')
      Forms.check(self, field, model)
      conditions.each { |name| structure.condition(name, @node) }
    end

    private

    def bare(node, field)
      @message = node.identifier
      @key = field
      @conditions = []
    end
  end

  # How a field is printed in the table of boresight-replay.
  Column = Struct.new(:place, :name, :form, :field, keyword_init: true) do
    def self.read(node, field)
      nodes = node.mapping(%w[place], %w[name as])
      new(place: nodes['place'].number, name: nodes.key?('name') ? nodes['name'].identifier : field.name,
          form: nodes.key?('as') ? nodes['as'].choice(%w[q8 output_percent]) : 'number', field: field)
    end
  end

  # A field of a structure.
  class Field
    attr_reader :name, :type, :says, :count, :shown, :column, :unit, :node

    def initialize(node)
      nodes = node.mapping(%w[name type], %w[says count shown column unit])
      @node = node
      @name = nodes['name'].identifier
      @type = Type.new(nodes['type'])
      @says = nodes['says']&.text
      @count = nodes['count']&.identifier(capitals: true)
      @shown = read_shown(nodes['shown'])
      @unit = nodes['unit']
      @column = Column.read(nodes['column'], self) if nodes.key?('column')
    end

    def check(model, structure)
      type.check(model)
      node.refuse('is an array; it cannot be shown') if count && (shown.any? || column)
      shown.each { |one| one.check(model, structure, self) }
    end

    def comment
      [type.about, says].compact.join(' ')
    end

    private

    def read_shown(node)
      return [] unless node

      (node.list? ? node.sequence : [node]).map { |one| Shown.new(one, name) }
    end
  end

  # One `struct` of fixed layout.
  class Structure
    attr_reader :name, :says, :fields, :header

    def initialize(node, header)
      nodes = node.mapping(%w[name fields], %w[says])
      @header = header
      @name = nodes['name'].identifier
      @says = nodes['says']&.text
      @fields = nodes['fields'].sequence.map { |field| Field.new(field) }
      unique
    end

    def check(model)
      fields.each { |field| field.check(model, self) }
      check_padding
    end

    def bytes
      fields.sum { |field| field.type.bytes }
    end

    # Whether it has the data of the values of `enumeration`.
    def carries?(enumeration)
      fields.any? { |field| field.type.name == "payload #{enumeration}" }
    end

    def shown_in(message)
      fields.flat_map { |field| field.shown.select { |one| one.message == message }.map { |one| [field, one] } }
    end

    def columns
      fields.filter_map(&:column).sort_by(&:place)
    end

    # A field that decides whether others are shown, as C: a flag that is 1, a status that is OK, one of what is counted.
    def condition(name, node)
      field = fields.find { |one| one.name == name } || node.refuse("is shown when #{name}, which is no field")
      return "(#{self.name}->#{name} != 0U)" if field.type.flag?
      return "(#{self.name}->#{name} == (uint32_t)STATUS_OK)" if field.type.status?
      return "(#{self.name}->#{name} < #{field.type.name.upcase}_COUNT)" if field.type.enumeration&.counted?

      node.refuse("is shown when #{name}, which is no flag, no status and of nothing that is counted")
    end

    def layout
      "struct #{name} #{fields.map { |field| "#{field.type.name}[#{field.count}]#{field.name}" }.join(' ')}"
    end

    private

    def unique
      fields.group_by(&:name).each_value { |same| same[1]&.node&.refuse("is the second #{same.first.name}") }
    end

    # An array is of whole words, so only its type counts.
    def check_padding
      fields.inject(0) do |place, field|
        field.node.refuse("has padding before #{field.name}") unless (place % field.type.alignment).zero?
        place + field.type.bytes
      end
      most = fields.map { |field| field.type.alignment }.max
      fields.last.node.refuse('has padding behind it') unless (bytes % most).zero?
    end
  end
end
