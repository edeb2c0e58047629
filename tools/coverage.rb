#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Counts what `ruby tools/c_tests.rb gcov` has just reached, in gcc's code without a sanitizer, by lcov, for the tools that read its
# tracefiles, and by gcovr, and compares them. The gate unit counts by clang: tools/uncovered.rb.
#
#   ruby tools/coverage.rb   build/coverage/lcov.info, build/coverage/index.html; gcovr's pages: build/gcov/coverage/index.html
#
# Exit 1 if the two do not count the same, or if a line or a branch is not covered.

require 'etc'
require 'fileutils'
require 'json'

# Covered and all lines, functions and branches of each file, as two tools count them.
class Coverage
  KINDS = %w[lines functions branches].freeze

  def self.lcov(text)
    text.split("end_of_record\n").to_h do |record|
      counts = %w[L FN BR].map { |kind| %w[H F].map { |what| record[/^#{kind}#{what}:(\d+)/, 1].to_i } }
      [record[/^SF:(.*)/, 1], counts]
    end
  end

  def self.gcovr(report)
    report.fetch('files').to_h do |file|
      lines = file.fetch('lines').reject { |line| line['gcovr/noncode'] || line['gcovr/excluded'] }
      counted = [[lines, 'count'], [file.fetch('functions'), 'execution_count'],
                 [lines.flat_map { |line| line.fetch('branches') }, 'count']]
      [file.fetch('file'), counted.map { |list, count| [list.count { |one| one[count].positive? }, list.size] }]
    end
  end

  def initialize(lcov, gcovr)
    @lcov = lcov
    @gcovr = gcovr
  end

  # One line for each file that they count differently.
  def differences
    (@lcov.keys | @gcovr.keys).sort.reject { |file| @lcov[file] == @gcovr[file] }.map do |file|
      "#{file}: lcov counts #{words(@lcov[file])}, gcovr #{words(@gcovr[file])}"
    end
  end

  def summary
    totals = @lcov.values.transpose.map { |pairs| pairs.transpose.map(&:sum) }
    "lcov and gcovr count the same in #{@lcov.size} files: #{words(totals)}"
  end

  private

  def words(counts)
    return 'nothing' unless counts

    KINDS.zip(counts).map { |kind, (hit, all)| "#{hit} of #{all} #{kind}" }.join(', ')
  end
end

# The reports themselves.
#
# @satisfies SWR-COVER-001
class CoverageReport
  LCOV = %w[lcov --quiet --rc lcov_branch_coverage=1].freeze
  FOLDER = 'build/coverage'
  TRACEFILE = "#{FOLDER}/lcov.info".freeze
  LOG = 'build/log/coverage.log'
  PLACES = %w[core build/gen/charts].freeze
  TESTS = 'core/robot/*/test/*'
  COUNTED = %w[build/gcov/tests build/gcov/core build/gcov/build/gen/charts].freeze
  GCOVR = 'build/gcov/coverage'

  def self.write
    count || abort
    FileUtils.rm_rf(FOLDER)
    FileUtils.mkdir_p([FOLDER, File.dirname(LOG)])
    capture
    call('genhtml', '--quiet', '--branch-coverage', '--title', 'Boresight core', '--prefix', Dir.pwd,
         '--output-directory', FOLDER, TRACEFILE)
    coverage = Coverage.new(Coverage.lcov(File.read(TRACEFILE)),
                            Coverage.gcovr(JSON.parse(File.read("#{GCOVR}/coverage.json"))))
    abort coverage.differences.join("\n") if coverage.differences.any?
    puts coverage.summary, "#{TRACEFILE}, #{FOLDER}/index.html; gcovr's pages: #{GCOVR}/index.html"
  end

  # The core and the compiled charts are the product; each line and each branch of them is tested. A source that no test reaches
  # counts as untested.
  def self.count
    FileUtils.mkdir_p(GCOVR)
    system('gcovr', '-j', Etc.nprocessors.to_s, '--root', '.', '--filter', "^(#{PLACES.join('|')})/",
           '--exclude', "^#{TESTS.gsub('*', '[^/]+')}", '--print-summary', '--fail-under-line', '100', '--fail-under-branch', '100',
           '--json', "#{GCOVR}/coverage.json", '--html-details', "#{GCOVR}/index.html", '--html-title', 'Boresight core', *COUNTED)
  end

  # Counts of the covered sources, with paths that hold on every machine.
  def self.capture
    call(*LCOV, '--capture', *COUNTED.flat_map { |folder| ['--directory', folder] }, '--no-external',
         '--base-directory', '.', '--output-file', TRACEFILE)
    call(*LCOV, '--extract', TRACEFILE, *PLACES.map { |place| "#{Dir.pwd}/#{place}/*" }, '--output-file', TRACEFILE)
    call(*LCOV, '--remove', TRACEFILE, "*/#{TESTS}", '--output-file', TRACEFILE)
    File.write(TRACEFILE, File.read(TRACEFILE).gsub("SF:#{Dir.pwd}/", 'SF:'))
  end

  def self.call(*command)
    system(*command, %i[out err] => [LOG, 'a']) || abort("#{command.first} failed: #{File.readlines(LOG).last}")
  end
end

CoverageReport.write if $PROGRAM_NAME == __FILE__
