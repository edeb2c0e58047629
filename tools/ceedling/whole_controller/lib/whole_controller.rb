# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'ceedling/plugins/plugin'
require 'fileutils'

# Links the whole core with its charts and its robots, and the simulated box, into every integration test, and into the
# tests of modes, which work on axes: none of them names a source. make has compiled them before, once for all of these
# tests. A unit test with the switch of kinematics gets what it chooses among, the kinematics of all robots. What a
# test includes is compiled and linked by Ceedling itself.
class WholeController < Plugin
  TESTS = %r{(?:\A|/)verification/(?:integration/|unit/test_(?:leg|mode|\w+_mode)\.c)}
  # By Ceedling's way to run the tests.
  LIBRARIES = { test: 'build/gcc/libtest-core.a', gcov: 'build/gcov/libtest-core.a' }.freeze
  KINEMATICS = 'core/robot/*/*.c'

  # Ceedling's hook, before it chooses the sources of a test.
  def pre_test(test)
    return forget_older(test) if test.match?(TESTS)

    extractor = @ceedling[:test_context_extractor]
    included = extractor.lookup_all_header_includes_list(test).map { |header| File.basename(header.filename, '.h') }
    return unless included.include?('kinematics')

    others = Dir.glob(KINEMATICS).reject { |source| included.include?(File.basename(source, '.c')) }
    extractor.ingest_build_directive_source_files(test, extractor.lookup_build_directive_sources_list(test) | others)
  end

  # Ceedling's hook, before it links a test.
  def pre_link_execute(arguments)
    name = File.basename(arguments[:executable], '.*')
    return unless Dir["verification/{unit,integration}/#{name}.c"].any? { |test| test.match?(TESTS) }

    arguments[:objects] += [LIBRARIES.fetch(arguments[:context])]
  end

  private

  # Ceedling does not see that the library has changed.
  def forget_older(test)
    LIBRARIES.each do |context, library|
      programs = Dir["build/ceedling/#{context}/out/**/#{File.basename(test, '.c')}.out"]
      FileUtils.rm_f(programs.reject { |program| File.exist?(library) && FileUtils.uptodate?(program, [library]) })
    end
  end
end
