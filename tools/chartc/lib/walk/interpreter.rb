# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../model'
require_relative 'entries'
require_relative 'execution'
require_relative 'outcome'
require_relative 'tree'

module Chart
  # SCXML's own algorithm (W3C SCXML 1.0, appendix D) on the tree of states. It shares nothing with the C emitter but
  # the parsed chart. A chart that has entered a final state of its own keeps its configuration and takes nothing.
  # @satisfies SWR-CHART-001
  # @satisfies SWR-CHART-037
  class Interpreter
    include Execution

    MOST_MICROSTEPS = 1000
    NONE = [].freeze

    # Who waits for an event: a set of leaves, and for each of them the transitions to ask, those of inner states first.
    Waiting = Struct.new(:leaves, :candidates)
    private_constant :Waiting

    def initialize(document)
      @document = document
      @tree = Tree.new(document)
      @entries = Entries.new(document)
      @timers = Bits.new(document.timers.map(&:id))
      @actions = Bits.new(document.actions)
      @inputs_read = Bits.new(document.inputs.map(&:name))
      @waiting = waiting
      @remembers = document.histories.any?
    end

    # Enters the chart; guards that read inputs on the way see false.
    def start
      resume(initial)
      begin_macrostep(@document.inputs.to_h { |input| [input.name, false] })
      enter(@entries.at_start)
      settle
      outcome(NONE)
    end

    # One macrostep for an event from outside. Internal events are not for the outside.
    def dispatch(snapshot, event, inputs)
      return idle(snapshot, NONE) if @document.internal_events.include?(event)

      resume(snapshot)
      return idle(snapshot, [event]) if @configuration.nobits?(@waiting[event].leaves | @waiting[nil].leaves)

      macrostep(event, inputs)
      outcome([event])
    end

    # The timers expire in one call, in document order, each to the end of its macrostep; one that an earlier expiry
    # cancelled or started again does not expire.
    def expire(snapshot, timer_ids, inputs)
      resume(snapshot)
      expired = @document.timers.select do |timer|
        bit = @timers.bit(timer.id)
        next if !timer_ids.include?(timer.id) || @armed.nobits?(bit) || @started.anybits?(bit)

        @armed &= ~bit
        macrostep(timer.event, inputs)
        true
      end
      outcome(expired.map(&:event))
    end

    # No eventless transition is enabled: a chart rests only in stable snapshots.
    def stable?(snapshot)
      resume(snapshot)
      select(nil).empty?
    end

    # Ids of all active states, in document order.
    def active(leaves)
      @tree.ids(@tree.configuration(leaves))
    end

    private

    # event (nil: none) => Waiting
    def waiting
      found = Hash.new { |events, event| events[event] = Waiting.new(0, Hash.new { |leaves, id| leaves[id] = [] }) }
      @document.leaves.each do |leaf|
        [leaf, *leaf.ancestors].flat_map(&:transitions).each do |transition|
          (transition.eventless? ? [nil] : transition.events).each do |event|
            found[event].leaves |= @tree.bit(leaf.id)
            found[event].candidates[leaf.id] << transition
          end
        end
      end
      found.default = Waiting.new(0, {})
      found
    end

    def initial
      Snapshot.new([], {}, @document.data.to_h { |variable| [variable.name, variable.initial] }, [])
    end

    def resume(snapshot)
      @before_configuration = @tree.configuration(snapshot.leaves) unless snapshot.equal?(@before)
      @before = snapshot
      @configuration = @before_configuration
      @history = snapshot.history
      @data = snapshot.data
      @armed = @timers.set(snapshot.armed)
      @started = @acts = @reads = @microsteps = @rounds = @queued = 0
      @taken = []
      @raised = []
      @faults = []
    end

    def outcome(events)
      Outcome.new(after: snapshot, events: events, raised: @raised, taken: @taken, actions: @actions.names(@acts),
                  started: @timers.names(@started & @armed), microsteps: @microsteps, rounds: @rounds,
                  queued: @queued, reads: @inputs_read.names(@reads), faults: @faults)
    end

    def snapshot
      found = Snapshot.new(@tree.leaves(@configuration), @history.freeze, @data.freeze, @timers.names(@armed)).freeze
      found == @before ? @before : found
    end

    def idle(snapshot, events)
      Outcome.new(after: snapshot, events: events, raised: NONE, taken: NONE, actions: NONE, started: NONE,
                  microsteps: 0, rounds: 0, queued: 0, reads: NONE, faults: NONE)
    end

    def begin_macrostep(inputs)
      @inputs = inputs
      @queue = []
      @raised_before = @raised.length
      @steps = 0
    end

    def macrostep(event, inputs)
      begin_macrostep(inputs)
      enabled = select(event)
      microstep(enabled) unless enabled.empty?
      settle
    end

    # Eventless transitions first, then internal events in the order raised, until neither is left.
    def settle
      rounds = 0
      until (enabled = select(nil)).empty? && @queue.empty?
        rounds += 1
        enabled = select(@queue.shift) if enabled.empty?
        next if enabled.empty?

        require_end
        microstep(enabled)
      end
      @microsteps = [@microsteps, @steps].max
      @rounds = [@rounds, rounds].max
      @queued = [@queued, @raised.length - @raised_before].max
    end

    def require_end
      return if @steps < MOST_MICROSTEPS

      raise Endless, @taken.last(MOST_MICROSTEPS / 2).uniq(&:number)
    end

    # selectTransitions, selectEventlessTransitions
    def select(event)
      waiting = @waiting[event]
      asked = @configuration & waiting.leaves
      return NONE if asked.zero?

      enabled = @tree.ids(asked).filter_map { |id| first_enabled(waiting.candidates[id]) }.uniq(&:number)
      enabled.length > 1 ? without_conflicts(enabled) : enabled
    end

    def first_enabled(candidates)
      candidates.find { |transition| enabled?(transition) }
    end

    def enabled?(transition)
      transition.guard.nil? || value(transition.guard)
    end

    # removeConflictingTransitions
    def without_conflicts(enabled)
      enabled.each_with_object([]) do |transition, kept|
        left = exit_set([transition])
        rivals = kept.select { |other| left.anybits?(exit_set([other])) }
        next unless rivals.all? { |other| transition.source.inside?(other.source) }

        rivals.each { |other| kept.delete_if { |one| one.equal?(other) } }
        kept << transition
      end
    end

    # computeExitSet
    def exit_set(transitions)
      transitions.reduce(0) do |set, transition|
        domain = @entries.domain(transition, @history)
        domain ? set | (@configuration & @tree.inside(domain)) : set
      end
    end

    def microstep(enabled)
      @steps += 1
      leave(@tree.states(exit_set(enabled)))
      enabled.each { |transition| execute(transition.content) }
      @taken.concat(enabled)
      enter(@entries.of(enabled, @history))
    end

    def leave(states)
      record(states.flat_map(&:histories)) if @remembers
      states.reverse_each do |state|
        execute(state.exit)
        @configuration &= ~@tree.bit(state.id)
      end
    end

    def record(histories)
      found = histories.to_h do |history|
        inside = @configuration & @tree.inside(history.parent)
        states = history.depth == :deep ? @tree.leaves(inside) : @tree.ids(inside & @tree.children(history.parent))
        [history.id, states]
      end
      @history = @history.merge(found)
    end

    def enter(entries)
      entries.each do |entry|
        @configuration |= @tree.bit(entry.state.id)
        execute(entry.content)
        finish(entry.state) if entry.state.kind == :final
      end
    end
  end
end
