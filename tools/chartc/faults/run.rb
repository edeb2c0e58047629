# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'emitter'
require_relative 'fault'
require_relative 'subject'

module Faults
  # Seeds faults and puts the checks to what comes out, on two processors.
  class Run
    PROCESSORS = 2

    # charts: the names of all that are used.
    def initialize(charts)
      @subjects = charts.to_h { |name| [name, Subject.named(name)] }
      @workshops = @subjects.values.to_h { |subject| [subject, Workshop.new(subject)] }
      @emitter = Emitter.new
      @sound = @emitter.emit(@subjects.values)
    end

    def close
      @emitter.close
      @workshops.each_value(&:close)
    end

    # "chart, shape" => verdicts on the emitter as it stands.
    def untouched
      parallel(@sound.to_a) { |subject, code| trial(subject, code) }.to_h
    end

    def results(faults)
      parallel(faults) { |fault| result(fault) }
    end

    private

    def parallel(items, &work)
      queue = Queue.new
      items.each_with_index { |item, index| queue << [item, index] }
      queue.close
      found = Array.new(PROCESSORS) { Thread.new { drain(queue, &work) } }.flat_map(&:value)
      found.sort_by(&:first).map(&:last)
    end

    def drain(queue)
      results = []
      while (item, index = queue.pop)
        results << [index, yield(item)]
      end
      results
    end

    def result(fault)
      emitted = @emitter.emit(@subjects.values_at(*fault.charts), fault)
      Result.new(fault, emitted.to_h { |subject, code| trial(subject, changed(subject, code)) })
    rescue Unfit => e
      Result.new(fault, {}, e.message)
    end

    def changed(subject, code)
      raise Unfit, "it changes nothing on #{subject.name}" if code == @sound.fetch(subject)

      code
    end

    def trial(subject, code)
      ["#{subject.name}, #{code.shape}", Trial.new(subject, code, @workshops.fetch(subject)).verdicts]
    end
  end
end
