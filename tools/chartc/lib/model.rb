# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

module Chart
  # The parsed chart: a tree of states, every name resolved. The interpreter and the emitters share this and
  # nothing else.
  #
  # kind: :root, :compound, :parallel, :atomic, :final or :history; depth (:shallow, :deep) is for a history.
  # children stand in document order, histories among them. initial is a Default for :root, :compound and
  # :history. entry and exit are lists of content (below), all <onentry> or <onexit> blocks joined.
  # ignores: the events that this state declares to ignore. req and hazards: ids of requirements and hazards.
  State = Struct.new(:id, :kind, :depth, :parent, :children, :initial, :transitions, :entry, :exit, :req,
                     :hazards, :ignores, :line, :order, :comment, keyword_init: true) do
    # Ancestors, innermost first, without the state itself; the last one is the root.
    def ancestors
      @ancestors ||= (parent ? [parent] + parent.ancestors : []).freeze
    end

    # Asked most of all.
    def inside?(other)
      state = parent
      state = state.parent until state.nil? || state.equal?(other)
      !state.nil?
    end

    def root?
      kind == :root
    end

    def parallel?
      kind == :parallel
    end

    def history?
      kind == :history
    end

    # A state without states: what a configuration is named by.
    def leaf?
      kind == :atomic || kind == :final
    end

    # Compound as transition domains count it: the root is one, a parallel is none.
    def compound?
      kind == :compound || kind == :root
    end

    # Children that can be active.
    def substates
      children.reject(&:history?)
    end

    def histories
      children.select(&:history?)
    end

    def leaves
      leaf? ? [self] : substates.flat_map(&:leaves)
    end

    def inspect
      "#<State #{id}>"
    end

    def hash
      @hash ||= id.hash
    end

    def eql?(other)
      equal?(other)
    end

    def ==(other)
      equal?(other)
    end
  end

  # Where a compound state, the chart or a history without record begins: targets in file order.
  Default = Struct.new(:targets, :content, :line, keyword_init: true)

  # events: concrete event names (prefixes and wildcards are resolved), [] for an eventless transition.
  # targets: [] for a targetless one. number counts from 1 in document order. content: see below.
  # words: what the file calls it, for messages; engine charts need give no id.
  Transition = Struct.new(:id, :number, :source, :events, :guard, :guard_text, :targets, :internal, :content,
                          :req, :hazards, :line, :words, keyword_init: true) do
    def eventless?
      events.empty?
    end

    def targetless?
      targets.empty?
    end

    # A state is left and entered, if only its own.
    def moves?
      !targetless?
    end

    # The names of bs:do, in file order.
    def actions
      content.grep(Act).map(&:name)
    end

    def raises
      content.grep(Raise).map(&:event)
    end

    def inspect
      "#<Transition #{id}>"
    end
  end

  # Content, in the order of execution. Send starts its timer anew, Cancel stops it.
  Raise = Struct.new(:event, :line)
  Send = Struct.new(:timer, :line)
  Cancel = Struct.new(:timer, :line)
  Assign = Struct.new(:variable, :expression, :line)
  Act = Struct.new(:name, :line)

  # One <send> with a constant delay. rounding: :down for a watchdog, :up for a hold-off; threshold_us is the delay
  # rounded so to whole ticks.
  Timer = Struct.new(:id, :event, :delay_us, :limit, :rounding, :threshold_us, :line, keyword_init: true)

  # kind :input is a boolean that the caller hands in; :boolean and :integer belong to the chart.
  Variable = Struct.new(:name, :kind, :initial, :minimum, :maximum, :comment, :line, keyword_init: true)

  # What a complete walk decides.
  #   :always     expression holds in every reached configuration              (bs:invariant)
  #   :response   after a step by one of `events`, from `from` if given, expression holds, exactly the actions `does`
  #               were done unless nil, the timers `starts` were started, and if it `stays` no state was left or
  #               entered                                                            (bs:response)
  #   :only       a step from `from` to `expression` is by one of `events`       (bs:only)
  #   :reachable  from every configuration with `from` (or every one) a configuration with expression is
  #               reached in at most `steps` steps, or in any number if nil       (bs:reachable)
  #   :start      expression holds where the chart starts, and exactly the actions `does` were done on the way there
  #               unless nil                                                     (bs:start)
  #   :damaged    expression, of states only, holds in the safe configuration    (bs:damaged)
  # The expressions read states and the chart's data; `from` of a step its inputs as well. text is the property in one
  # line.
  Property = Struct.new(:id, :kind, :req, :hazards, :events, :from, :expression, :does, :starts, :stays, :steps, :text,
                        :line, keyword_init: true)

  # One chart file. states: all but the root, histories included, in document order. events: the alphabet in order of
  # first appearance. internal_events: those that only the chart itself may cause (raised ones named in bs:internal,
  # events of timers, done.state.*). entering: those of bs:enters. safe: one leaf per region. mode: that of
  # the parser.
  Document = Struct.new(:name, :file, :comment, :root, :states, :transitions, :timers, :variables, :properties,
                        :safe, :events, :internal_events, :entering, :tick_us, :mode, keyword_init: true) do
    def state(id)
      (@by_id ||= states.to_h { |state| [state.id, state] })[id]
    end

    def leaves
      states.select(&:leaf?)
    end

    def histories
      states.select(&:history?)
    end

    def inputs
      variables.select { |variable| variable.kind == :input }
    end

    # The chart's own variables.
    def data
      variables - inputs
    end

    def invariants
      properties.select { |property| property.kind == :always }
    end

    def actions
      contents.grep(Act).map(&:name).uniq
    end

    # Every piece of content, in document order of its owner.
    def contents
      owners = states.sort_by(&:order)
      defaults = [root, *owners].filter_map(&:initial).flat_map(&:content)
      owners.flat_map { |state| state.entry + state.exit } + transitions.flat_map(&:content) + defaults
    end

    def inspect
      "#<Document #{name}>"
    end
  end
end
