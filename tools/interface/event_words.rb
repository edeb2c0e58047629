# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'c'
require_relative 'events'

module Interface
  # Kinds of subject, value and peer of an event, for app/common/event_text.c.
  class EventWords
    FROM = 'core/interface/events.yml'
    SAYS = 'What the numbers of an event are.'

    def initialize(model)
      @model = model
      @ids = model.enumeration('event_id')
      @causes = model.enumeration('event_cause')
      @events = model.events
    end

    def files
      @events ? { 'event_words.h' => header, 'event_words.c' => source } : {}
    end

    private

    def header
      C.file(SAYS, FROM) + C.guard('event_words', <<~CODE)
        #include "interface/event.h"

        #include <stdint.h>

        /** Kind of a number that no enumeration names. */
        typedef enum {
            EVENT_WORD_NONE,
        #{Events::KINDS.map { |kind| "    EVENT_WORD_#{kind.upcase}" }.join(",\n")}
        } event_word_t;

        /** Kind of the subject; EVENT_WORD_NONE when it has none, or a name. */
        event_word_t event_subject_word(uint32_t id);

        /** Name of the subject, NULL when it has none. Lives for ever. */
        const char *event_subject_name(uint32_t id, uint32_t subject);

        /** Owner of the subject, as the value says, if there are several of it. */
        event_word_t event_subject_owner(uint32_t id, uint32_t subject);

        /** Word for the value, NULL when it is a number. Lives for ever. */
        const char *event_value_name(uint32_t id, int32_t value);

        /** Sentence for the value, NULL when no enumeration has it. Lives for ever. */
        const char *event_value_text(uint32_t id, int32_t value);

        /** Unit of the value with a space before it, or "". Lives for ever. */
        const char *event_value_unit(uint32_t id);

        /** Name of the value, such as "correction"; NULL: it has none. Lives for ever. */
        const char *event_value_title(uint32_t id);

        /** Kind of the peer of a cause. */
        event_word_t event_peer_word(uint32_t cause);
      CODE
    end

    def source
      <<~CODE
        #{C.file(SAYS, FROM).chomp}
        #include "event_words.h"

        #{(@events.owned.map(&:header) - ['event'] + ['app/names']).sort.map { |name| "#include \"interface/#{name}.h\"" }.join("\n")}

        #include <stddef.h>

        #{[subject_word, subject_name, subject_owner, value_name, value_text, value_unit, value_title, peer_word].join("\n")}
      CODE
        .sub(/\n+\z/, "\n")
    end

    def subject_word
      results = each_event { |event| "EVENT_WORD_#{event.subject.upcase}" if event.subject.is_a?(String) }
      choose('event_word_t event_subject_word(uint32_t id)', 'id', results, 'EVENT_WORD_NONE')
    end

    def subject_name
      results = each_event do |event|
        "#{event.subject.name}_name((int32_t)subject)" if event.subject.is_a?(Enumeration)
      end
      choose('const char *event_subject_name(uint32_t id, uint32_t subject)', 'id', results, 'NULL')
    end

    def subject_owner
      results = each_event { |event| owner(event.subject) if @events.owned.include?(event.subject) }
      choose('event_word_t event_subject_owner(uint32_t id, uint32_t subject)', 'id', results, 'EVENT_WORD_NONE')
    end

    # In C, nested: the subject says it.
    def owner(enumeration)
      values = enumeration.values.select { |value| value.more.key?('of') }
      values.map { |value| "(subject == (uint32_t)#{enumeration.constant(value)}) ? #{word(value.more['of'])}" }
            .push('EVENT_WORD_NONE').join(' : ')
    end

    def word(node)
      "EVENT_WORD_#{node.choice(Events::OWNERS).upcase}"
    end

    def value_name
      results = each_event do |event|
        case event.amount
        when Array then "(value != 0) ? #{C.string(event.amount.last)} : #{C.string(event.amount.first)}"
        when Enumeration then "#{event.amount.name}_name(value)"
        end
      end
      choose('const char *event_value_name(uint32_t id, int32_t value)', 'id', results, 'NULL')
    end

    def value_text
      results = each_event { |event| "#{event.amount.name}_text(value)" if event.amount.is_a?(Enumeration) }
      unused = results.empty? ? "    (void)value; /* None is counted. */\n" : ''
      choose('const char *event_value_text(uint32_t id, int32_t value)', 'id', results, 'NULL', unused)
    end

    def value_unit
      results = each_event { |event| C.string(" #{event.amount}") if Events::UNITS.include?(event.amount) }
      choose('const char *event_value_unit(uint32_t id)', 'id', results, '""')
    end

    # @satisfies SWR-TOOL-483
    def value_title
      results = each_event { |event| C.string(event.title) if event.title }
      choose('const char *event_value_title(uint32_t id)', 'id', results, 'NULL')
    end

    def peer_word
      results = @events.causes.compact.map { |cause, kind| [@causes.constant(cause), "EVENT_WORD_#{kind.upcase}"] }
      choose('event_word_t event_peer_word(uint32_t cause)', 'cause', results, 'EVENT_WORD_NONE')
    end

    # [event, result] for each event with a result.
    def each_event
      @events.events.filter_map do |event|
        result = yield(event)
        [@ids.constant(event.value), result] if result
      end
    end

    # A function that returns what belongs to `key`.
    def choose(prototype, key, results, otherwise, first = '')
      cases = results.group_by(&:last).map do |result, rows|
        "#{rows.map { |constant, _| "    case #{constant}:\n" }.join}        return #{result};\n"
      end
      "#{prototype}\n{\n#{first}    switch (#{key}) {\n#{cases.join}    default:\n        return #{otherwise};\n    }\n}\n"
    end
  end
end
