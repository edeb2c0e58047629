# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'open3'
require 'tempfile'
require_relative 'controller_run'
require_relative 'program'

# Runs explorer.c on a composition, by one compiler and processor.
class Explorer
  # explored, explored_pairs: so many stood for all. findings: differences, violated properties, and what of the asked
  # differs.
  Report = Struct.new(:configurations, :explored, :pairs, :explored_pairs, :reported, :digest, :findings)

  ROOT = CompiledChart::ROOT
  HERE = "#{ROOT}/verification/model/composition".freeze
  PARTS = ["#{HERE}/found.c", *Dir["#{ROOT}/core/safety/permit.c"].sort].freeze
  FOLDERS = %w[core build/gen].freeze
  # Its tables of some hundred megabytes are read in no order: in large pages fewer addresses are looked up.
  LARGE_PAGES = { 'GLIBC_TUNABLES' => 'glibc.malloc.hugetlb=1' }.freeze
  # [kind, source] => file
  OBJECTS = {}
  private_constant :OBJECTS

  def initialize(composition)
    @composition = composition
    @program = CompositionProgram.new(composition)
  end

  # asked: what the controller came into; wanted: a finding after which nothing more is explored, and the report has no
  # numbers; the block may change the C of a chart and that of the composition.
  def run(folder, kind: 'gcc', asked: [], wanted: nil, &mutate)
    @program.write(folder, &mutate)
    explorer = File.join(folder, 'explorer')
    objects = Dir["#{folder}/*_chart.c"].sort.push(*PARTS).map { |source| object(source, folder, kind) }
    compile(kind, '-O3', '-I', folder, "#{HERE}/explorer.c", *objects, '-o', explorer)
    lines = ControllerRun.part(asked, @composition).map { |numbers| "#{numbers.join(' ')}\n" }
    File.write("#{explorer}.asked", lines.join)
    report(*explored([*CompiledChart::KINDS.fetch(kind).last, explorer, "#{explorer}.asked"], wanted))
  end

  private

  # The same code is compiled once.
  def object(source, folder, kind)
    file = OBJECTS[[kind, File.read(source)]] ||= Tempfile.new(%w[explorer .o]).tap do |object|
      compile(kind, '-O2', '-I', folder, '-c', source, '-o', object.path)
    end
    file.path
  end

  def compile(kind, *arguments)
    includes = FOLDERS.map { |folder| "-I#{ROOT}/#{folder}" }
    call(*CompiledChart::KINDS.fetch(kind).first, *CompiledChart::FLAGS, *includes, '-I', HERE, *arguments)
  end

  def call(*command)
    output, status = Open3.capture2e(*command)
    raise CompiledChart::Failed, output unless status.success?
  end

  # Its lines, and how it ended; nil if it was not let to its end.
  def explored(command, wanted)
    Open3.popen2e(LARGE_PAGES, *command) do |_input, output, process|
      lines = []
      output.each_line(chomp: true) do |line|
        lines << line
        next unless wanted&.match?(line)

        Process.kill('KILL', process.pid)
        return [lines, nil]
      end
      [lines, process.value.exitstatus]
    end
  end

  def report(lines, exit_code)
    return Report.new(*[nil] * 6, lines) unless exit_code
    raise CompiledChart::Failed, lines.join("\n") unless [0, 1].include?(exit_code)

    *findings, configurations, explored, pairs, explored_pairs, reported, digest = lines
    numbers = [configurations, explored, pairs, explored_pairs, reported].map { |line| line.split.last.to_i }
    Report.new(*numbers, digest.split.last, findings)
  end
end
