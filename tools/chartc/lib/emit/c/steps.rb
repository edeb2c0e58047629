# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../../flatten/sequences'

module Chart
  module C
    # The statements for a sequence of exits, content and entries.
    class Steps
      def initialize(names, regions, expressions)
        @names = names
        @regions = regions
        @expressions = expressions
      end

      def lines(steps)
        without_restarts(steps).chunk_while { |one, other| one.is_a?(Act) && other.is_a?(Act) }.flat_map do |group|
          group.first.is_a?(Act) ? acts(group) : statement(group.first)
        end
      end

      private

      # A timer that is started anew need not be stopped before.
      def without_restarts(steps)
        steps.reject.with_index do |step, index|
          step.is_a?(Cancel) && steps.drop(index).grep(Send).map(&:timer).include?(step.timer)
        end
      end

      def acts(group)
        masks = group.map { |act| @names.action(act.name) }.uniq
        ["run->actions |= #{masks.length > 1 ? "(#{masks.join(' | ')})" : masks.first};"]
      end

      def statement(step)
        case step
        when Enter then ["#{@names.function("enter.#{@names.stem(step.region.name)}")}(self, " \
                         "#{@names.value(step.region, step.leaf)});"]
        when Remember then ["self->#{@names.memory(step.memory)} = self->#{@names.field(step.memory.region.name)};"]
        when Raise then ["#{@names.function('raise_event')}(run, #{@names.event(step.event)});"]
        when Send then ["#{@names.function("start.#{@names.stem(step.timer.id)}")}(self);"]
        when Cancel then ["#{@names.function("stop.#{@names.stem(step.timer.id)}")}(self);"]
        when Assign then ["self->#{@names.field(step.variable.name)} = #{@expressions.text(step.expression)};"]
        when Switch then switch(step)
        when Finish then finish(step)
        end
      end

      def switch(step)
        memory = step.subject.is_a?(Memory)
        region = memory ? step.subject.region : step.subject
        field = memory ? @names.memory(step.subject) : @names.field(region.name)
        listed = step.cases.flat_map(&:first)
        ["switch (self->#{field}) {",
         step.cases.map { |leaves, steps| branch(region, leaves, lines(steps)) },
         branch(region, @names.values(region) - listed, [], 'default:'), '}'].flatten
      end

      def branch(region, leaves, body, last = nil)
        labels = leaves.map { |leaf| "case #{@names.value(region, leaf)}:" }
        [*labels, *last, *body.map { |line| "    #{line}" }, '    break;']
      end

      # The other regions of the parallel are final too.
      def finish(step)
        others = @regions.children(step.parallel) - [step.region]
        tests = others.map { |region| final(region) }
        raised = statement(Raise.new(step.event))
        tests.empty? ? raised : ["if (#{tests.join(' && ')}) {", *raised.map { |line| "    #{line}" }, '}']
      end

      def final(region)
        finals = region.leaves.select { |leaf| leaf.kind == :final && leaf.parent == region.state }
        tests = finals.map { |leaf| "(self->#{@names.field(region.name)} == #{@names.leaf(leaf)})" }
        return '(false)' if tests.empty?

        tests.length == 1 ? tests.first : "(#{tests.join(' || ')})"
      end
    end
  end
end
