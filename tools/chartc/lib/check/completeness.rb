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
        raise Refusal.new(@document.file, state.line, 26, needless(state, event)) if event
      end
    end

    # An ignore may be all that is left of a guard: that it is wrong is no reason to take it away.
    # @satisfies SWR-CHART-032
    def needless(state, event)
      around = state.ancestors.any? { |one| one.ignores&.include?(event) }
      return "a state around \"#{state.id}\" ignores \"#{event}\" too; remove it in one of them" if around

      takers = takers(state, event)
      requirements = takers.flat_map(&:req).uniq.join(', ')
      "\"#{event}\" is always taken in \"#{state.id}\", by #{takers.map(&:id).join(', ')}; give what #{requirements} " \
        'asks for as a guard, or correct bs:ignores if it asks for none'
    end

    def takers(state, event)
      pairs = @walk.reachable_pairs.select do |pair|
        event_of(pair.stimulus) == event && @walk.active(pair.before.leaves).include?(state.id)
      end
      found = pairs.flat_map { |pair| pair.outcomes.flat_map(&:taken) }.uniq(&:number)
      found.select { |one| one.events.include?(event) }.sort_by(&:number)
    end
  end
end
