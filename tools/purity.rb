#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Compiles the core and shows that it holds nothing that can fail unseen: no call out of the core but
# memcpy, memset, memcmp and contract_broken; no object that is not constant; no floating point; no
# recursion, direct or through other functions.
#
#   ruby tools/purity.rb [--root FOLDER]

require 'open3'
require 'optparse'
require 'tmpdir'
require 'tsort'

# Functions and whom they call.
class CallGraph
  include TSort

  def initialize(edges)
    @edges = edges.group_by(&:first).transform_values { |pairs| pairs.map(&:last).uniq.sort }
  end

  def cycles
    each_strongly_connected_component.select { |group| group.size > 1 || calls(group.first).include?(group.first) }
                                     .map(&:sort)
  end

  private

  def calls(function)
    @edges.fetch(function, [])
  end

  def tsort_each_node(&block)
    (@edges.keys | @edges.values.flatten).sort.each(&block)
  end

  def tsort_each_child(function, &block)
    calls(function).each(&block)
  end
end

# Finds what the core must not hold.
#
# @satisfies SWR-CORE-001
class Purity
  ALLOWED = %w[memcpy memset memcmp contract_broken].freeze
  FILES = %w[core/{*,*/*}/*.c build/gen/charts/*.c build/gen/robot/*.c build/gen/interface/*.c].freeze
  FOLDERS = %w[core build/gen].freeze
  # Without optimisation no call is folded away; without vector registers floating point is refused.
  FLAGS = %w[-std=c99 -O0 -mgeneral-regs-only -fcallgraph-info -c].freeze
  CONSTANT = /\A[TtRrU]\z/
  NOISE = %r{/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"}m

  def initialize(root)
    @root = root
  end

  def files
    @files ||= glob(FILES)
  end

  def problems
    Dir.mktmpdir do |folder|
      broken = files.each_with_index.filter_map { |file, index| compile(file, File.join(folder, "#{index}.o")) }
      return broken unless broken.empty?

      foreign_symbols(folder) + mutable_objects(folder) + recursions(folder) + floats
    end
  end

  private

  def glob(patterns)
    patterns.flat_map { |pattern| Dir.glob(pattern, base: @root).sort }
  end

  def compile(file, object)
    includes = FOLDERS.map { |folder| "-I#{folder}" }
    output, status = Open3.capture2e('gcc', *FLAGS, *includes, '-o', object, file, chdir: @root)
    "#{file}: #{output.lines.grep(/error/).first.to_s.strip}" unless status.success?
  end

  # Name of the file, kind and name of each symbol.
  def symbols(folder)
    @symbols ||= files.each_with_index.flat_map do |file, index|
      lines, = Open3.capture2('nm', '--format=posix', File.join(folder, "#{index}.o"))
      lines.lines.map { |line| [file, *line.split.first(2).reverse] }
    end
  end

  def foreign_symbols(folder)
    own = symbols(folder).reject { |_, kind, _| kind == 'U' }.map(&:last)
    symbols(folder).select { |_, kind, name| kind == 'U' && !own.include?(name) && !ALLOWED.include?(name) }
                   .map { |file, _, name| "#{file}: calls #{name}, which is not of the core" }
  end

  def mutable_objects(folder)
    symbols(folder).reject { |_, kind, _| kind.match?(CONSTANT) }
                   .map { |file, _, name| "#{file}: #{name} is an object that can be changed" }
  end

  def recursions(folder)
    edges = Dir.glob(File.join(folder, '*.ci')).sort.flat_map do |file|
      File.read(file).scan(/edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"/)
    end
    CallGraph.new(edges).cycles.map { |group| "#{group.join(' and ')}: recursion" }
  end

  def floats
    (files + glob(%w[core/{*,*/*}/*.h build/gen/{charts,interface}/*.h])).flat_map do |file|
      text = File.read(File.join(@root, file), encoding: 'UTF-8').gsub(NOISE) { |noise| noise.gsub(/[^\n]/, ' ') }
      text.lines.each_with_index.filter_map do |line, index|
        "#{file}:#{index + 1}: floating point" if line.match?(/\b(?:float|double)\b|\b\d+\.\d/)
      end
    end
  end
end

if $PROGRAM_NAME == __FILE__
  root = '.'
  OptionParser.new { |opts| opts.on('--root FOLDER') { |folder| root = folder } }.parse!
  purity = Purity.new(root)
  abort 'purity: there is nothing to check' if purity.files.empty?
  problems = purity.problems
  puts problems, "purity: #{purity.files.size} files, #{problems.size} problems"
  exit 1 unless problems.empty?
end
