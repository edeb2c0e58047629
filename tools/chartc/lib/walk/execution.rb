# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../model'
require_relative '../read/expression'
require_relative 'outcome'

module Chart
  # What happens inside a microstep of the interpreter: executable content, done events, expressions.
  module Execution
    private

    # The done events of a final state: its parent's, and that of the parallel around it when all regions are done.
    def finish(state)
      parent = state.parent
      return if parent.root?

      cause("done.state.#{parent.id}")
      above = parent.parent
      cause("done.state.#{above.id}") if above.parallel? && done?(above)
    end

    # isInFinalState
    def done?(state)
      return state.substates.all? { |child| done?(child) } if state.parallel?

      state.substates.any? { |child| child.kind == :final && @configuration.anybits?(@tree.bit(child.id)) }
    end

    # A done event that nobody waits for is none.
    def cause(event)
      return unless @document.events.include?(event)

      @queue << event
      @raised << event
    end

    def execute(content)
      content.each do |step|
        case step
        when Raise then cause(step.event)
        when Act then @acts |= @actions.bit(step.name)
        when Send then start_timer(step)
        when Cancel then @armed &= ~@timers.bit(step.timer.id)
        when Assign then assign(step)
        end
      end
    end

    def start_timer(step)
      bit = @timers.bit(step.timer.id)
      @faults << Fault.new(33, step, "timer \"#{step.timer.id}\" is started while it runs") if @armed.anybits?(bit)
      @armed |= bit
      @started |= bit
    end

    def assign(step)
      variable = step.variable
      found = value(step.expression)
      outside = variable.kind == :integer && !found.between?(variable.minimum, variable.maximum)
      @faults << Fault.new(34, step, "\"#{variable.name}\" becomes #{found}") if outside
      @data = @data.merge(variable.name => found)
    end

    def value(expression)
      Expression.value(expression) do |kind, name|
        kind == :in ? @configuration.anybits?(@tree.bit(name)) : variable(name)
      end
    end

    def variable(name)
      @data.fetch(name) do
        @reads |= @inputs_read.bit(name)
        @inputs.fetch(name)
      end
    end
  end
end
