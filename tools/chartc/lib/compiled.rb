# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'check/static_checks'
require_relative 'check/walk_checks'
require_relative 'read/parser'
require_relative 'walk/walk'

module Chart
  # A chart with its walk.
  Compiled = Struct.new(:document, :walk) do
    # A chart that passes every rule. owners: whose each limit is, name => id of a requirement; nil where nobody knows.
    def self.from(file, text, limits, mode: :product, extra_events: [], owners: nil)
      document = Parser.parse(file, text, limits, mode: mode, extra_events: extra_events)
      StaticChecks.run(document, owners)
      walk = Walk.new(document).run
      WalkChecks.run(document, walk)
      new(document, walk)
    end

    # What a chart says, whether or not it may be compiled; without a walk where it cannot be walked.
    def self.leniently(file, text, limits)
      document = Parser.parse(file, text, limits, mode: :difference)
      new(document, walked(document))
    end

    def self.walked(document)
      StaticChecks.run(document)
      Walk.new(document).run
    rescue Refusal
      nil
    end
    private_class_method :walked
  end
end
