# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'ceedling/plugins/plugin'
require 'fileutils'

# Links the code under test into a test: core with its charts and robots, boards and processes. make has compiled it before, once
# for all tests and as strictly as the product. Sources that a test brings itself go before: mocks, or a source that it includes.
#
# @satisfies SWR-GATE-291
class CodeUnderTest < Plugin
  LIBRARY = 'build/gcc/libtest.a'

  # Ceedling's hook, before it builds a test; it does not see that the library has changed.
  def pre_test(test)
    programs = Dir["build/ceedling/test/out/**/#{File.basename(test, '.c')}.out"]
    FileUtils.rm_f(programs.reject { |program| FileUtils.uptodate?(program, [LIBRARY]) })
  end

  # Ceedling's hook, before it links a test.
  def pre_link_execute(arguments)
    arguments[:objects] << LIBRARY
  end
end
