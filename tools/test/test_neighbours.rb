# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the bench says that another Boresight ran only when it was another one.

require 'fileutils'
require 'minitest/autorun'
require 'tmpdir'
require_relative '../neighbours'

class TestNeighbours < Minitest::Test
  OURS = 'test-42-'

  def setup
    @proc = Dir.mktmpdir('proc')
  end

  def teardown
    FileUtils.rm_rf(@proc)
  end

  def run_process(pid, comm, *words)
    folder = FileUtils.mkdir_p(File.join(@proc, pid.to_s)).first
    File.write(File.join(folder, 'comm'), "#{comm}\n")
    File.write(File.join(folder, 'cmdline'), words.map { |word| "#{word}\0" }.join)
  end

  def any?
    Neighbours.new(ours: OURS, proc: @proc).any?
  end

  def test_SWR_TOOL_022_a_control_loop_of_another_is_a_neighbour
    run_process(7, 'boresight-contr', 'boresight-control', '--instance', 'boresight', '--real-time')
    assert_predicate self, :any?
  end

  def test_SWR_TOOL_022_a_control_loop_of_another_bench_is_a_neighbour
    run_process(7, 'boresight-contr', 'boresight-control', '--instance', 'test-421-1')
    assert_predicate self, :any?
  end

  def test_SWR_TOOL_022_the_systems_of_this_bench_are_none
    run_process(7, 'boresight-contr', 'boresight-control', '--instance', 'test-42-1')
    run_process(8, 'boresight-contr', 'boresight-control', '--real-time', '--instance', 'test-42-2')
    refute_predicate self, :any?
  end

  def test_SWR_TOOL_022_a_control_loop_that_ends_is_none
    run_process(7, 'boresight-contr')
    refute_predicate self, :any?
  end

  def test_SWR_TOOL_022_other_programs_are_none
    run_process(7, 'boresight-http', 'boresight-http', '--instance', 'boresight')
    FileUtils.mkdir_p(File.join(@proc, '8'))
    refute_predicate self, :any?
  end
end
