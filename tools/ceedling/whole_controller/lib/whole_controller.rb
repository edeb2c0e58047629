# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'ceedling/plugins/plugin'

# Links the whole core with its charts and its robot, and the simulated box, into every integration test: none of them
# names a source. What a test includes is linked by Ceedling itself.
class WholeController < Plugin
  TESTS = %r{(?:\A|/)verification/integration/}
  SOURCES = %w[core/*/*.c core/*/*/*.c build/gen/{charts,robot,interface}/*.c bsp/sim/{box,sim}_*.c bsp/sim/box.c].freeze

  # Ceedling's hook, before it chooses the sources of a test.
  def pre_test(test)
    return unless test.match?(TESTS)

    extractor = @ceedling[:test_context_extractor]
    included = extractor.lookup_all_header_includes_list(test).map { |header| File.basename(header.filename, '.h') }
    others = sources.reject { |source| included.include?(File.basename(source, '.c')) }
    extractor.ingest_build_directive_source_files(test, others)
  end

  private

  def sources
    Dir.glob(SOURCES).reject { |source| source.end_with?('_main.c') }
  end
end
