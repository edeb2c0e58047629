# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'open3'
require_relative '../compiled_chart'
require_relative 'program'

# Runs explorer.c on a composition, by one compiler and processor.
class Explorer
  # findings: differences, violated properties, and what of the asked differs.
  Report = Struct.new(:configurations, :pairs, :told, :digest, :findings, keyword_init: true)

  ROOT = CompiledChart::ROOT
  HERE = 'verification/model/composition'
  INCLUDES = %w[core/base core/card core/permit core/robot build/gen/limits build/gen/robot].push(HERE).freeze

  def initialize(composition)
    @axes = composition.axes
    @program = CompositionProgram.new(composition)
  end

  # asked: lists of numbers as explorer.c reads them; the block may change the C of a chart.
  def run(folder, kind: 'gcc', asked: [], &mutate)
    @program.write(folder, &mutate)
    compiler, runner = CompiledChart::KINDS.fetch(kind)
    explorer = File.join(folder, "explorer-#{kind}")
    call(*compiler, *CompiledChart::FLAGS, '-O2', '-I', folder, *includes(INCLUDES), *Dir["#{folder}/*_chart.c"].sort,
         *Dir["#{ROOT}/core/permit/*.c"], "#{ROOT}/#{HERE}/explorer.c", '-o', explorer)
    File.write("#{explorer}.asked", asked.map { |numbers| "#{numbers.join(' ')}\n" }.join)
    read(*Open3.capture2e(*runner, explorer, "#{explorer}.asked"))
  end

  # What the controller itself comes into, a list of numbers each (controller_run.c); the block may change
  # controller_drive.c.
  def controller_run(folder)
    @program.write(folder)
    drive = File.read("#{ROOT}/core/controller/controller_drive.c")
    File.write("#{folder}/controller_drive.c", block_given? ? yield(drive) : drive)
    call('make', '--no-print-directory', '-C', ROOT, 'build/gcc/libtest-core.a')
    run = File.join(folder, 'controller_run')
    unity = File.join(Gem::Specification.find_by_name('ceedling').gem_dir, 'vendor/unity/src')
    support = %w[core/* bsp/include bsp/sim build/gen/* verification/integration/support verification/unit/support]
    call('gcc', '-std=c99', '-O2', '-I', folder, '-I', unity, *includes(Dir.glob(support, base: ROOT)),
         "#{ROOT}/#{HERE}/controller_run.c", "#{ROOT}/verification/integration/support/rig.c", "#{unity}/unity.c",
         "#{folder}/plan_chart.c", "#{folder}/scanner_chart.c", "#{folder}/controller_drive.c",
         "#{ROOT}/build/gcc/libtest-core.a", '-lm', '-o', run)
    output, status = Open3.capture2e(run, @axes.to_s)
    raise CompiledChart::Failed, output.lines.last unless status.success?

    output.lines.uniq.map { |line| line.split.map(&:to_i) }
  end

  private

  def includes(folders)
    folders.map { |folder| "-I#{File.join(ROOT, folder)}" }
  end

  def call(*command)
    output, status = Open3.capture2e(*command)
    raise CompiledChart::Failed, output unless status.success?
  end

  def read(output, status)
    raise CompiledChart::Failed, output unless [0, 1].include?(status.exitstatus)

    *findings, configurations, pairs, told, digest = output.lines(chomp: true)
    numbers = [configurations, pairs, told].map { |line| line.split.last.to_i }
    Report.new(configurations: numbers[0], pairs: numbers[1], told: numbers[2], digest: digest.split.last,
               findings: findings)
  end
end
