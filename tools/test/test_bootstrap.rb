# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the bootstrap waits for another program that installs packages, names it, and refuses with a sentence
# whatever else goes wrong. apt-get and what it would change are played.

require 'fileutils'
require 'minitest/autorun'
require 'open3'
require 'tmpdir'

class TestBootstrap < Minitest::Test
  ROOT = File.expand_path('../..', __dir__)
  LOCKED = 'E: Could not get lock /var/lib/dpkg/lock-frontend. It is held by process 4242 (unattended-upgr)'
  PLAYED = {
    'dpkg-query' => 'test -e installed && echo ii',
    'id' => 'echo 0',
    'sleep' => 'exit 0',
    'npm' => 'touch asked; i=0; while [ -e lasting ] && [ $i -lt 20000 ]; do i=$((i + 1)); done',
    'apt-get' => 'echo "$@" >>asked; left=$(cat locked); ' \
                 "if [ $left -gt 0 ]; then echo $((left - 1)) >locked; echo '#{LOCKED}' >&2; exit 100; fi; " \
                 'if [ -e broken ]; then echo "E: Unable to locate package gcc" >&2; exit 100; fi; touch installed'
  }.freeze

  def bootstrap(purpose = 'run', locked: 0, broken: false, lasting: false)
    Dir.mktmpdir('bootstrap') do |folder|
      FileUtils.mkdir_p(%W[#{folder}/tools/node #{folder}/played])
      %w[tools/bootstrap tools/run_long tools/packages.txt tools/node/package-lock.json].each { |file| FileUtils.cp("#{ROOT}/#{file}", "#{folder}/#{file}") }
      File.write("#{folder}/locked", locked.to_s)
      FileUtils.touch("#{folder}/broken") if broken
      FileUtils.touch("#{folder}/lasting") if lasting
      PLAYED.each do |name, script|
        File.write("#{folder}/played/#{name}", "#!/bin/sh\n#{script}\n", perm: 0o755)
      end
      text, status = Open3.capture2e({ 'PATH' => "#{folder}/played:#{ENV.fetch('PATH')}" }, "#{folder}/tools/bootstrap", purpose)
      [text, status.success?, File.readlines("#{folder}/asked", chomp: true)]
    end
  end

  def test_SWR_TOOL_025_another_program_that_installs_is_named_and_waited_for
    text, is_done, asked = bootstrap(locked: 3)
    assert is_done, text
    assert_equal 3, text.scan('another program installs packages (process 4242 (unattended-upgr)); this one waits for it').size
    assert_equal %w[update update update update install], asked.map { |words| words[/\w+/] }
  end

  def test_SWR_TOOL_034_what_joins_pictures_is_installed_for_pictures_alone
    installed = %w[run client site test pictures].to_h { |purpose| [purpose, bootstrap(purpose).last.last.split] }
    assert_equal %w[pictures], installed.select { |_purpose, words| words.include?('webp') }.keys
    assert_empty installed['test'] - installed['pictures']
  end

  def test_SWR_TOOL_035_what_lasts_says_every_ten_seconds_what_it_does
    text, is_done, = bootstrap(lasting: true)
    assert is_done, text
    assert_match(/^npm, 10 s: npm runs$/, text)
  end

  # Commands that a newcomer may have to wait for.
  def test_SWR_TOOL_035_everything_that_is_fetched_or_packed_shows_that_it_lasts
    lines = %w[tools/bootstrap Makefile site/site.mk].flat_map { |file| File.readlines("#{ROOT}/#{file}", chomp: true) }
    long = lines.grep(%r{\A\s*[^#\s].*\b(npm (ci|run)|gem install|apt-get "|ruby tools/debian/(sources|armhf|prover)\.rb)})
    assert_equal 9, long.size, long.join("\n")
    assert_empty long.grep_v(/run_long/)
  end

  # By what make would run.
  def test_SWR_TOOL_610_parts_of_make_test_install_before_anything_else_runs
    %w[unit scenes arm misra proof].each do |command|
      text, status = Open3.capture2e({ 'MAKEFLAGS' => nil, 'MAKELEVEL' => nil }, 'make', '-n', command, chdir: ROOT)
      assert status.success?, text
      assert_equal 'test', text[%r{^[^#\n]*tools/(bootstrap \w+|\w+\.rb)}, 1].to_s[/\Abootstrap (\w+)/, 1], "#{command}: #{text.lines.first}"
    end
  end

  def test_SWR_TOOL_025_whatever_else_is_wrong_ends_with_a_sentence
    text, is_done, asked = bootstrap(broken: true)
    refute is_done
    assert_equal ['update'], asked
    assert_includes text, 'check the network and the package sources, then repeat.'
  end
end
