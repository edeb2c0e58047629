# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'scenario'

module Conformance
  # Compares what was seen with what was expected, and two machines with each other. Answers are sentences; none is
  # good.
  module Judge
    # The compiled chart remembers so many transitions of a step (CHART_TRACE_LENGTH).
    TRACE_LENGTH = 8

    module_function

    def golden(steps, seen)
      steps.zip(seen).each_with_index.flat_map do |(step, one), index|
        shown(one, step.expected).map { |what, found, wanted| words(index, step, what, found, wanted) }
      end
    end

    # Rows [what, found, wanted] that differ.
    def shown(seen, expected)
      expected.filter_map do |what, wanted|
        found = found_of(seen, what, wanted)
        [what, found, wanted] unless found == (wanted.is_a?(Array) ? wanted.sort : wanted)
      end
    end

    def found_of(seen, what, wanted)
      case what
      when :in then seen.leaves.sort
      when :data then seen.data.slice(*wanted.keys)
      when :armed, :actions then seen[what].sort
      else seen[what]
      end
    end

    # The compiled chart does not report the actions and transitions of its start.
    def same(steps, seen, interpreted)
      steps.each_index.flat_map do |index|
        fields = %i[leaves history data armed]
        fields += %i[actions taken] unless steps[index].kind == :start
        fields.filter_map do |what|
          found, wanted = [seen, interpreted].map { |list| value(list[index], what) }
          words(index, steps[index], what, found, "#{wanted} as interpreted") unless found == wanted
        end
      end
    end

    def value(seen, what)
      what == :taken ? seen.taken.last(TRACE_LENGTH) : seen[what]
    end

    def words(index, step, what, found, wanted)
      "step #{index} (#{[step.kind, *step.value].join(' ')}): #{what} is #{found}, not #{wanted}"
    end
  end
end
