# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'worst_case_program'

module WorstCase
  # The stack that functions need at most, from the call graph that gcc writes with -fcallgraph-info=su. A call in the
  # place of a return counts as any other, so the figure is a bound.
  class Stack
    NODE = /^node: \{ title: "(?:[^"]*:)?([\w.]+)" label: "[^"]*\\n(\d+) bytes \(static\)"/
    EDGE = /^edge: \{ sourcename: "(?:[^"]*:)?([\w.]+)" targetname: "(?:[^"]*:)?([\w.]+)"/
    # It ends in the safe state and does not return; what it needs is not the chart's.
    ENDS = 'contract_broken'

    # places: of the functions in the code, by name.
    def initialize(call_graph, places = {})
      @places = places
      @bytes = call_graph.scan(NODE).to_h { |name, bytes| [name, bytes.to_i] }
      @called = call_graph.scan(EDGE).uniq.group_by(&:first).transform_values { |edges| edges.map(&:last) - [ENDS] }
    end

    def deepest(functions)
      functions.map { |name| depth(name) }.max
    end

    private

    def depth(name)
      node = @bytes.key?(name) ? name : twin(name)
      @bytes[node] + deepest(@called.fetch(node, [])).to_i
    end

    # Gcc keeps one of several equal functions, under all their names.
    def twin(name)
      place = @places.fetch(name) { raise Failed, "the stack of #{name} is unknown" }
      @bytes.keys.find { |other| @places[other] == place } || raise(Failed, "the stack of #{name} is unknown")
    end
  end
end
