# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../read/expression'
require_relative '../refusal'
require_relative 'counterexample'

module Chart
  # The properties of a chart, decided on its walk.
  #   invariant  in every reached snapshot
  #   response   after every step by one of its events (the stimulus' own, or raised), from a snapshot and with inputs
  #              that have `from`: where it leads, what it does, which timers it starts, that it stays
  #   only       every step that takes a transition and leads from `from` to the expression is by one of its events
  #   reachable  from every snapshot with `from`; a snapshot that has the expression needs no step
  #   start      of the snapshot that the chart starts in, and of what is done on the way there
  #   damaged    of the safe configuration
  # A property that speaks of nothing that happens is refused as well: it would hold whatever the chart does.
  # @satisfies SWR-CHART-002
  # @satisfies SWR-CHART-033
  # @satisfies SWR-CHART-040
  class PropertyChecks
    RULES = { always: 23, response: 36, only: 37, reachable: 38, start: 40, damaged: 41 }.freeze
    Verdict = Struct.new(:property, :verdict, :checked, keyword_init: true)
    Step = Struct.new(:before, :stimulus, :inputs, :outcome)

    # For a chart that check has passed. checked: the number of snapshots or steps that the property speaks of.
    def self.verdicts(document, walk)
      properties = new(document, walk)
      document.properties.map do |property|
        Verdict.new(property: property, verdict: :holds, checked: properties.subjects(property).length)
      end
    end

    def initialize(document, walk)
      @document = document
      @walk = walk
    end

    def check
      @document.properties.each do |property|
        subjects = subjects(property)
        refuse_empty(property) if subjects.empty?
        violated = violation(property, subjects)
        refuse(property, violated) if violated
      end
    end

    # What the property speaks of: snapshots, or Steps, those of the shortest paths first.
    def subjects(property)
      case property.kind
      when :always then snapshots
      when :reachable then snapshots.select { |snapshot| from?(property, snapshot) }
      when :response then steps_from(property) { |outcome| named?(property, outcome) }
      when :only
        steps_from(property) { |outcome| outcome.taken.any? && true?(property.expression, outcome.after) }
      when :start then [@walk.start.after]
      when :damaged then [safe]
      end
    end

    private

    def snapshots
      @walk.reached.keys
    end

    # What a damaged chart goes to.
    def safe
      Snapshot.new(@document.safe.map(&:id), {}, {}, [])
    end

    def violation(property, subjects)
      case property.kind
      when :always, :damaged then subjects.find { |snapshot| !true?(property.expression, snapshot) }
      when :start then subjects.find { |snapshot| !true?(property.expression, snapshot) || !did?(property, @walk.start) }
      when :reachable then unreached(property, subjects)
      when :response then subjects.find { |step| !answered?(property, step) }
      when :only then subjects.find { |step| !named?(property, step.outcome) }
      end
    end

    def steps_from(property)
      different.flat_map do |pair, outcomes|
        spoken = outcomes.select { |outcome| yield outcome }
        next [] if spoken.empty?

        pair.outcomes.each_with_index.filter_map do |outcome, index|
          inputs = @walk.valuations[index]
          next unless spoken.any? { |one| one.equal?(outcome) } && from?(property, pair.before, inputs)

          Step.new(pair.before, pair.stimulus, inputs, outcome)
        end
      end
    end

    # Without the repetitions for inputs that made no difference.
    def different
      @different ||= @walk.reachable_pairs.map { |pair| [pair, pair.outcomes.uniq(&:object_id)] }
    end

    def from?(property, snapshot, inputs = {})
      property.from.nil? || true?(property.from, snapshot, inputs)
    end

    def answered?(property, step)
      outcome = step.outcome
      true?(property.expression, outcome.after) && did?(property, outcome) &&
        (property.starts.map(&:id) - outcome.started).empty? &&
        !(property.stays && outcome.taken.any?(&:moves?))
    end

    def did?(property, outcome)
      property.does.nil? || property.does.sort == outcome.actions.sort
    end

    def named?(property, outcome)
      property.events.any? { |event| outcome.events.include?(event) || outcome.raised.include?(event) }
    end

    def true?(expression, snapshot, inputs = {})
      active = active(snapshot.leaves)
      Expression.value(expression) do |kind, name|
        kind == :in ? active.include?(name) : inputs.fetch(name) { snapshot.data.fetch(name) }
      end
    end

    def active(leaves)
      (@active ||= {})[leaves] ||= @walk.active(leaves)
    end

    # Backwards from the snapshots that have the expression, a step at a time.
    def unreached(property, subjects)
      found = snapshots.select { |snapshot| true?(property.expression, snapshot) }.to_h { |one| [one, true] }
      edge = found.keys
      (property.steps || snapshots.length).times do
        edge = edge.flat_map { |snapshot| predecessors.fetch(snapshot, []) }.uniq.reject { |one| found.key?(one) }
        break if edge.empty?

        edge.each { |snapshot| found[snapshot] = true }
      end
      subjects.find { |snapshot| !found.key?(snapshot) }
    end

    def predecessors
      @predecessors ||= @walk.reachable_pairs.each_with_object({}) do |pair, found|
        pair.outcomes.uniq(&:object_id).each { |outcome| (found[outcome.after] ||= []) << pair.before }
      end
    end

    def refuse_empty(property)
      words = property.kind == :reachable ? 'configuration with its "from" is reached' : 'step of its kind is taken'
      raise Refusal.new(@document.file, property.line, RULES.fetch(property.kind),
                        "#{property.id} holds only because no #{words}; correct the property, or the chart")
    end

    def refuse(property, violated)
      return refuse_place(property, violated) if %i[start damaged].include?(property.kind)

      after, steps = violated.is_a?(Step) ? [violated.outcome.after, steps_by(violated)] : [violated, way(violated)]
      example = Counterexample.new(@document, @walk, claim(property, after), steps)
      raise Refusal.new(@document.file, property.line, RULES.fetch(property.kind),
                        "#{property.id} is violated in #{after.leaves.join(' ')}, reached by: #{example.words}; " \
                        'close that path', counterexample: example)
    end

    # No list of events leads there.
    def refuse_place(property, snapshot)
      where, remedy = { start: ['where the chart starts', 'initial, or what is done on the way there'],
                        damaged: ['where a damaged chart goes', 'bs:safe'] }.fetch(property.kind)
      raise Refusal.new(@document.file, property.line, RULES.fetch(property.kind),
                        "#{property.id} is violated in #{snapshot.leaves.join(' ')}, #{where}; correct #{remedy}")
    end

    def way(snapshot)
      @walk.steps_to(snapshot)
    end

    def steps_by(step)
      way(step.before) + [[step.stimulus, step.inputs]]
    end

    def claim(property, after)
      Counterexample::Claim.new(id: property.id, req: property.req, line: property.line, says: property.text,
                                demand: demand(property, after), at: :end, effects: property)
    end

    # At the end of the steps; from a configuration that should lead on: that it is not entered.
    def demand(property, after)
      case property.kind
      when :always, :response then property.expression
      when :only then [:not, property.expression]
      when :reachable then [:not, after.leaves.map { |id| [:in, id] }.reduce { |one, other| [:and, one, other] }]
      end
    end
  end
end
