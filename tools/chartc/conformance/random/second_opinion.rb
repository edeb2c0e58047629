# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../../lib/walk/interpreter'
require_relative '../interpreted'

module RandomCharts
  # The interpreter, and behind it SCION, which others wrote: each step is asked of both, and differences are noted.
  # What is not clear, by the list in proof/scion.rb, is not asked of SCION; nor are events that are internal to the
  # chart, which it takes from outside too.
  class SecondOpinion
    # agreed: number of steps that SCION takes too; unclear: reason => steps that were not asked of it.
    attr_reader :agreed, :unclear, :differences

    def initialize(document, session)
      @document = document
      @own = ::Chart::Interpreter.new(document)
      @scion = Conformance::ScionStepper.new(session, document)
      @across = document.transitions.select { |one| across?(one) }
      @ends = document.states.any? { |state| state.kind == :final }
      @agreed = 0
      @unclear = Hash.new(0)
      @differences = []
    end

    def start
      ask([], [], &:start)
    end

    def dispatch(snapshot, event, inputs)
      return @own.dispatch(snapshot, event, inputs) if @document.internal_events.include?(event)

      ask(snapshot.leaves, [event]) { |machine| machine.dispatch(snapshot, event, inputs) }
    end

    def expire(snapshot, timer_ids, inputs)
      return @own.expire(snapshot, timer_ids, inputs) if timer_ids.empty?

      events = @document.timers.select { |timer| timer_ids.include?(timer.id) }.map(&:event)
      ask(snapshot.leaves, events) { |machine| machine.expire(snapshot, timer_ids, inputs) }
    end

    private

    # What the interpreter answers.
    def ask(leaves, events)
      outcome = yield @own
      reason = unclear_by(leaves, events, outcome)
      return outcome.tap { @unclear[reason] += 1 } if reason

      compare([*leaves, *events].join(' '), *[outcome, yield(@scion)].map { |one| shown(one, leaves.empty?) })
      outcome
    end

    def compare(place, expected, found)
      return @agreed += 1 if found == expected

      @differences << "#{place}: SCION shows #{found}, not #{expected}"
    end

    # SCION reports neither the transitions of the start nor the actions of states, and has an order of its own for what
    # regions take together.
    def shown(outcome, is_start)
      after = outcome.after
      { taken: is_start ? [] : outcome.taken.map(&:number).sort, leaves: after.leaves.sort, data: after.data.sort,
        history: after.history.transform_values(&:sort).sort, armed: after.armed.sort, started: outcome.started.sort }
    end

    def unclear_by(leaves, events, outcome)
      states = (leaves + outcome.after.leaves).map { |id| @document.state(id) }
      return :end if states.any? { |state| state.kind == :final } || (@ends && outcome.taken.length != 1)

      :across if @across.any? && (outcome.taken.length > 1 || (outcome.taken & @across).any? || waits?(leaves, events))
    end

    # A transition between regions is asked, whether or not another one wins.
    def waits?(leaves, events)
      active = leaves.map { |id| @document.state(id) }.flat_map { |state| [state, *state.ancestors] }
      @across.any? { |one| active.include?(one.source) && (one.eventless? || (one.events & events).any?) }
    end

    # What holds source and targets is a parallel.
    def across?(transition)
      source = transition.source
      return false if transition.targetless?
      return false if transition.internal && source.compound? && transition.targets.all? { |one| one.inside?(source) }

      source.ancestors.find { |state| transition.targets.all? { |one| one.inside?(state) } }.parallel?
    end
  end

  # Charts by their seeds, each under its steps: what the interpreter does beside appendix D, and SCION beside it.
  class SecondOpinions
    FOLDER = File.expand_path('../../../../build/conformance/random/scion', __dir__)

    attr_reader :charts, :agreed, :differences

    def initialize
      @session = Scion::Session.new
      @charts = @agreed = 0
      @unclear = Hash.new(0)
      @differences = []
      FileUtils.mkdir_p(FOLDER)
    end

    def judge(seed)
      chart = Generator.new(seed).chart
      hear(trial(seed, chart.xml)) unless begins_in_history?(chart)
    rescue Chart::Refusal
      nil
    end

    def close
      @session.close
    end

    def to_s
      "second opinion: #{@charts} charts, #{@agreed} steps as SCION, " \
        "#{@unclear.map { |reason, count| "#{count} not asked (#{reason})" }.join(', ')}, #{@differences.length} differ"
    end

    private

    def trial(seed, text)
      file = File.join(FOLDER, "chart_#{seed}")
      File.write("#{file}.scxml", text)
      Trial.new(file, text) { |machine, inputs| Scenario.new(Random.new(seed), strays: false).steps(machine, inputs) }
    end

    def hear(trial)
      opinion = SecondOpinion.new(trial.document, @session)
      seen = Conformance::Interpreted.new(trial.document, opinion).run(trial.steps)
      @charts += 1
      @agreed += opinion.agreed
      @unclear.merge!(opinion.unclear) { |_reason, one, other| one + other }
      words = [*trial.difference_of(seen), *opinion.differences]
      @differences.concat(words.map { |one| "#{trial.document.file}: #{one}" })
    end

    # Where SCION begins a state that does not say in which of its states.
    def begins_in_history?(chart)
      chart.all.any? do |node|
        next if node.name == 'parallel' || node.attributes.key?('initial')

        first = node.children.find { |child| child.state? || %w[history initial].include?(child.name) }
        first&.name == 'history'
      end
    end
  end
end
