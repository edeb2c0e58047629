# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'check/static_checks'
require_relative 'check/walk_checks'
require_relative 'read/parser'
require_relative 'walk/walk'

module Chart
  # A chart that passed every rule, with its walk.
  Compiled = Struct.new(:document, :walk) do
    def self.from(file, text, limits, mode: :product, extra_events: [])
      document = Parser.parse(file, text, limits, mode: mode, extra_events: extra_events)
      StaticChecks.run(document)
      walk = Walk.new(document).run
      WalkChecks.run(document, walk)
      new(document, walk)
    end
  end
end
