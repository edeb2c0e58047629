# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'node'

module Interface
  # Placeholders in the sentences of events, checked.
  class Events
    # Kinds of a number that is no enumeration's.
    KINDS = %w[axis card part length number].freeze
    OWNERS = %w[axis card].freeze
    UNITS = %w[ticks percent nm millionths].freeze
    WORDS = 2
    PLACE = /\{(\w*)\}/

    # `subject`, `peer`: a kind of KINDS or an enumeration; `value`: an enumeration, a unit, number, or two words.
    Event = Struct.new(:value, :severity, :subject, :amount, keyword_init: true)

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
      event = Event.new(value: value, severity: severity.choice(severities), subject: subject(value),
                        amount: amount(value))
      check_places(value, 'subject' => event.subject, 'value' => event.amount)
      event
    end

    def needed(name)
      @model.enumeration(name) || raise(Refused.new('core/interface', name, 'is missing'))
    end

    def names(name)
      needed(name).values.map { |value| value.name.downcase }
    end

    def subject(value)
      node = value.more['subject']
      node && kind(node, KINDS)
    end

    def peer(cause)
      node = cause.more['peer']
      result = node&.choice(KINDS)
      check_places(cause, 'peer' => result)
      result
    end

    def amount(value)
      node = value.more['value'] || return
      return kind(node, UNITS + ['number']) unless node.list?

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
    def check_places(value, kinds)
      places = value.says.scan(PLACE).flatten
      places = places.map { |place| place == 'meaning' ? 'value' : place } if kinds['value'].is_a?(Enumeration)
      stranger = places.find { |place| kinds[place].nil? }
      value.node.refuse("says {#{stranger}}, which it has not") if stranger
      silent = kinds.compact.keys - places
      value.node.refuse("does not say {#{silent.first}}") if silent.any? && !quiet?(silent.first, kinds)
    end

    # A value that belongs to its subject is named with it.
    def quiet?(place, kinds)
      place == 'subject' && kinds['value'].nil?
    end
  end
end
