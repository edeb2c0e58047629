# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'ceedling/plugins/plugin'

# Links the whole core with its charts and its robots, and the simulated box, into every integration test, and into the
# tests of modes, which work on axes: none of them names a source. A unit test with the switch of kinematics gets what it chooses among, the kinematics of all robots. What
# a test includes is linked by Ceedling itself.
class WholeController < Plugin
  TESTS = %r{(?:\A|/)verification/(?:integration/|unit/test_(?:leg|mode|\w+_mode)\.c)}
  SOURCES = %w[core/*/*.c core/*/*/*.c build/gen/{charts,robot,interface}/*.c bsp/sim/{box,sim}_*.c bsp/sim/box.c].freeze

  KINEMATICS = 'core/robot/*/*.c'

  # Ceedling's hook, before it chooses the sources of a test.
  def pre_test(test)
    extractor = @ceedling[:test_context_extractor]
    included = extractor.lookup_all_header_includes_list(test).map { |header| File.basename(header.filename, '.h') }
    others = sources(test, included).reject { |source| included.include?(File.basename(source, '.c')) }
    named = extractor.lookup_build_directive_sources_list(test)
    extractor.ingest_build_directive_source_files(test, named | others) unless others.empty?
  end

  private

  def sources(test, included)
    return Dir.glob(SOURCES).reject { |source| source.end_with?('_main.c') } if test.match?(TESTS)

    included.include?('kinematics') ? Dir.glob(KINEMATICS) : []
  end
end
