# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'expressions'

module Chart
  module C
    # Per region one switch over its leaves, per leaf one chain over the events, per decision one condition. What
    # happens with the transition found, the block says in one line of C.
    class Selection
      def initialize(document, regions, names, decisions, expressions)
        @document = document
        @regions = regions
        @names = names
        @decisions = decisions
        @expressions = expressions
      end

      # Defines the region's functions in code. eventless: the transitions without event, else those with one.
      # only: the events that the functions are called for, nil for any. Returns the name of the region's function, or
      # nil if there is nothing to select.
      def define(code, region, eventless, outcome, only = nil)
        @code = code
        @outcome = outcome
        @only = only
        @result = outcome.result
        busy = region.leaves.reject { |leaf| decisions(leaf, eventless).empty? }
        return nil if busy.empty?

        busy.each { |leaf| define_leaf(region, leaf, eventless) }
        define_region(region, busy, eventless)
      end

      private

      def decisions(leaf, eventless)
        found = @decisions.of(leaf)
        eventless ? found.slice(nil) : found.reject { |event, _decision| event.nil? }
      end

      def suffix(eventless)
        eventless ? '.at_rest' : ''
      end

      def leaf_function(region, leaf, eventless)
        "#{@names.stem(region.name)}.in.#{@names.stem(leaf.id)}#{suffix(eventless)}"
      end

      def region_function(region, eventless)
        "#{@outcome.verb}.#{@names.stem(region.name)}#{suffix(eventless)}"
      end

      def define_leaf(region, leaf, eventless)
        found = decisions(leaf, eventless)
        body = eventless ? decision_lines(found.fetch(nil)) : event_chain(found)
        @code.define(@result.type, leaf_function(region, leaf, eventless), @result.frame(body),
                     constant: @outcome.constant)
      end

      # Where no other event can come, the last one is not asked for.
      def event_chain(found)
        last = found.keys.last if @only && (@only - found.keys).empty?
        asked = found.keys - [last]
        return decision_lines(found.fetch(last)) if asked.empty?

        rows = asked.each_with_index.map do |event, index|
          opening = index.zero? ? 'if' : '} else if'
          ["#{opening} (event == #{@names.event(event)}) {", indent(decision_lines(found.fetch(event)))]
        end
        [rows, last ? remaining(last, found.fetch(last)) : others(found), '}']
      end

      def remaining(event, decision)
        ['} else {', "    /* #{@names.event(event)}: no other can come */", *indent(decision_lines(decision))]
      end

      def others(found)
        found.length > 1 ? ['} else {', '    /* not for this state */'] : []
      end

      def indent(lines)
        lines.flatten.map { |line| "    #{line}" }
      end

      def decision_lines(decision)
        return [@outcome.line(decision)] unless decision.is_a?(Decisions::Choice)

        condition, yes, no = @expressions.flatten(decision, @outcome.holder)
        [*broken("if (#{condition}) {"), *indent(decision_lines(yes)), *else_lines(no), '}']
      end

      def else_lines(decision)
        return [] if decision.nil?
        return ['} else {', *indent(decision_lines(decision))] unless decision.is_a?(Decisions::Choice)

        condition, yes, no = @expressions.flatten(decision, @outcome.holder)
        rest = no ? else_lines(no) : ['} else {', '    /* no guard holds */']
        [*broken("} else if (#{condition}) {"), *indent(decision_lines(yes)), *rest]
      end

      # A long condition continues at an operator.
      def broken(line)
        Layout.at_operators(line)
      end

      def define_region(region, busy, eventless)
        name = region_function(region, eventless)
        body = ["switch (#{@outcome.place(region)}->#{@names.field(region.name)}) {",
                @names.values(region).map { |leaf| region_case(region, leaf, busy, eventless) },
                'default:', '    /* damaged: the check repairs it */', '    break;', '}']
        @code.define(@result.type, name, @result.frame(body), constant: @outcome.constant)
        name
      end

      def region_case(region, leaf, busy, eventless)
        label = "case #{@names.value(region, leaf)}:"
        return [label, '    /* nothing to take */', '    break;'] unless busy.include?(leaf)

        [label, "    #{@result.keep(@code.invoke(leaf_function(region, leaf, eventless)))}", '    break;']
      end
    end

    # What a function of the selection returns: nothing, or the number of a transition.
    Result = Struct.new(:type) do
      def frame(body)
        type == 'void' ? body : ["#{type} found = 0U;", '', *body, 'return found;']
      end

      def keep(call)
        type == 'void' ? "#{call};" : "found = #{call};"
      end
    end

    # verb: how the functions begin; holder: where guards read; pictured: regions that are read there as well;
    # line: a block from a transition to one line of C.
    Outcome = Struct.new(:verb, :result, :constant, :holder, :pictured, :block) do
      def place(region)
        pictured.include?(region) ? holder : 'self'
      end

      def line(transition)
        block.call(transition)
      end
    end
  end
end
