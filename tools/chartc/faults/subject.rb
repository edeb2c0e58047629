# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../lib/compiled'
require_relative '../conformance/own_cases'
require_relative '../proof/pairs'

module Faults
  # A chart on which faults show, with what the untouched compiler expects of it. scenario: its conformance case, nil
  # for the sample. request: what the emitter's process needs to read it.
  class Subject
    SAMPLE = File.expand_path('../test/charts/sample.scxml', __dir__)
    LIMITS = { 'cycle_us' => 1000, 'short_us' => 500_000, 'heat_limit_us' => 2_000_000 }.freeze

    attr_reader :name, :document, :walk, :pairs, :scenario, :request

    def self.named(name)
      name == 'sample' ? sample : of_case(name)
    end

    def self.sample
      chart = ::Chart::Compiled.from(SAMPLE, File.read(SAMPLE, encoding: 'UTF-8'), LIMITS)
      new('sample', chart, nil, file: SAMPLE, limits: LIMITS, mode: :product, events: [])
    end

    def self.of_case(name)
      file = File.join(Conformance::OwnCases::FOLDER, "#{name}.scxml")
      scenario = Conformance::OwnCases.new(file).scenario
      events = YAML.safe_load_file(file.sub(/scxml\z/, 'yml')).fetch('events', [])
      new(name, scenario.chart, scenario, file: file, limits: {}, mode: :engine, events: events)
    end

    def initialize(name, chart, scenario, request)
      @name = name
      @document = chart.document
      @walk = chart.walk
      @scenario = scenario
      @request = request
      @pairs = Pairs.new(document, walk)
    end
  end
end
