# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../refusal'
require_relative 'legal'
require_relative 'probe'

module Chart
  # Every reachable snapshot, breadth first, with every stimulus and every valuation of the inputs. Legal
  # configurations that are never reached are stepped too, so that the compiled code is compared on them as well; they
  # count for nothing else.
  # @satisfies SWR-CHART-002
  class Walk
    MOST_SNAPSHOTS = 200_000
    MOST_TOGETHER = 4
    MOST_WORDS = 24
    REMEDIES = { 11 => 'guard one of them', 33 => 'cancel it before', 34 => 'guard the assignment' }.freeze

    # stimulus is [:event, name] or [:expire, timer ids]; outcomes hold one entry per valuation.
    Pair = Struct.new(:before, :stimulus, :outcomes, :reachable, keyword_init: true)

    # valuations: hashes input name => boolean; bit n of the index is input n. reached: { snapshot => [snapshot before,
    # stimulus, inputs], or nil for the start }, in the order found. probe: what the reachable steps came across.
    # overlapping: the shortest list of steps, as of #steps_to, whose last one meets the first overlap of the probe.
    attr_reader :pairs, :start, :reached, :valuations, :probe, :overlapping

    def initialize(document, most_snapshots = MOST_SNAPSHOTS)
      @document = document
      @most_snapshots = most_snapshots
      @probe = Probe.new(document)
      @inputs = Bits.new(document.inputs.map(&:name))
      @valuations = (0...(1 << document.inputs.length)).map { |bits| valuation(bits) }
      @events = (document.events - document.internal_events).map { |event| [:event, event].freeze }
      @stimuli = {}
    end

    def run
      @pairs = []
      @start = checked([]) { @probe.start }
      @reached = { @start.after => nil }
      explore
      step_unreached
      self
    end

    def reachable_pairs
      @reachable_pairs ||= @pairs.select(&:reachable)
    end

    # Without the repetitions for inputs that made no difference.
    def reachable_outcomes
      [@start] + reachable_pairs.flat_map { |pair| pair.outcomes.uniq(&:object_id) }
    end

    # Stimuli with valuations: what the printed number of pairs counts.
    def pair_count
      reachable_pairs.length * @valuations.length
    end

    # The shortest list of [stimulus, inputs] that leads to a snapshot.
    def steps_to(snapshot)
      steps = []
      while (found = @reached[snapshot])
        snapshot, stimulus, inputs = found
        steps.unshift([stimulus, inputs])
      end
      steps
    end

    def path_to(snapshot)
      words(steps_to(snapshot))
    end

    def words(steps)
      return 'at the start' if steps.empty?

      shortened(steps.map { |stimulus, inputs| step_words(stimulus, inputs) }).join(', ')
    end

    def active(leaves)
      @probe.active(leaves)
    end

    # Bounds for one macrostep, over everything stepped.
    def most_microsteps
      all_outcomes.map(&:microsteps).max
    end

    def most_rounds
      all_outcomes.map(&:rounds).max
    end

    def most_raised
      all_outcomes.map(&:queued).max
    end

    private

    def all_outcomes
      @all_outcomes ||= [@start] + @pairs.flat_map { |pair| pair.outcomes.uniq(&:object_id) }
    end

    def valuation(bits)
      @document.inputs.each_with_index.to_h { |input, index| [input.name, bits[index] == 1] }.freeze
    end

    def explore
      queue = [@start.after]
      while (before = queue.shift)
        stimuli(before.armed).each do |stimulus|
          pair = step(before, stimulus, true) do |inputs|
            checked([before, stimulus, inputs]) { apply(@probe, before, stimulus, inputs) }
          end
          queue.concat(new_snapshots(pair))
        end
      end
    end

    # The probe must not see these. What never ends there is no chart's fault.
    def step_unreached
      interpreter = Interpreter.new(@document)
      (Legal.snapshots(@document) - @reached.keys).select { |one| interpreter.stable?(one) }.each do |before|
        stimuli(before.armed).each do |stimulus|
          step(before, stimulus, false) { |inputs| apply(interpreter, before, stimulus, inputs) }
        rescue Endless
          next
        end
      end
    end

    # Above four timers only one or two expire together: all subsets would be too many.
    def stimuli(armed)
      @stimuli[armed] ||= begin
        most = armed.length > MOST_TOGETHER ? 2 : armed.length
        @events + (1..most).flat_map { |count| armed.combination(count).map { |timers| [:expire, timers] } }
      end
    end

    def step(before, stimulus, reachable, &run)
      @pairs << Pair.new(before: before, stimulus: stimulus, outcomes: outcomes(&run), reachable: reachable)
      @pairs.last
    end

    # One run serves all valuations that agree in the inputs that it has read.
    def outcomes
      first = yield @valuations.first
      return Array.new(@valuations.length, first) if first.reads.empty?

      known = [[@inputs.set(first.reads), 0, first]]
      @valuations.each_with_index.map do |inputs, index|
        alike = known.find { |read, values, _outcome| index & read == values }
        next alike.last if alike

        outcome = yield inputs
        read = @inputs.set(outcome.reads)
        known << [read, index & read, outcome]
        outcome
      end
    end

    def apply(interpreter, before, stimulus, inputs)
      kind, what = stimulus
      kind == :event ? interpreter.dispatch(before, what, inputs) : interpreter.expire(before, what, inputs)
    end

    def new_snapshots(pair)
      pair.outcomes.each_with_index.filter_map do |outcome, index|
        next if outcome.after.equal?(pair.before) || @reached.key?(outcome.after)

        @reached[outcome.after] = [pair.before, pair.stimulus, @valuations[index]]
        refuse_size if @reached.length > @most_snapshots
        outcome.after
      end
    end

    # The outcome of the block, which takes the step [snapshot before, stimulus, inputs] ([] for the start).
    def checked(step)
      outcome = yield
      fault = outcome.faults.first
      refuse(fault.content.line, fault.rule, fault.words, step) if fault
      @overlapping ||= steps_by(step) if @probe.overlaps.any?
      outcome
    rescue Endless => e
      refuse(e.cycle.first.line, 11, e.message, step)
    end

    def refuse(line, rule, what, step)
      raise Refusal.new(@document.file, line, rule,
                        "#{what}, reached by: #{words(steps_by(step))}; #{REMEDIES.fetch(rule)}")
    end

    def steps_by(step)
      before, stimulus, inputs = step
      before ? steps_to(before) + [[stimulus, inputs]] : []
    end

    def refuse_size
      raise Refusal.new(@document.file, @document.root.line, 19, "more than #{@most_snapshots} configurations are " \
                                                                 'reached; bound the data, or split the chart')
    end

    # Repetitions are counted; of what is still long, the beginning and the end are reported.
    def shortened(words)
      runs = words.chunk_while { |one, other| one == other }.flat_map do |run|
        run.length > 2 ? ["#{run.first} (#{run.length} times)"] : run
      end
      return runs if runs.length <= MOST_WORDS

      half = MOST_WORDS / 2
      [*runs.first(half), "(#{runs.length - (2 * half)} more)", *runs.last(half)]
    end

    def step_words(stimulus, inputs)
      kind, what = stimulus
      set = inputs.select { |_name, value| value }.keys
      words = kind == :event ? what : "#{what.join(' and ')} #{what.length == 1 ? 'expires' : 'expire'}"
      set.empty? ? words : "#{words} with #{set.join(' and ')}"
    end
  end
end
