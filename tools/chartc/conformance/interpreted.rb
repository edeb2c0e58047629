# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../lib/walk/interpreter'
require_relative '../proof/scion'
require_relative 'scenario'

module Conformance
  # Gives an interpreter a clock: each timer counts from its start, and what reached its threshold in one advance
  # expires in one call.
  class Interpreted
    # stepper: an Interpreter, or one that answers like it.
    def initialize(document, stepper = ::Chart::Interpreter.new(document))
      @document = document
      @stepper = stepper
    end

    def run(steps)
      steps.map { |step| take(step) }
    end

    def take(step)
      case step.kind
      when :start then start
      when :event then show(@stepper.dispatch(@snapshot, step.value, step.inputs))
      when :advance then advance(step.value, step.inputs)
      end
    end

    private

    def start
      @elapsed = {}
      show(@stepper.start)
    end

    def advance(microseconds, inputs)
      @snapshot.armed.each { |id| @elapsed[id] += microseconds }
      due = @document.timers.select { |timer| due?(timer) }
      show(@stepper.expire(@snapshot, due.map(&:id), inputs))
    end

    def due?(timer)
      @snapshot.armed.include?(timer.id) && @elapsed[timer.id] >= timer.threshold_us
    end

    def show(outcome)
      @snapshot = outcome.after
      outcome.started.each { |id| @elapsed[id] = 0 }
      Seen.new(**@snapshot.to_h, actions: outcome.actions, taken: outcome.taken.map(&:number), sound: true)
    end
  end

  # SCION in the interpreter's place.
  class ScionStepper
    def initialize(session, document)
      @session = session
      @document = document
    end

    def start
      outcome(@session.outcomes(@document.file, nil, [], [{}]).first, [])
    end

    def dispatch(snapshot, event, inputs)
      step(snapshot, [:event, event], inputs)
    end

    def expire(snapshot, timer_ids, inputs)
      step(snapshot, [:expire, timer_ids], inputs)
    end

    private

    def step(snapshot, stimulus, inputs)
      found = @session.outcomes(@document.file, snapshot, Scion.events(@document, stimulus), [inputs]).first
      outcome(found, found['taken'].map { |source, index| Scion.transition(@document, source, index) })
    end

    def outcome(found, taken)
      own = found['data'].to_h.slice(*@document.data.map(&:name))
      after = ::Chart::Snapshot.new(found['leaves'], found['history'], own, found['armed'])
      actions = taken.flat_map(&:actions).uniq
      ::Chart::Outcome.new(after: after, taken: taken, actions: actions, started: found['started'])
    end
  end
end
