# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'node'

module Interface
  # Placeholders in the sentences of events, checked.
  class Events
    # Kinds of a number that is no enumeration's.
    KINDS = %w[axis card part length number].freeze
    OWNERS = %w[axis card].freeze
    # The sentence gets these behind the number.
    UNITS = %w[ticks percent nm millionths].freeze
    # The sentence has these in its own words; nil: it needs none.
    OWN_WORDS = { 'us' => 'us', 'ms' => 'ms', 'min' => 'min', 'hz' => 'Hz', 'mn' => 'mN', 'tenths_c' => 'tenths of a degree Celsius',
                  'count' => nil, 'number' => nil }.freeze
    WORDS = 2
    PLACE = /\{(\w*)\}/

    # `subject`, `peer`: a kind of KINDS or an enumeration; `amount`, of the value: an enumeration, a unit, count, number, or two
    # words; `title`, `subject_title`: their names.
    Event = Struct.new(:value, :severity, :subject, :subject_title, :amount, :title, :unsaid, keyword_init: true) do
      # Of the value, for people: "correction, ticks"; nil: none.
      def about
        return unless title

        kind = amount.is_a?(Array) ? amount.join(' or ') : (amount.is_a?(Enumeration) ? amount.name : amount)
        [title, kind].uniq.join(', ')
      end
    end

    attr_reader :events, :causes

    def initialize(model)
      @model = model
      @ids = model.enumeration('event_id')
      raise Refused.new('core/interface', 'event_id', 'says no count') unless @ids.counted?

      severities = names('event_severity')
      @events = @ids.values.map { |value| event(value, severities) }
      @causes = needed('event_cause').values.to_h { |cause| [cause, peer(cause)] }
    end

    # The severity of each value of event_id, in words.
    def severities
      @events.to_h { |event| [event.value, event.severity] }
    end

    # The enumerations whose values may be of one card or axis of several, named by the event's value.
    def owned
      @events.map(&:subject).grep(Enumeration).uniq.select { |one| one.values.any? { |value| value.more.key?('of') } }
    end

    private

    def event(value, severities)
      severity = value.more['severity'] || value.node.refuse('has no severity')
      subject_title, subject = subject(value)
      title, amount = amount(value)
      event = Event.new(value: value, severity: severity.choice(severities), subject: subject, subject_title: subject_title,
                        amount: amount, title: title, unsaid: value.more['unsaid']&.true?)
      check_places(value, { 'subject' => subject, 'value' => amount }, event.unsaid)
      check_unit(value, amount)
      event
    end

    def needed(name)
      @model.enumeration(name) || raise(Refused.new('core/interface', name, 'is missing'))
    end

    def names(name)
      needed(name).values.map { |value| value.name.downcase }
    end

    # [name, kind]. A number of no kind has a name of its own.
    def subject(value)
      node = value.more['subject'] || return
      return named(node) { |type| type.choice(['number']) } unless node.scalar?

      node.refuse('is number without a name; expected {NAME: number}') if node.word == 'number'
      found = kind(node, KINDS - ['number'])
      [found.is_a?(Enumeration) ? found.name : found, found]
    end

    # [name, what the block makes of the node behind it].
    def named(node)
      pairs = node.all
      node.refuse("has #{pairs.size} names; expected one, {NAME: TYPE}") unless pairs.size == 1
      name, type = pairs.first
      [name, yield(type)]
    end

    def peer(cause)
      node = cause.more['peer']
      result = node&.choice(KINDS)
      check_places(cause, { 'peer' => result })
      result
    end

    def amount(value)
      node = value.more['value'] || return
      node.refuse('has no name; expected {NAME: TYPE}') if node.scalar? || node.list?
      named(node) { |type| type_of(type) }
    end

    def type_of(node)
      return kind(node, UNITS + OWN_WORDS.keys) unless node.list?

      words = node.sequence.map(&:identifier)
      node.refuse("has #{words.size} words; expected #{WORDS}, for 0 and 1") unless words.size == WORDS
      words
    end

    def kind(node, others)
      name = node.identifier
      return name if others.include?(name)

      @model.enumeration(name) || node.refuse("is #{name}; expected #{others.join(', ')} or an enumeration")
    end

    # The sentence names what there is, and nothing else. {meaning} is what the enumeration says of the value.
    def check_places(value, kinds, unsaid = false)
      places = value.says.scan(PLACE).flatten
      places = places.map { |place| place == 'meaning' ? 'value' : place } if kinds['value'].is_a?(Enumeration)
      unknown = places.find { |place| kinds[place].nil? }
      value.node.refuse("says {#{unknown}}, which it has not") if unknown
      silent = kinds.compact.keys - places - (unsaid ? ['value'] : [])
      value.node.refuse("does not say {#{silent.first}}") if silent.any? && !quiet?(silent.first, kinds)
    end

    # A unit that does not stand behind the number stands in the sentence.
    def check_unit(value, amount)
      words = OWN_WORDS[amount]
      value.node.refuse("has a value in #{amount} and does not say #{words}") if words && !value.says.include?(words)
    end

    # A value that belongs to its subject is named with it.
    def quiet?(place, kinds)
      place == 'subject' && kinds['value'].nil?
    end
  end
end
