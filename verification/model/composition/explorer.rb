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
  Report = Struct.new(:configurations, :explored, :pairs, :explored_pairs, :told, :digest, :findings)

  ROOT = CompiledChart::ROOT
  HERE = "#{ROOT}/verification/model/composition".freeze
  PARTS = ["#{HERE}/found.c", *Dir["#{ROOT}/core/safety/permit.c"].sort].freeze
  FOLDERS = %w[core build/gen].freeze
  # [kind, source] => file
  OBJECTS = {}
  private_constant :OBJECTS

  def initialize(composition)
    @composition = composition
    @program = CompositionProgram.new(composition)
  end

  # asked: what the controller came into; the block may change the C of a chart and that of the composition.
  def run(folder, kind: 'gcc', asked: [], &mutate)
    @program.write(folder, &mutate)
    explorer = File.join(folder, 'explorer')
    objects = Dir["#{folder}/*_chart.c"].sort.push(*PARTS).map { |source| object(source, folder, kind) }
    compile(kind, '-O3', '-I', folder, "#{HERE}/explorer.c", *objects, '-o', explorer)
    lines = ControllerRun.part(asked, @composition).map { |numbers| "#{numbers.join(' ')}\n" }
    File.write("#{explorer}.asked", lines.join)
    read(*Open3.capture2e(*CompiledChart::KINDS.fetch(kind).last, explorer, "#{explorer}.asked"))
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

  def read(output, status)
    raise CompiledChart::Failed, output unless [0, 1].include?(status.exitstatus)

    *findings, configurations, explored, pairs, explored_pairs, told, digest = output.lines(chomp: true)
    numbers = [configurations, explored, pairs, explored_pairs, told].map { |line| line.split.last.to_i }
    Report.new(*numbers, digest.split.last, findings)
  end
end
