# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'c'
require_relative 'layout'

module Interface
  # The fields of what every process may write in the exchange's segment, as its header declares them: a test that damages
  # each of them forgets none.
  class SegmentFields
    STRUCTURE = /^typedef struct (?<braces>\{(?:[^{}]|\g<braces>)*\}) segment_others_t;/
    NESTED = /\{[^{}]*\}/
    FIELD = /\b(?<name>\w+)(?:\[(?<count>\w+)\])?(?:\s+SEGMENT_ON_LINE)?\z/

    def initialize(headers)
      @text = headers.map { |header| File.read(header, encoding: 'UTF-8').gsub(Layout::COMMENT, ' ') }
                     .filter_map { |text| text[STRUCTURE, :braces] }.first
    end

    # Names and counts; of what is no array, 1.
    def fields
      @text[1..-2].gsub(NESTED, '').split(';').map(&:strip).reject(&:empty?).map do |field|
        found = field.match(FIELD)
        [found[:name], found[:count] || '1U']
      end
    end

    def files
      return {} unless @text

      body = "/** Calls FIELD with the name and the count of elements of each field of segment_others_t. */\n" \
             "#define SEGMENT_OTHERS_FIELDS(FIELD) #{fields.map { |field| "\\\n    FIELD(#{field.join(', ')})" }.join(' ')}\n"
      { 'segment_fields.h' => C.file("Fields that every process may write in the exchange's segment.",
                                     'app/exchange/exchange_segment.h') + C.guard('segment_fields', body) }
    end
  end
end
