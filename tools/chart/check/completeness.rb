# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../refusal'
require_relative 'counterexample'

module Chart
  # Every event from outside, and every timer that expires, in every reached snapshot and with every valuation: a
  # transition takes it, or an active state declares to ignore it.
  class Completeness
    def initialize(document, walk)
      @document = document
      @walk = walk
      @needed = {}
    end

    def check
      @walk.reachable_pairs.each { |pair| check_pair(pair) }
      check_needed
    end

    private

    def check_pair(pair)
      idle = pair.outcomes.index { |outcome| outcome.taken.empty? }
      return unless idle

      event = event_of(pair.stimulus)
      return unless event

      ignoring = ignoring(pair.before.leaves, event)
      refuse_open(pair, idle, event) if ignoring.empty?
      ignoring.each { |state| @needed[[state.id, event]] = true }
    end

    # Those that made the difference.
    def inputs(pair, index)
      @walk.valuations[index].slice(*pair.outcomes[index].reads)
    end

    # Expiries together add nothing to those one by one.
    def event_of(stimulus)
      kind, what = stimulus
      return what if kind == :event

      @document.timers.find { |timer| timer.id == what.first }.event if what.length == 1
    end

    # Active states that ignore the event and do not lie in one that does.
    def ignoring(leaves, event)
      states = @walk.active(leaves).map { |id| @document.state(id) }.select { |state| state.ignores.include?(event) }
      states.reject { |state| states.any? { |other| state.inside?(other) } }
    end

    def refuse_open(pair, index, event)
      leaves = pair.before.leaves
      set = inputs(pair, index).map { |name, value| value ? name : "!#{name}" }
      where = [leaves.join(' '), *(set.join(' ') unless set.empty?)].join(' with ')
      raise Refusal.new(@document.file, @document.state(leaves.first).line, 25,
                        "\"#{event}\" does nothing in #{where}, reached by: #{@walk.path_to(pair.before)}; " \
                        "add a transition, or bs:ignores=\"#{event}\"", counterexample: example(pair, index, event))
    end

    def example(pair, index, event)
      state = @document.state(pair.before.leaves.first)
      steps = @walk.steps_to(pair.before) + [[pair.stimulus, @walk.valuations[index]]]
      claim = Counterexample::Claim.new(id: "#{state.id}-#{event}", req: state.req, line: state.line, at: :taken,
                                        says: "a transition takes \"#{event}\" in #{pair.before.leaves.join(' ')}.")
      Counterexample.new(@document, @walk, claim, steps)
    end

    def check_needed
      @document.states.each do |state|
        event = state.ignores.find { |one| !@needed.key?([state.id, one]) }
        next unless event

        raise Refusal.new(@document.file, state.line, 26, "\"#{event}\" always does something in \"#{state.id}\", or " \
                                                          'a state around it ignores it; remove it there')
      end
    end
  end
end
