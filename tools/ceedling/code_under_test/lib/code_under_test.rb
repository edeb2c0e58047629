# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'ceedling/plugins/plugin'
require 'fileutils'

# Links the code under test into every test: core with its charts and robots, boards and processes. make has compiled
# it before, once for all tests and as strictly as the product. What a test brings itself goes before: mocks, or a
# source that it includes.
class CodeUnderTest < Plugin
  # By Ceedling's way to run the tests.
  LIBRARIES = { test: 'build/gcc/libtest.a', gcov: 'build/gcov/libtest.a' }.freeze

  # Ceedling's hook, before it builds a test; it does not see that the library has changed.
  def pre_test(test)
    LIBRARIES.each do |context, library|
      programs = Dir["build/ceedling/#{context}/out/**/#{File.basename(test, '.c')}.out"]
      FileUtils.rm_f(programs.reject { |program| File.exist?(library) && FileUtils.uptodate?(program, [library]) })
    end
  end

  # Ceedling's hook, before it links a test.
  def pre_link_execute(arguments)
    arguments[:objects] += [LIBRARIES.fetch(arguments[:context])]
  end
end
