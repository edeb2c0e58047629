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

    def initialize(call_graph)
      @bytes = call_graph.scan(NODE).to_h { |name, bytes| [name, bytes.to_i] }
      @called = call_graph.scan(EDGE).uniq.group_by(&:first).transform_values { |edges| edges.map(&:last) - [ENDS] }
    end

    def deepest(functions)
      functions.map { |name| depth(name) }.max
    end

    private

    def depth(name)
      raise Failed, "the stack of #{name} is unknown" unless @bytes.key?(name)

      @bytes[name] + deepest(@called.fetch(name, [])).to_i
    end
  end
end
