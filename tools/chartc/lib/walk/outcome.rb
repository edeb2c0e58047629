# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

module Chart
  # A chart between two macrosteps. leaves and armed: ids in document order; history: { history id => [state ids] }
  # as recorded (shallow: children, deep: leaves); data: { name => value } of the chart's own variables.
  Snapshot = Struct.new(:leaves, :history, :data, :armed)

  # What one stimulus did.
  #   after       Snapshot
  #   events      the stimulus: the event taken in, or those of the timers that did expire
  #   raised      internal events in the order raised, done.state.* included
  #   taken       Transitions in order; actions: names in document order, unique
  #   started     ids of the timers (re)started and still armed
  #   microsteps  the most of one macrostep (timers that expire together have several)
  #   rounds      the most of one macrostep after its first step: eventless steps and raised events taken up
  #   queued      the most events that one macrostep raised
  #   reads       names of the inputs that a guard has read: the others made no difference
  #   faults      Faults on the way
  Outcome = Struct.new(:after, :events, :raised, :taken, :actions, :started, :microsteps, :rounds, :queued, :reads,
                       :faults, keyword_init: true)

  # A broken rule that only running shows; the content that broke it, and what happened, in words.
  Fault = Struct.new(:rule, :content, :words)

  # A macrostep that goes on and on; with the transitions that take turns.
  class Endless < StandardError
    attr_reader :cycle

    def initialize(cycle)
      @cycle = cycle
      super("#{cycle.map(&:words).join(', ')} lead back to where they began")
    end
  end
end
