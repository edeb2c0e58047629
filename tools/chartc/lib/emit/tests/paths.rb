# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'set'
require_relative '../../read/expression'
require_relative '../../walk/interpreter'

module Chart
  # The shortest list of steps from the start to each goal that a chart can be driven to from outside:
  #   [:guard, number, values]  the transition is asked with these values of what its guard reads, and is taken exactly
  #                             if the guard holds; without a guard there is one goal: it is taken
  #   [:pair, first, second]    the second transition is taken in the step after that of the first, or directly after it
  #                             in the same step
  # A step is an event, or the time until timers expire; timers that only waiting in between could part do not part.
  # @satisfies SWR-CHART-009
  class Paths
    # Each is made once: to look one up, what it holds need not be compared.
    module Once
      def hash
        object_id.hash
      end

      def eql?(other)
        equal?(other)
      end
    end

    Step = Struct.new(:stimulus, :inputs, :elapsed_us, :outcome) do
      include Once
    end

    # What a stimulus does in a snapshot, for all inputs that agree in what it reads: the goals that it reaches whatever
    # was before, and the snapshot after it.
    Run = Struct.new(:inputs, :outcome, :goals, :after) do
      include Once
    end

    # Where a path has come to; elapsed_us: { id of a running timer => its time }, taken: by the last step that took
    # transitions. previous and step: how the path came here.
    Place = Struct.new(:snapshot, :elapsed_us, :taken, :previous, :step) do
      include Once

      def steps
        previous ? previous.steps << step : []
      end

      def key
        [snapshot.object_id, elapsed_us, taken.map(&:number)]
      end
    end

    # An interpreter that notes which transitions it asks, with what they read, and what they answer. Those of the same
    # state that come after the selected one are asked as well: that guards exclude each other is two-sided.
    class Asking < Interpreter
      attr_reader :asked

      def listen
        @asked = []
        yield
      end

      private

      def first_enabled(candidates)
        found = super
        later = found ? candidates.drop(candidates.index(found) + 1) : []
        later.each { |transition| enabled?(transition) if transition.source == found.source }
        found
      end

      def enabled?(transition)
        values = transition.guard ? Expression.atoms(transition.guard).map { |atom| value(atom) } : []
        super.tap { |answer| @asked << [transition, values, answer] }
      end
    end

    # { goal => [Place, last Step] }, the nearest ones first.
    attr_reader :found

    def initialize(document, walk)
      @document = document
      @walk = walk
      @interpreter = Asking.new(document)
      @snapshots = walk.reached.keys.to_h { |snapshot| [snapshot, snapshot] }
      @stimuli = walk.reachable_pairs.group_by { |pair| one(pair.before) }.compare_by_identity
      @runs = {}.compare_by_identity
      @found = {}
      search
    end

    private

    # The same object for the same snapshot, so that places compare by it.
    def one(snapshot)
      @snapshots[snapshot] ||= snapshot
    end

    def search
      start = @walk.start
      places = [Place.new(one(start.after), start.after.armed.to_h { |id| [id, 0] }, start.taken)]
      known = Set[places.first.key]
      places.each do |place|
        steps(place).each do |step, run|
          (run.goals + pairs(place.taken, run.outcome.taken)).each { |goal| @found[goal] ||= [place, step] }
          after = arrive(place, step, run)
          places << after if known.add?(after.key)
        end
      end
    end

    def pairs(before, taken)
      before.product(taken).map { |first, second| [:pair, first.number, second.number] }
    end

    # [[Step, Run]]
    def steps(place)
      @stimuli.fetch(place.snapshot, []).flat_map do |pair|
        elapsed_us = time_to(place, pair.stimulus)
        next [] unless elapsed_us

        runs(pair).map { |run| [Step.new(pair.stimulus, run.inputs, elapsed_us, run.outcome), run] }
      end
    end

    # 0 for an event; nil when these timers cannot expire together and without the others.
    def time_to(place, stimulus)
      kind, timers = stimulus
      return 0 if kind == :event

      left = @document.timers.select { |timer| place.elapsed_us.key?(timer.id) }
                      .to_h { |timer| [timer.id, timer.threshold_us - place.elapsed_us[timer.id]] }
      time = left.values_at(*timers).max
      time if left.all? { |id, rest| timers.include?(id) == (rest <= time) }
    end

    def runs(pair)
      @runs[pair] ||= @walk.valuations.each_with_object([]) do |inputs, runs|
        next if runs.any? { |other| other.outcome.reads.all? { |name| inputs[name] == other.inputs[name] } }

        outcome = @interpreter.listen { run(pair.before, pair.stimulus, inputs) }
        runs << Run.new(inputs, outcome, goals(outcome.taken, @interpreter.asked), one(outcome.after))
      end
    end

    def goals(taken, asked)
      guards = asked.select { |transition, _values, answer| answer == taken.include?(transition) }
      guards.map { |transition, values, _answer| [:guard, transition.number, values] } +
        taken.each_cons(2).map { |first, second| [:pair, first.number, second.number] }
    end

    def run(snapshot, stimulus, inputs)
      kind, what = stimulus
      kind == :event ? @interpreter.dispatch(snapshot, what, inputs) : @interpreter.expire(snapshot, what, inputs)
    end

    def arrive(place, step, run)
      outcome = step.outcome
      elapsed_us = outcome.after.armed.to_h do |id|
        [id, outcome.started.include?(id) ? 0 : place.elapsed_us.fetch(id) + step.elapsed_us]
      end
      Place.new(run.after, elapsed_us, outcome.taken.empty? ? place.taken : outcome.taken, place, step)
    end
  end
end
