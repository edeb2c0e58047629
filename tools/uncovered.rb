#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Lists the lines and branches of the core and of the compiled charts that no C test reached, by the counts that the programs of
# `ruby tools/c_tests.rb asan` left. Clang counts in the source: neither an optimiser nor a sanitizer adds a branch or hides one.
#
#   ruby tools/uncovered.rb               builds the report build/asan/coverage/coverage.json
#   ruby tools/uncovered.rb REPORT.json   reads this one
#
# Exit 1 if there are any, or if nothing was counted.

require 'fileutils'
require 'json'
require 'open3'

# What a report of llvm-cov says.
#
# @satisfies SWR-TOOL-490
class Uncovered
  PLACES = %r{\A(?:core|build/gen/charts)/}
  TESTS = %r{\Acore/robot/[^/]+/test/}
  # A case beside a default goes where the default goes; the case is counted.
  LABEL = /^\s*case [^:]+:\n\s*default:/
  # Kind of a region that is a macro in use.
  EXPANSION = 1

  # A report has of a file what was executed, and of each function its branches: a function of a header once for each source.
  def initialize(report)
    data = report.fetch('data').first
    @sources = Hash.new { |all, file| all[file] = File.exist?(file) ? File.readlines(file) : [] }
    @lines = data.fetch('files').to_h { |file| [name_of(file['filename']), executed(file.fetch('segments'))] }
    @lines.select! { |file, _lines| counts?(file) }
    @branches = Hash.new { |all, place| all[place] = [0, 0] }
    data.fetch('functions').each { |function| count_branches(function) }
  end

  # One for each line that was not executed or from which a branch was not taken.
  def lines
    untaken = @branches.group_by { |(file, line), _counts| [file, line] }.filter_map do |place, branches|
      missed = branches.sum { |_place, counts| counts.count(&:zero?) }
      [place, "#{missed} of #{branches.size * 2} branches not taken"] if missed.positive?
    end
    unreached = @lines.flat_map { |file, lines| lines.select { |_line, count| count.zero? }.map { |line, _| [[file, line], 'not executed'] } }
    untaken.to_h.merge(unreached.to_h).sort.map { |(file, line), words| "#{file}:#{line}: #{words}" }
  end

  def summary
    "counted: #{@lines.values.sum(&:size)} lines, #{@branches.size * 2} branches in #{@lines.size} files"
  end

  def empty?
    @lines.empty?
  end

  private

  def name_of(file)
    file.delete_prefix("#{Dir.pwd}/")
  end

  def counts?(file)
    file.match?(PLACES) && !file.match?(TESTS)
  end

  # Count of each line where something begins that is counted.
  def executed(segments)
    begun = segments.select { |_line, _column, _count, has_count, _is_entry, is_gap| has_count && !is_gap }
    begun.group_by(&:first).transform_values { |list| list.map { |segment| segment[2] }.min }
  end

  # A branch in a macro is one of each place where the macro is used.
  def count_branches(function)
    files = function.fetch('filenames').map { |file| name_of(file) }
    uses = function.fetch('regions').select { |region| region[7] == EXPANSION }.to_h { |region| [region[6], region] }
    function.fetch('branches').each do |branch|
      place = [branch[0..3]]
      file = branch[6]
      while (use = uses[file])
        place.unshift(use[0..3])
        file = use[5]
      end
      add(files[file], place, branch[4..5])
    end
  end

  def shared_default?(file, line)
    @sources[file].values_at(line - 2, line - 1).join.match?(LABEL)
  end

  def add(file, place, counts)
    return if !counts?(file) || shared_default?(file, place.first.first)

    known = @branches[[file, place.first.first, place]]
    counts.each_with_index { |count, index| known[index] += count }
  end
end

# The report of the programs that have run.
class CountedRun
  FOLDER = 'build/asan/coverage'
  REPORT = "#{FOLDER}/coverage.json".freeze
  CORE = "#{FOLDER}/core".freeze
  COUNTS = "#{FOLDER}/core.profdata".freeze
  # The whole core, as a source that no test reaches counts too; it never runs.
  LINK = %w[clang-19 -fuse-ld=gold -nostdlib -Wl,-e,0 -Wl,--unresolved-symbols=ignore-all -Wl,--whole-archive build/asan/libcore.a].freeze
  # A test may call a function of a header that the core itself does not call.
  TESTS = 'build/asan/tests/*.o'

  def self.write
    FileUtils.mkdir_p(FOLDER)
    call('llvm-profdata-19', 'merge', '-sparse', *Dir['build/asan/profiles/*.profraw'], '-o', COUNTS)
    call(*LINK, '-o', CORE)
    tests = Dir[TESTS].select { |object| counted?(object) }.flat_map { |object| ['-object', object] }
    File.write(REPORT, call('llvm-cov-19', 'export', '-format=text', "-instr-profile=#{COUNTS}", CORE, *tests))
    REPORT
  end

  def self.counted?(object)
    File.binread(object).include?('__llvm_covmap')
  end

  def self.call(*command)
    output, errors, status = Open3.capture3(*command)
    status.success? ? output : abort("#{command.first} failed: #{errors}")
  end
  private_class_method :counted?, :call
end

if $PROGRAM_NAME == __FILE__
  uncovered = Uncovered.new(JSON.parse(File.read(ARGV.first || CountedRun.write)))
  lines = uncovered.lines
  puts lines, uncovered.summary, "uncovered: #{lines.size} lines"
  exit(lines.empty? && !uncovered.empty? ? 0 : 1)
end
