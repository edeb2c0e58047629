# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: Ceedling builds and runs one file of C tests by project.yml, whether or not it has mocks.
# The gate build has compiled the code under test.

require 'minitest/autorun'
require 'open3'

class TestOne < Minitest::Test
  WITH_MOCKS = 'test_bsp_sbrio'
  PLAIN = 'test_encoder'

  def test_SWR_GATE_291_a_file_runs_with_its_mocks_and_without
    [PLAIN, WITH_MOCKS].each do |test|
      output, status = Open3.capture2e('ruby', '.tools/gems/bin/ceedling', "test:#{test}")
      assert_predicate status, :success?, output
      assert_match(/^TESTED: +[1-9]/, output)
      assert_match(/^FAILED: +0$/, output)
    end
  end
end
