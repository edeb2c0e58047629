# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: whatever a runner reports of a test, its verdict, place and message arrive in the results.

require 'fileutils'
require 'json'
require 'minitest/autorun'
require 'open3'
require 'tmpdir'
require_relative '../c_tests'
require_relative '../results'

class TestResults < Minitest::Test
  TOOLS = File.expand_path('..', __dir__)

  def test_SWR_TRACE_001_results_of_unity
    output = "core says hello\nx.c:3:test_a(1):PASS\nx.c:7:test_b:FAIL: Expected 1 Was 2\nx.c:9:test_c:IGNORE\nFAIL\n"
    rows = [['test_a(1)', 'x.c', 'pass', nil, nil], ['test_b', 'x.c', 'fail', 7, 'Expected 1 Was 2'],
            ['test_c', 'x.c', 'ignore', 9, nil]]
    assert_equal rows, rows(CTests.rows('x.c', output, false))
  end

  def test_SWR_TRACE_001_a_program_that_ends_otherwise_than_its_tests_say_has_failed
    crash = ['x', 'x.c', 'fail', nil, "x.c:3:test_a:PASS\nx.c:8: runtime error: overflow\n"]
    assert_equal [['test_a', 'x.c', 'pass', nil, nil], crash], rows(CTests.rows('x.c', crash.last, false))
    assert_equal [['x', 'x.c', 'fail', nil, '']], rows(CTests.rows('x.c', '', true))
  end

  def test_SWR_TRACE_001_results_of_vitest
    file = File.join(Dir.pwd, 'a.test.ts')
    stack = "AssertionError: expected 1 to be 2\n\n- 2\n+ 1\n    at #{file}:12:5\n    at run (other.js:1:2)"
    tests = [{ 'fullName' => 'SWR-CON-001 a', 'status' => 'passed', 'failureMessages' => [] },
             { 'fullName' => 'b', 'status' => 'failed', 'failureMessages' => [stack] },
             { 'fullName' => 'c', 'status' => 'todo' }]
    report = { 'testResults' => [{ 'name' => file, 'status' => 'failed', 'message' => '', 'assertionResults' => tests },
                                 { 'name' => File.join(Dir.pwd, 'b.test.ts'), 'status' => 'failed',
                                   'message' => "no\nway", 'assertionResults' => [] }] }
    assert_equal [['SWR-CON-001 a', 'a.test.ts', 'pass', nil, nil],
                  ['b', 'a.test.ts', 'fail', 12, "AssertionError: expected 1 to be 2\n\n- 2\n+ 1"],
                  ['c', 'a.test.ts', 'ignore', nil, nil], ['no', 'b.test.ts', 'fail', nil, "no\nway"]],
                 rows(Results.vitest(report))
  end

  def test_SWR_TRACE_001_results_of_minitest
    in_tools do |root|
      File.write(File.join(root, 'tools/test/test_it.rb'), <<~RUBY)
        require 'minitest/autorun'
        class TestIt < Minitest::Test
          define_method(:test_a) { assert true }
          define_method(:test_b) { flunk 'why' }
          define_method(:test_c) { skip }
          define_method(:test_d) { raise 'no' }
          define_method(:test_e) {}
        end
      RUBY
      output, = run_in(root, 'tools/test/result_reporter.rb', 'tools/test/test_it.rb')
      assert_equal (0..4).map { |done| "[#{done}/5]" }, output.scan(%r{^\[\d/\d\](?= TestIt#test_[a-e]$)})
      tests = JSON.parse(File.read(File.join(root, 'build/results/it.json'))).fetch('tests')
      assert_equal [['test_a', 'pass', 1, nil], ['test_b', 'fail', 1, 4], ['test_c', 'ignore', 0, 5],
                    ['test_d', 'fail', 0, 6], ['test_e', 'pass', 0, nil]],
                   tests.map { |row| row.values_at('test', 'result', 'assertions', 'line') }
      assert_equal ['tools/test/test_it.rb'], tests.map { |row| row['file'] }.uniq
      assert_equal [nil, 'why', 'Skipped, no message given', 'RuntimeError: no', nil],
                   tests.map { |row| row['message']&.lines&.first&.chomp }
    end
  end

  # Each waits until all three run; a fault is bounded by a time that no load comes near.
  WAITING = <<~RUBY
    require 'minitest/autorun'
    class %<group>s < Minitest::Test
      define_method(:test_it) do
        File.write('%<group>s.runs', '')
        3000.times { Dir['*.runs'].size < 3 ? sleep(0.01) : break }
        assert_equal 3, Dir['*.runs'].size
      end
    end
  RUBY

  def test_SWR_TOOL_090_files_run_beside_each_other_and_leave_the_results_of_all
    in_tools do |root|
      groups = %w[One Two Three]
      groups.each { |group| File.write(File.join(root, "tools/test/#{group}.rb"), format(WAITING, group: group)) }
      output, status = run_in(root, 'tools/beside.rb', '3', *groups.map { |group| "tools/test/#{group}.rb" }, origin: '{}')
      assert status.success?, output
      assert_equal %w[[1/3] [2/3] [3/3]], output.scan(%r{^\[\d/\d\](?= tools/test/\w+\.rb$)})
      assert_equal groups.sort.map { |group| ['test_it', "tools/test/#{group}.rb", 'pass'] }, left_in(root)
    end
  end

  def test_SWR_TOOL_090_a_file_that_fails_or_does_not_come_to_its_tests_is_in_the_results
    in_tools do |root|
      File.write(File.join(root, 'tools/test/a.rb'), "require 'minitest/autorun'\nClass.new(Minitest::Test) { def test_a = flunk }\n")
      File.write(File.join(root, 'tools/test/b.rb'), "abort 'no way'\n")
      output, status = run_in(root, 'tools/beside.rb', '1', 'tools/test/a.rb', 'tools/test/b.rb', origin: '{}')
      refute status.success?, output
      assert_equal [%w[test_a tools/test/a.rb fail], %w[b tools/test/b.rb fail]], left_in(root)
    end
  end

  def test_SWR_TRACE_002_every_runner_leaves_its_results_with_their_origin
    in_tools do |root|
      report = { testResults: [{ name: 'a.test.ts', status: 'passed', assertionResults: [{ fullName: 'a', status: 'passed' }] }] }
      say = "puts ' ✓ a.test.ts (1)'; File.write('report.json', #{JSON.generate(report).inspect}); exit 3"
      FileUtils.mkdir_p(File.join(root, 'app/console/src'))
      File.write(File.join(root, 'app/console/src/a.test.ts'), '')
      output, status = run_in(root, 'tools/results.rb', 'vitest', 'report.json', 'ruby', '-e', say)
      assert_equal "[0/1]  ✓ a.test.ts (1)\n", output
      refute status.success?, 'the runner had failed'
      left = JSON.parse(File.read(File.join(root, 'build/results/it.json')))
      assert_equal [{ 'test' => 'a', 'file' => 'a.test.ts', 'result' => 'pass' }], left.fetch('tests')
      assert_equal %w[commit tree is_changed checkout machine tools time], left.fetch('run').keys
    end
  end

  def test_SWR_TRACE_002_a_report_of_an_earlier_run_is_not_taken_for_this_ones
    in_tools do |root|
      File.write(File.join(root, 'report.json'), '{}')
      output, status = run_in(root, 'tools/results.rb', 'vitest', 'report.json', 'true')
      refute status.success?
      assert_equal "true left no report.json\n", output
    end
  end

  private

  def rows(results)
    results.map { |row| row.values_at(:test, :file, :result, :line, :message) }
  end

  # Test, file and verdict of each row of the one file of results.
  def left_in(root)
    assert_equal ['it.json'], Dir.children(File.join(root, 'build/results'))
    JSON.parse(File.read(File.join(root, 'build/results/it.json'))).fetch('tests').map { |row| row.values_at('test', 'file', 'result') }
  end

  # A folder with what leaves results.
  def in_tools
    Dir.mktmpdir do |root|
      FileUtils.mkdir_p(File.join(root, 'tools/test'))
      %w[results.rb origin.rb gems.lock test/result_reporter.rb beside.rb].each do |name|
        FileUtils.cp(File.join(TOOLS, name), File.join(root, 'tools', name))
      end
      yield root
    end
  end

  def run_in(root, *command, origin: nil)
    Open3.capture2e({ Results::NAME => 'it', Origin::ENVIRONMENT => origin }, 'ruby', *command, chdir: root)
  end
end
