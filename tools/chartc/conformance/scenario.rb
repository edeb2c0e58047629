# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../lib/check/static_checks'
require_relative '../lib/emit/c/source'
require_relative '../lib/read/parser'
require_relative '../lib/walk/walk'

module Conformance
  # One thing that is done to a chart. kind and value: :start; :event, name or number; :advance, microseconds;
  # :corrupt, [region, value]; :check. expected: { in:, data:, armed:, actions:, sound:, repaired: }, as far as it
  # says anything.
  Step = Struct.new(:kind, :value, :inputs, :expected, keyword_init: true)

  # What a chart shows after a step. taken: numbers of transitions; repaired: whether a check had to.
  Seen = Struct.new(:leaves, :history, :data, :armed, :actions, :taken, :sound, :repaired, keyword_init: true)

  # A chart that the compiler accepts, with its walk: in its engine's mode, or with limits as one of a product.
  Chart = Struct.new(:document, :walk) do
    def self.from(file, events, limits = nil)
      document = ::Chart::Parser.parse(file, File.read(file, encoding: 'UTF-8'), limits || {},
                                       mode: limits ? :product : :engine, extra_events: events)
      ::Chart::StaticChecks.run(document)
      new(document, ::Chart::Walk.new(document).run)
    end
  end

  # A chart, and what is to be done to it. scion: why SCION does otherwise, or nil.
  Scenario = Struct.new(:name, :file, :says, :chart, :steps, :scion, keyword_init: true) do
    # Only the compiled code has copies to damage and takes numbers for events.
    def interpretable?
      steps.none? { |step| %i[corrupt check].include?(step.kind) || step.value.is_a?(Integer) && step.kind == :event }
    end
  end

  # A chart outside the profile.
  Refused = Struct.new(:name, :folder, :refusal)
end
