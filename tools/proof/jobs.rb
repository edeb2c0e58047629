# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'harness'

module Proof
  # One run that may pass or fail: `complaints` say why it fails.
  # functions: in which something was checked.
  Verdict = Struct.new(:job, :complaints, :count, :seconds, :functions, keyword_init: true) do
    def passed?
      complaints.empty?
    end
  end

  # A function of a harness: every property holds, and what is said to be possible is.
  class Proved
    attr_reader :harness, :function

    def initialize(harness, function, line)
      @harness = harness
      @function = function
      @line = line
    end

    def name
      @function
    end

    def row
      { test: @function, file: @harness.file, line: @line }
    end

    # @satisfies SWR-TOOL-201
    # @satisfies SWR-TOOL-203
    def run
      answer = @harness.run(@function)
      return Verdict.new(job: self, complaints: [answer.trouble], count: 0, seconds: answer.seconds) unless answer.properties

      checked = answer.properties.reject(&:possible?)
      Verdict.new(job: self, complaints: complaints(answer.properties), count: checked.size, seconds: answer.seconds,
                  functions: checked.map(&:function).uniq)
    rescue Refused => e
      Verdict.new(job: self, complaints: [e.message], count: 0, seconds: 0)
    end

    private

    def complaints(properties)
      missing = without_body(properties)
      return missing if missing.any?

      possible, checked = properties.partition(&:possible?)
      broken(checked) + impossible(possible) + empty(checked)
    end

    # A call without a body answers anything, also a pointer to nowhere: all else that does not hold may follow from it.
    #
    # @satisfies SWR-TOOL-620
    def without_body(properties)
      properties.select(&:missing).uniq(&:missing).map do |property|
        "no body for #{property.missing}, which #{property.place} calls: #{Harness::LIST} names no source or contract of it for #{@harness.file}"
      end
    end

    def broken(properties)
      properties.reject(&:holds).map { |property| "#{property.place}: does not hold: #{property.text}" }
    end

    def impossible(properties)
      return ["#{@function} says nothing that is possible: it may have proved nothing"] if properties.empty?

      properties.select(&:holds).map { |property| "#{property.place}: never happens: #{property.text}" }
    end

    def empty(properties)
      properties.any?(&:sentence?) ? [] : ["#{@function} has no sentence"]
    end
  end

  # A seeded fault: a sentence must not hold any more.
  class Refuted
    FOLDER = 'build/proof/mutants'

    def initialize(harness, mutant, number)
      @harness = harness
      @mutant = mutant
      @folder = File.join(FOLDER, number.to_s)
    end

    def name
      "refuted: #{@mutant.name}"
    end

    def row
      { test: @mutant.name, file: @harness.file }
    end

    # @satisfies SWR-TOOL-202
    def run
      answer = @harness.run_mutant(@mutant, @folder)
      refuted = answer.properties.to_a.count { |property| property.sentence? && !property.holds }
      complaints = refuted.positive? ? [] : ["the prover does not refute #{@mutant.name} #{answer.trouble}".strip]
      Verdict.new(job: self, complaints: complaints, count: refuted, seconds: answer.seconds)
    rescue Refused => e
      Verdict.new(job: self, complaints: [e.message], count: 0, seconds: 0)
    end
  end
end
