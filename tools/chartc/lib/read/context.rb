# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../refusal'
require_relative 'profile'

module Chart
  # What every reader of a chart knows: its file, the mode, the limits, and how to refuse.
  class Context
    attr_reader :file, :mode, :limits

    def initialize(file, mode, limits)
      @file = file
      @mode = mode
      @limits = limits
    end

    def engine?
      mode == :engine
    end

    # Read for what it says, not for whether it may be compiled: conformance charts, and versions that are compared.
    def lenient?
      mode != :product
    end

    def refuse(line, rule, message)
      raise Refusal.new(file, line, rule, message)
    end

    def name(text, line)
      return text if text.match?(lenient? ? Profile::LOOSE_NAME : Profile::NAME)

      refuse(line, 6, "\"#{text}\" is no name here; write lower-case words joined by underscores, one name only")
    end

    def names(text, line)
      text.to_s.split.map { |word| name(word, line) }
    end

    # What an element without id is called: its place, since nothing else is in the file. Versions that are compared
    # may have moved, so there its number among its like stands.
    def unnamed(element, number)
      return "#{element.name}_#{number}" unless engine?

      place = "#{element.name} of line #{element.line}"
      count = (@unnamed ||= Hash.new(0))[place] += 1
      count == 1 ? place : "#{place} (#{count})"
    end

    # Ids of requirements or hazards.
    def claims(element, attribute)
      element.attributes.fetch(attribute, '').split.each do |word|
        next if lenient? || word.match?(Profile::ID)

        refuse(element.line, 9, "\"#{word}\" is no id; write AREA-NAME-nnn in #{attribute}")
      end
    end

    # What to write instead, as a refusal ends.
    def choice(names)
      names.empty? ? 'remove it' : "write one of: #{names.uniq.join(', ')}"
    end

    # all: [id, line] of each. Two of one id are refused, the later one.
    def unique(all, rule)
      all.sort_by(&:last).group_by(&:first).each do |id, ((_id, earlier), (_same, later))|
        next unless later

        refuse(later, rule, "id \"#{id}\" stands in line #{earlier} already; choose another one")
      end
    end
  end
end
