# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: a test that has not passed has failed, with its reason as the last line; nothing of a run stays behind. Each test
# runs a few gates of its own in an empty folder.

require 'fileutils'
require 'json'
require 'minitest/autorun'
require 'minitest/mock'
require 'open3'
require 'tmpdir'
require_relative '../gates/run'

class TestGates < Minitest::Test
  TOOLS = File.expand_path('..', __dir__)
  ROOT = File.expand_path('../..', __dir__)
  # Leaves two tests that passed and, with an argument, one that did not.
  LEAVE = <<~RUBY
    require './tools/results'
    rows = %w[one two].map { |name| { test: "test_\#{name}", file: 'a.rb', result: 'pass' } }
    rows << { test: 'test_three', file: 'a.rb', line: 7, result: 'fail', message: ARGV.first } if ARGV.any?
    Results.leave(rows)
  RUBY

  def test_SWR_GATE_001_tests_are_counted_one_by_one_and_a_gate_without_tests_as_one
    output, status = run_gates('tests' => 'ruby leave.rb', 'none' => 'true')
    assert status.success?, output
    assert_match(%r{^\[\d/2\] It is tests \.\.\. ok \(2 passed, 0 failed, \d+ s\)$}, output)
    assert_equal '3 passed, 0 failed', output.lines.last.chomp
  end

  def test_SWR_GATE_001_a_failed_test_fails_the_gate_although_its_command_ended_well
    output, status = run_gates('tests' => 'ruby leave.rb no')
    refute status.success?
    assert_includes output, 'It is tests ... FAILED (2 passed, 1 failed'
    assert_equal '2 passed, 1 failed', output.lines.last.chomp
  end

  def test_SWR_GATE_001_a_command_that_ends_badly_fails_although_its_tests_passed
    output, status = run_gates('tests' => 'ruby leave.rb; false; true', 'none' => 'exit 3')
    refute status.success?
    assert_equal '2 passed, 2 failed', output.lines.last.chomp
  end

  def test_SWR_GATE_001_results_of_an_earlier_run_do_not_count
    Dir.mktmpdir do |folder|
      prepare(folder, 'tests' => '[ -e ran ] || ruby leave.rb; touch ran')
      assert_equal ['2 passed, 0 failed', '1 passed, 0 failed'],
                   Array.new(2) { run_in(folder).first.lines.last.chomp }
    end
  end

  def test_SWR_GATE_490_results_of_a_gate_that_is_gone_are_removed_and_those_of_another_stay
    Dir.mktmpdir do |folder|
      prepare(folder, 'a' => 'ruby leave.rb', 'b' => 'ruby leave.rb', 'gone' => 'ruby leave.rb')
      run_in(folder)
      prepare(folder, 'a' => 'ruby leave.rb', 'b' => 'ruby leave.rb')
      run_in(folder, 'a')
      assert_equal %w[a.json b.json], Dir.children(File.join(folder, 'build/results')).sort
    end
  end

  def test_SWR_GATE_001_a_gate_whose_results_hold_no_test_or_cannot_be_read_fails
    empty = %(echo '{"run": {}, "tests": []}' >build/results/empty.json)
    output, status = run_gates('empty' => empty, 'broken' => 'echo { >build/results/broken.json', 'good' => 'ruby leave.rb')
    refute status.success?
    assert_includes output, 'it holds no test'
    assert_equal '2 passed, 2 failed', output.lines.last.chomp
  end

  def test_SWR_GATE_002_two_runs_in_one_folder_are_refused
    output, = run_gates({ 'outer' => 'ruby tools/gates.rb inner || true', 'inner' => 'true' }, 'outer') do |folder|
      assert_includes File.read(File.join(folder, 'build/log/outer.log')), 'gates run in this folder already'
    end
    assert_equal '1 passed, 0 failed', output.lines.last.chomp
  end

  def test_SWR_GATE_003_durations_that_cannot_be_read_are_forgotten
    Dir.mktmpdir do |folder|
      prepare(folder, 'a' => 'true')
      FileUtils.mkdir_p(File.join(folder, 'build/log'))
      File.write(File.join(folder, 'build/log/seconds.json'), '')
      assert_equal '1 passed, 0 failed', run_in(folder).first.lines.last.chomp
    end
  end

  def test_SWR_GATE_002_what_is_asked_for_runs_after_what_it_needs_and_nothing_else_runs
    output, status = run_gates({ 'a' => 'echo a >>ran', 'b' => ['echo b >>ran', %w[a]], 'c' => 'echo c >>ran',
                                 'd' => ['echo d >>ran; cat ran', %w[b]] }, 'd') do |folder|
      assert_equal %W[a\n b\n d\n], File.readlines(File.join(folder, 'ran'))
    end
    assert status.success?, output
  end

  def test_SWR_GATE_002_what_needs_a_red_gate_is_not_run_and_has_not_passed
    output, = run_gates('a' => 'false', 'b' => ['touch ran', %w[a]], 'c' => ['touch ran', %w[b]]) do |folder|
      refute_path_exists File.join(folder, 'ran')
    end
    assert_includes output, 'It is b ... NOT RUN (a failed)'
    assert_includes output, 'not run: b, c'
    assert_equal '0 passed, 3 failed', output.lines.last.chomp
  end

  def test_SWR_GATE_002_a_gate_hears_nothing_of_the_make_that_called_it
    in_folder do
      with_environment('NAME' => 'a', 'MAKEFLAGS' => 'n') do
        job = Gates::Job.new(Gates::Gate.new(name: 'a', run: 'echo "[${NAME-}${MAKEFLAGS-}]"'), {})
        Process.wait(job.pid)
        assert_equal "[]\n", File.read('build/log/a.log')
      end
    end
  end

  def test_SWR_GATE_290_a_gate_that_computes_stands_back_and_one_that_waits_or_must_be_punctual_does_not
    here = Process.getpriority(Process::PRIO_PROCESS, 0)
    in_folder do
      nice = [{}, { waits: true }, { alone: true }].map do |fields|
        job = Gates::Job.new(Gates::Gate.new(name: 'a', run: 'nice', **fields), {})
        Process.wait(job.pid)
        File.read('build/log/a.log').to_i
      end
      assert_equal [[here + 10, 19].min, here, here], nice
    end
  end

  def test_SWR_GATE_360_a_gate_has_the_cache_of_this_clone_and_none_without_ccache
    Dir.mktmpdir do |tools|
      { 'none' => "[]\n", 'ccache' => "[ccache #{File.realpath(tools)}/.tools/ccache]\n" }.each do |program, environment|
        FileUtils.touch("#{tools}/#{program}")
        FileUtils.chmod(0o755, "#{tools}/#{program}")
        assert_equal environment, cache_of_a_gate(tools)
      end
    end
  end

  # Compiled in two folders with the prefix map of the Makefile: the second takes the object of the first.
  def test_SWR_GATE_360_an_object_of_the_cache_has_the_bytes_of_the_compiler
    Dir.mktmpdir do |folder|
      caches = [[], %w[ccache], %w[ccache]]
      objects = caches.each_with_index.map { |cache, number| compiled("#{folder}/#{number}", cache, "#{folder}/cache") }
      assert_equal 1, objects.uniq.length
      hits, = Open3.capture2({ 'CCACHE_DIR' => "#{folder}/cache" }, 'ccache', '--print-stats')
      assert_match(/^direct_cache_hit\t1$/, hits)
    end
  end

  def test_SWR_GATE_002_needs_that_go_round_are_refused
    output, status = run_gates('a' => ['true', %w[b]], 'b' => ['true', %w[a]])
    refute status.success?
    assert_equal "gates: a, b: what they need never comes\n", output
  end

  def test_SWR_GATE_003_a_line_every_half_minute_where_nothing_can_be_written_anew
    assert_equal %w[0:30 1:00 1:30].map { |time| "#{time} gone, about 2:05 left: charts 12/69 (1:15), misra (0:04)\n" },
                 reported(StringIO.new)
  end

  def test_SWR_GATE_003_a_terminal_has_one_line_that_fits
    terminal = StringIO.new
    terminal.define_singleton_method(:tty?) { true }
    terminal.define_singleton_method(:winsize) { [25, 40] }
    assert_equal ["\r\e[K0:00 gone, about 2:05 left: charts 12/6", "\r\e[K0:10 gone, about 2:05 left: charts 12/6"],
                 reported(terminal).first.scan(/\r[^\r]*/).first(2)
  end

  def test_SWR_GATE_003_a_gate_says_in_its_log_how_far_it_is
    in_folder do
      job = Gates::Job.new(Gates::Gate.new(name: 'a', run: 'echo; echo "[3/8] test_it"; echo more'), {})
      Process.wait(job.pid)
      assert_equal [3, 8], job.progress
    end
  end

  def test_SWR_GATE_003_durations_are_kept_for_the_next_run
    run_gates('a' => 'true', 'b' => 'false') do |folder|
      assert_equal %w[a], JSON.parse(File.read(File.join(folder, 'build/log/seconds.json'))).keys
    end
  end

  def test_SWR_GATE_361_the_seconds_of_a_core_are_kept_of_each_gate_that_passed
    busy = "ruby -e '1 until Process.clock_gettime(Process::CLOCK_PROCESS_CPUTIME_ID) > 0.5'"
    run_gates('busy' => "#{busy}; true", 'idle' => 'sleep 0.1', 'red' => 'false') do |folder|
      kept = JSON.parse(File.read(File.join(folder, 'build/log/core_seconds.json')))
      assert_equal %w[busy idle], kept.keys.sort
      assert_operator kept['busy'], :>=, 0.5
      assert_operator kept['idle'], :<, 0.5
    end
  end

  def test_SWR_GATE_004_the_failed_test_stands_last_with_place_message_and_how_to_repeat_it
    output, = run_gates('tests' => "ruby leave.rb 'Expected: 1\n  Actual: 2'; echo end of the log")
    assert_equal <<~TEXT, output[/^end of the log.*/m]
      end of the log
      ---

      tests: test_three (a.rb:7)
          Expected: 1
            Actual: 2
          repeat: make gate NAME=tests
      2 passed, 1 failed
    TEXT
  end

  def test_SWR_GATE_004_a_gate_without_a_failed_test_gives_the_sentences_of_its_log_that_report_it
    { "gcc -c a.c\na.c:3:5: error: no semicolon\nmake: *** [x] Error 1" => 'a.c:3:5: error: no semicolon',
      "an error\nTRACE-E18 build/results/unit.json:1: no\ntrace: 1" => 'TRACE-E18 build/results/unit.json:1: no',
      "first\nSome::LoadError (no)\nlast" => 'Some::LoadError (no)',
      "first\nlast\n\nmake[1]: *** [x] Error 1" => 'last', '' => '' }.each do |log, sentence|
      output, = run_gates('a' => "cat <<'END'\n#{log}\nEND\nfalse")
      words = ['a: build/log/a.log', *("    #{sentence}" unless sentence.empty?), '    repeat: make gate NAME=a']
      assert_includes output, "\n\n#{words.join("\n")}\n0 passed, 1 failed\n"
    end
  end

  def test_SWR_GATE_004_of_many_complaints_and_long_ones_the_beginning_is_shown
    tests = (1..12).map { |number| { 'test' => "test_#{number}", 'file' => 'a.rb', 'message' => "no\n" * 15 } }
    complaints = tests.map { |test| Gates::Complaint.of_test(test) }
    out = StringIO.new
    Gates::Progress.new(out, 1).finish([Gates::Verdict.new(gate: Gates::Gate.new(name: 'a'), passed: 3, failed: 12,
                                                           seconds: 1, complaints: complaints)])
    assert_equal 10, out.string.scan(/^a: test_\d+ \(a\.rb\)$/).size
    assert_equal 10, out.string.scan(/^    \(3 more lines\)$/).size
    assert_includes out.string, 'a: and 2 more; see build/log/a.log'
  end

  def test_SWR_GATE_005_make_refuses_an_unknown_gate_before_it_installs_or_builds
    [[], %w[NAME=nonsense], %w[NAME=a\ nonsense]].each do |words|
      Dir.mktmpdir do |folder|
        %w[Makefile bsp/sim/board.mk bsp/sim/board.yml verification/gates.mk
           verification/bench/bench.mk].each { |file| copy(file, folder) }
        File.write(File.join(folder, 'verification/gates.yml'), gates_file('a' => 'true', 'b' => 'true'))
        before = Dir.glob('**/*', base: folder)
        output, status = Open3.capture2e('make', 'gate', *words, chdir: folder)
        assert_equal 2, status.exitstatus
        assert_match(/NAME is '#{words.join[/[^=]*\z/]}', but the gates are: a b\./, output)
        assert_equal before, Dir.glob('**/*', base: folder)
      end
    end
  end

  def test_SWR_GATE_005_the_gates_themselves_refuse_it_too
    output, status = run_gates({ 'a' => 'touch ran' }, 'nonsense')
    refute status.success?
    assert_equal "gates: unknown gate nonsense; there are: a\n", output
  end

  def test_SWR_GATE_006_an_interrupt_ends_all_processes_also_those_that_went_away
    Dir.mktmpdir do |folder|
      prepare(folder, 'a' => 'setsid -f sleep 601; sleep 602 & echo $! >a.pid; wait',
                      'b' => 'trap "" TERM; (setsid sleep 603 & echo $! >b.pid); sleep 604')
      output, writer = IO.pipe
      pid = Process.spawn(clean, 'ruby', 'tools/gates.rb', chdir: folder, %i[out err] => writer)
      writer.close
      began = -> { %w[a b].all? { |name| File.size?(File.join(folder, "#{name}.pid")) } }
      sleep 0.02 until began.call || output.wait_readable(0)
      Process.kill('INT', pid)
      assert_match(/^interrupted; ended: a, b$/, output.read)
      refute Process.wait2(pid).last.success?
      assert_empty sleeping(folder)
    end
  end

  def test_SWR_GATE_006_what_a_gate_leaves_behind_is_ended_with_the_run
    run_gates('a' => 'setsid -f sleep 605 >/dev/null 2>&1') { |folder| assert_empty sleeping(folder) }
  end

  def test_SWR_GATE_007_a_gate_that_says_nothing_is_ended_and_has_failed
    in_folder do
      job = Gates::Job.new(Gates::Gate.new(name: 'a', run: 'sleep 606'), {}, silence: 0)
      job.watch
      verdict = job.verdict(Process.wait2(job.pid).last)
      refute verdict.passed?
      assert_equal "build/log/a.log\n    It had said nothing for 0 seconds and was ended.", verdict.complaints.first.to_s
    end
  end

  def test_SWR_GATE_007_a_gate_that_speaks_is_not_ended
    in_folder do
      File.mkfifo('pipe')
      job = Gates::Job.new(Gates::Gate.new(name: 'a', run: 'echo; read -r line <pipe'), {}, silence: 60)
      job.watch
      File.write('pipe', "go on\n")
      assert job.verdict(Process.wait2(job.pid).last).passed?
    end
  end

  private

  # Output for a user of gates name => command or [command, needs]; the block looks at the folder.
  def run_gates(gates, *wanted)
    Dir.mktmpdir do |folder|
      prepare(folder, gates)
      output, status = run_in(folder, *wanted)
      yield folder if block_given?
      return output, status
    end
  end

  def run_in(folder, *wanted)
    Open3.capture2e(clean, 'ruby', 'tools/gates.rb', *wanted, chdir: folder)
  end

  def prepare(folder, gates)
    %w[gates gates.rb results.rb origin.rb gems.lock].each { |name| copy("tools/#{name}", folder) }
    FileUtils.mkdir_p(File.join(folder, 'verification'))
    File.write(File.join(folder, 'verification/gates.yml'), gates_file(gates))
    File.write(File.join(folder, 'leave.rb'), LEAVE)
  end

  def gates_file(gates)
    rows = gates.map do |name, (command, needs)|
      { 'name' => name, 'says' => "It is #{name}", 'seconds' => 1, 'needs' => needs.to_a, 'run' => command }
    end
    rows.to_yaml
  end

  def copy(name, folder)
    FileUtils.mkdir_p(File.dirname(File.join(folder, name)))
    FileUtils.cp_r(File.join(ROOT, name), File.join(folder, name))
  end

  # Nothing of the run that this test is part of.
  def clean
    { Results::NAME => nil, Origin::ENVIRONMENT => nil }
  end

  def in_folder
    Dir.mktmpdir do |folder|
      Dir.chdir(folder) do
        FileUtils.mkdir_p('build/log')
        yield
      end
    end
  end

  def with_environment(more)
    before = ENV.to_h
    ENV.update(more)
    yield
  ensure
    ENV.replace(before)
  end

  # Words of a gate whose PATH is this folder, in which it runs.
  def cache_of_a_gate(tools)
    FileUtils.ln_sf(%w[/bin/bash /usr/bin/nice], tools)
    FileUtils.mkdir_p("#{tools}/build/log")
    with_environment('PATH' => tools, 'COMPILER_CACHE' => nil, 'CCACHE_DIR' => nil) do
      Dir.chdir(tools) do
        job = Gates::Job.new(Gates::Gate.new(name: 'a', run: 'echo "[${COMPILER_CACHE-}${CCACHE_DIR:+ $CCACHE_DIR}]"'), {})
        Process.wait(job.pid)
        File.read('build/log/a.log')
      end
    end
  end

  def compiled(folder, cache, kept)
    FileUtils.mkdir_p(folder)
    File.write("#{folder}/a.c", "int f(void)\n{\n    return 1;\n}\n")
    output, status = Open3.capture2e({ 'CCACHE_DIR' => kept, 'CCACHE_DISABLE' => nil }, *cache, 'gcc', '-O2', '-g',
                                     "-ffile-prefix-map=#{folder}=.", '-MMD', '-c', 'a.c', '-o', 'a.o', chdir: folder)
    assert_predicate status, :success?, output
    File.binread("#{folder}/a.o")
  end

  # Living processes that began in the folder.
  def sleeping(folder)
    Dir.glob('/proc/[0-9]*').select do |process|
      File.readlink("#{process}/cwd").start_with?(File.realpath(folder))
    rescue SystemCallError
      false
    end
  end

  # Output while 90 seconds pass, by lines.
  def reported(out)
    now = 0
    jobs = [['charts', [12, 69], 75], ['misra', nil, 4]].map do |name, progress, seconds|
      Struct.new(:gate, :progress, :seconds).new(Gates::Gate.new(name: name), progress, seconds)
    end
    Gates.stub(:now, -> { now }) do
      reporter = Gates::Progress.new(out, 3)
      10.times do
        reporter.progress(jobs, 125)
        now += 10
      end
    end
    out.string.lines
  end
end
