#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Checks the core and the compiled charts with cppcheck and its MISRA C:2012 addon.
#
#   ruby tools/misra.rb [--root FOLDER]
#
# A finding is accepted only by a line of verification/misra/suppressions.txt or by a comment at its
# place, and both name a record of verification/misra/deviations.yml:
#
#   misra-c2012-15.5:*                                       # DEV-001
#   /* cppcheck-suppress misra-c2012-11.3 ; DEV-004 */
#
# Exit 1 on a finding without deviation, on a deviation that accepts nothing, and on a suppression
# without record.

require 'fileutils'
require 'json'
require 'open3'
require 'optparse'
require 'rexml/document'
require 'tmpdir'
require_relative 'trace/requirements'

# One message of cppcheck.
MisraFinding = Struct.new(:rule, :file, :line, :message, keyword_init: true) do
  def to_s
    "#{file}:#{line}: #{rule} #{message}"
  end
end

# A line of suppressions.txt: rule, files and the deviation it rests on.
MisraSuppression = Struct.new(:rule, :pattern, :line, :deviation, :place, keyword_init: true) do
  def matches?(finding)
    File.fnmatch?(rule, finding.rule) && File.fnmatch?(pattern, finding.file) &&
      (line.nil? || line == finding.line)
  end
end

# Runs cppcheck and gives its findings.
class Cppcheck
  # Findings are reported in these places.
  CHECKED = %r{\A(?:core|build/gen/charts|build/gen/robot|build/gen/interface)/(?!app/)}
  # All that belongs to the program; users outside of the core are seen, but not reported on.
  FILES = %w[core/{*,*/*}/*.c build/gen/charts/*.c build/gen/robot/*.c build/gen/interface/*.c].freeze
  USERS = %w[bsp/sim/*.c bsp/sim/*/*.c app/common/*_terms.c app/control/*.c app/http/view/*_availability.c app/replay/*.c app/replay/*/*.c].freeze
  FOLDERS = %w[core app bsp bsp/include build/gen].freeze
  COPIED = %w[core/**/*.{c,h} build/gen/**/*.{c,h} bsp/**/*.{c,h} app/*/*.{c,h} app/*/*/*.{c,h} verification/misra/*.cfg].freeze
  # Messages that would leave a file out.
  UNREAD = %w[syntaxError internalError internalAstError preprocessorErrorDirective cppcheckError].freeze
  # The addon sees the whole program too (ctu); by the system's Python, which comes with cppcheck, kept compiled in a
  # folder of this run.
  ADDON = ["--addon=#{JSON.generate({ script: File.join(__dir__, 'misra_addon.py'), ctu: true })}",
           '--addon-python=/usr/bin/python3'].freeze
  PYTHON = { 'PYTHONDONTWRITEBYTECODE' => nil }.freeze
  # Without its library's headers cppcheck knows the 64-bit constants by value only, and not by type.
  OPTIONS = %w[--enable=warning,style,performance,portability,information --inline-suppr
               --std=c99 --platform=unix64 --xml --quiet --library=verification/misra/contract.cfg
               -DUINT64_C(x)=x##UL -DINT64_C(x)=x##L -DINT64_MIN=(-0x7FFFFFFFFFFFFFFFL-1L)
               --suppress=missingInclude --suppress=missingIncludeSystem --suppress=checkersReport
               --suppress=unusedFunction].freeze

  def initialize(root)
    @root = root
  end

  def files
    @files ||= glob(FILES)
  end

  def findings
    Dir.mktmpdir do |folder|
      errors = REXML::Document.new(run(folder)).get_elements('//error')
      unread = errors.find { |error| UNREAD.include?(error['id']) }
      raise "cppcheck: #{unread['id']}: #{unread['verbose']}" if unread

      errors.filter_map { |error| finding(error, folder) }.uniq
            .sort_by { |found| [found.file, found.line, found.rule] }
    end
  end

  private

  # Works on a copy: cppcheck leaves files beside the sources while it runs.
  def run(folder)
    glob(COPIED).each do |file|
      FileUtils.mkdir_p(File.join(folder, File.dirname(file)))
      FileUtils.cp(File.join(@root, file), File.join(folder, file))
    end
    python = PYTHON.merge('PYTHONPYCACHEPREFIX' => File.join(folder, 'python'))
    _, xml, status = Open3.capture3(python, 'cppcheck', *ADDON, *OPTIONS, *includes, *files, *glob(USERS), chdir: folder)
    raise "cppcheck failed: #{xml[0, 400]}" unless status.success?

    xml
  end

  def glob(patterns)
    patterns.flat_map { |pattern| Dir.glob(pattern, base: @root).sort }
  end

  def includes
    FOLDERS.map { |folder| "-I#{folder}" }
  end

  def finding(error, folder)
    place = error.elements['location']
    return nil unless place && place['file'].match?(CHECKED)

    file = place['file']
    line = place['line'].to_i
    MisraFinding.new(rule: error['id'], file: file, line: line, message: message(error, File.join(folder, file), line))
  end

  # The addon has no texts of the rules, so the line itself is shown.
  def message(error, file, line)
    return error['msg'] unless error['id'].start_with?('misra')

    File.readlines(file)[line - 1].to_s.strip
  end
end

# Compares findings with deviations, both ways.
class MisraCheck
  FIELDS = %w[rule where why risk guard].freeze
  LINE = /\A(?<rule>[^:\s#]+)(?::(?<file>[^:\s#]+))?(?::(?<line>\d+))?\s*(?:#\s*(?<note>.*))?\z/
  INLINE = /cppcheck-suppress(?!ions)/

  attr_reader :problems, :findings

  def initialize(root, findings, files)
    @root = root
    @findings = findings
    @files = files
    @problems = []
    @deviations = read_deviations
    @suppressions = read_suppressions
    @inline = read_inline
    compare
  end

  # Lines of rule, count and what accepts it.
  def table
    counts = findings.group_by(&:rule).map do |rule, list|
      accepted = list.filter_map { |finding| suppression_of(finding)&.deviation }.uniq
      format('  %-24<rule>s %4<count>d  %<by>s', rule: rule, count: list.size, by: accepted.join(' '))
    end
    counts.sort
  end

  private

  def read_deviations
    file = 'verification/misra/deviations.yml'
    items = Trace::Requirements.new([file], @root).items
    items.each do |item|
      missing = FIELDS.select { |field| item[field].to_s.empty? }
      @problems << "#{item.place}: #{item.id} lacks #{missing.join(', ')}" unless missing.empty?
    end
    items.group_by(&:id).each_value do |same|
      same.drop(1).each { |item| @problems << "#{item.place}: #{item.id} is used twice" }
    end
    items
  end

  def read_suppressions
    file = 'verification/misra/suppressions.txt'
    File.readlines(File.join(@root, file), chomp: true).each_with_index.filter_map do |text, index|
      next if text.strip.empty? || text.start_with?('#')

      place = Trace::Place.new(file, index + 1)
      match = LINE.match(text.strip)
      deviation = match && match[:note].to_s[/DEV-\d{3}/]
      @problems << "#{place}: a suppression names no deviation DEV-nnn" unless deviation
      next unless deviation

      MisraSuppression.new(rule: match[:rule], pattern: match[:file] || '*', line: match[:line]&.to_i,
                           deviation: deviation, place: place)
    end
  end

  # Deviations named beside the code. cppcheck itself says when such a comment accepts nothing.
  def read_inline
    sources = @files + Dir.glob('core/**/*.h', base: @root)
    sources.flat_map do |file|
      File.readlines(File.join(@root, file)).each_with_index.filter_map do |line, index|
        next unless line.match?(INLINE)

        place = Trace::Place.new(file, index + 1)
        deviation = line[/DEV-\d{3}/]
        @problems << "#{place}: a suppression names no deviation DEV-nnn" unless deviation
        [deviation, place] if deviation
      end
    end
  end

  def compare
    findings.each { |finding| @problems << finding.to_s unless suppression_of(finding) }
    known = @deviations.map(&:id)
    used = []
    @suppressions.each do |suppression|
      matched = findings.any? { |finding| suppression.matches?(finding) }
      @problems << "#{suppression.place}: accepts nothing any more" unless matched
      used << suppression.deviation if matched
      check_known(known, suppression.deviation, suppression.place)
    end
    @inline.each { |deviation, place| check_known(known, deviation, place) }
    used.concat(@inline.map(&:first))
    @deviations.each { |item| @problems << "#{item.place}: #{item.id} accepts nothing" unless used.include?(item.id) }
  end

  def check_known(known, deviation, place)
    @problems << "#{place}: #{deviation} has no record" unless known.include?(deviation)
  end

  def suppression_of(finding)
    @suppressions.find { |suppression| suppression.matches?(finding) }
  end
end

if $PROGRAM_NAME == __FILE__
  root = '.'
  OptionParser.new { |opts| opts.on('--root FOLDER') { |folder| root = folder } }.parse!
  cppcheck = Cppcheck.new(root)
  abort 'misra: there is nothing to check' if cppcheck.files.empty?
  begin
    check = MisraCheck.new(root, cppcheck.findings, cppcheck.files)
  rescue Trace::FormatError => e
    abort e.message
  end
  puts "misra: #{cppcheck.files.size} files, #{check.findings.size} findings by rule:", check.table
  puts check.problems
  puts "misra: #{check.problems.size} problems"
  exit 1 unless check.problems.empty?
end
