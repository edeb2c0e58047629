# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../flatten/regions'
require_relative '../read/expression'
require_relative '../refusal'
require_relative '../walk/walk'
require_relative 'causes'

module Chart
  # The rules that need the whole chart, but no walk. Some bind product charts only: conformance charts may name events
  # that nobody causes, and the walk itself finds where they do not end.
  class StaticChecks
    MOST = { 'actions' => 32, 'timers' => 32, 'inputs' => 7, 'regions' => 64 }.freeze

    # owners: the requirement of each limit; without them rule 39 is not asked.
    def self.run(document, owners = nil)
      new(document, owners).run
    end

    def initialize(document, owners)
      @document = document
      @owners = owners
    end

    def run
      check_sizes
      check_targets
      check_histories
      check_eventless_guards
      check_safe
      check_product if @document.mode == :product
      check_inputs_read
    end

    private

    def refuse(line, rule, message)
      raise Refusal.new(@document.file, line, rule, message)
    end

    def check_product
      check_events
      check_ignores
      check_timers
      Causes.new(@document).check
      refuse(@document.root.line, 7, 'nothing happens here; add a transition with an event') if @document.events.empty?
    end

    # Several targets are all entered, so no two of them may exclude or contain each other.
    def check_targets
      @document.transitions.each { |transition| check_apart(transition.targets, transition.line) }
      [@document.root, *@document.states].filter_map(&:initial).each { |one| check_apart(one.targets, one.line) }
    end

    def check_apart(targets, line)
      targets.combination(2) do |first, second|
        next if apart?(first, second)

        refuse(line, 28, "\"#{first.id}\" and \"#{second.id}\" cannot be active together, or one holds the other; " \
                         'write targets in different regions of a parallel')
      end
    end

    # The innermost state that holds both is a parallel.
    def apart?(first, second)
      return false if first == second || first.inside?(second) || second.inside?(first)

      first.ancestors.find { |state| second.inside?(state) }.parallel?
    end

    def check_histories
      @document.transitions.each do |transition|
        history = transition.targets.find { |target| target.history? && transition.source.inside?(target.parent) }
        next unless history

        refuse(transition.line, 30, "#{transition.words} starts inside \"#{history.parent.id}\", whose history " \
                                    "\"#{history.id}\" it goes to; name a state as target")
      end
    end

    def check_eventless_guards
      @document.transitions.select { |one| one.eventless? && one.guard }.each do |transition|
        input = @document.inputs.map(&:name).find { |name| reads?(transition.guard, name) }
        next unless input

        refuse(transition.line, 27, "#{transition.words} has no event and reads \"#{input}\", which may change at any " \
                                    "time; add event=\"...\"")
      end
    end

    def reads?(expression, name)
      Expression.atoms(expression).include?([:variable, name])
    end

    def check_safe
      lacking = lacking_safe(@document.root)
      return unless lacking

      leaves = lacking.leaves.map(&:id).join(', ')
      refuse(@document.root.line, 18, "bs:safe is no configuration; of \"#{lacking.id || @document.name}\" " \
                                      "write one of: #{leaves}")
    end

    # The outermost state of which bs:safe names no child, or several.
    def lacking_safe(state)
      return state.substates.filter_map { |child| lacking_safe(child) }.first if state.parallel?
      return (state unless @document.safe.include?(state)) if state.leaf?

      named = state.substates.select { |child| (child.leaves & @document.safe).any? }
      named.length == 1 ? lacking_safe(named.first) : state
    end

    def check_sizes
      found = { 'actions' => @document.actions, 'timers' => @document.timers, 'inputs' => @document.inputs,
                'regions' => Regions.of(@document) }
      found.each do |what, all|
        next if all.length <= MOST.fetch(what)

        refuse(@document.root.line, 19, "the chart has #{all.length} #{what}; at most #{MOST.fetch(what)} fit, " \
                                        'split the chart')
      end
      check_configurations
    end

    # What the tree allows is counted before anything is walked.
    # @satisfies SWR-CHART-017
    def check_configurations
      count = Legal.count(@document.root)
      return if count <= Walk::MOST_SNAPSHOTS

      refuse(@document.root.line, 19, "the regions allow #{count} configurations; at most #{Walk::MOST_SNAPSHOTS} " \
                                      'fit, split the chart')
    end

    def check_inputs_read
      guards = @document.transitions.filter_map(&:guard)
      unread = @document.inputs.find { |input| guards.none? { |guard| reads?(guard, input.name) } }
      return unless unread

      refuse(unread.line, 24, "no guard reads \"#{unread.name}\"; remove the <data>, or use it")
    end

    def check_events
      heard = @document.transitions.flat_map(&:events).uniq
      @document.contents.grep(Raise).each { |one| check_heard(one.event, one.line, heard) }
      @document.timers.each { |one| check_heard(one.event, one.line, heard) }
      stray = @document.transitions.find { |one| (one.events - @document.internal_events).grep(Profile::DONE).any? }
      return unless stray

      refuse(stray.line, 7, "nothing causes \"#{stray.events.first}\"; name a state that ends in <final>, in all of " \
                            'its regions if it has some')
    end

    def check_heard(event, line, heard)
      return if heard.include?(event)

      refuse(line, 7, "nothing waits for \"#{event}\"; write one of: #{heard.join(', ')}")
    end

    def check_ignores
      @document.states.each do |state|
        stray = (state.ignores - @document.events).first
        next unless stray

        refuse(state.line, 7, "bs:ignores names \"#{stray}\", which is no event; " \
                              "write one of: #{@document.events.join(', ')}")
      end
    end

    def check_timers
      @document.states.each do |state|
        sent = state.entry.grep(Send)
        cancelled = state.exit.grep(Cancel)
        sent.each { |one| check_cancelled(state, one, cancelled) }
        sent.each { |one| check_owner(state, one) } if @owners
        cancelled.each { |one| check_sent(state, one, sent) }
      end
    end

    def check_cancelled(state, one, cancelled)
      return if cancelled.any? { |cancel| cancel.timer == one.timer }

      refuse(one.line, 12, "timer \"#{one.timer.id}\" outlives state \"#{state.id}\"; add " \
                           "<onexit><cancel sendid=\"#{one.timer.id}\"/></onexit> to the state")
    end

    # A limit that happens to have a value is not the one that somebody asked for.
    # @satisfies SWR-CHART-031
    def check_owner(state, one)
      owner = @owners.fetch(one.timer.limit)
      return if state.req.include?(owner)

      refuse(one.line, 39, "#{one.timer.limit} is a limit of #{owner}, which \"#{state.id}\" does not name; " \
                           "write the limit of its requirement, or add bs:req=\"#{owner}\"")
    end

    def check_sent(state, one, sent)
      return if sent.any? { |send| send.timer == one.timer }

      refuse(one.line, 12, "state \"#{state.id}\" does not start timer \"#{one.timer.id}\"; cancel it where it is sent")
    end
  end
end
