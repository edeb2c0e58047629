# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'fileutils'
require 'open3'
require_relative '../lib/compiled'

# One chart as a program: compiled C with its driver.
class CompiledChart
  # A compiler refused the generated C, or the program ended early.
  class Failed < StandardError; end

  ROOT = File.expand_path('../../..', __dir__)
  FLAGS = %w[-std=c99 -pedantic -Wall -Wextra -Werror -Wconversion -Wsign-conversion -Wshadow -Wswitch-enum -Wcast-qual
             -ffp-contract=off].freeze
  # How to compile and how to run, by the project's names.
  KINDS = {
    'gcc' => [%w[gcc], []],
    'clang' => [%w[clang], []],
    'arm-gcc' => [%w[arm-linux-gnueabihf-gcc -mcpu=cortex-a9 -mfpu=vfpv3-d16 -static], %w[qemu-arm -cpu cortex-a9]],
    'arm-clang' => [%w[clang --target=arm-linux-gnueabihf -mcpu=cortex-a9 -mfpu=vfpv3-d16 -static],
                    %w[qemu-arm -cpu cortex-a9]]
  }.freeze

  # Writes NAME_chart.h, NAME_chart.c and NAME_driver.c of a Chart::Compiled.
  def self.write(folder, chart)
    FileUtils.mkdir_p(folder)
    name = chart.document.name
    files = chart.files.merge("#{name}_driver.c" => chart.driver)
    files.each { |file, text| File.write(File.join(folder, file), text) }
  end

  def self.build(folder, name, kind: 'gcc', optimise: '-O2', warnings: FLAGS)
    program = File.join(folder, "#{name}-#{kind}")
    command = [*KINDS.fetch(kind).first, *warnings, optimise, '-I', folder, '-I', File.join(ROOT, 'core'),
               File.join(folder, "#{name}_chart.c"), File.join(folder, "#{name}_driver.c"),
               '-o', program]
    output, status = Open3.capture2e(*command)
    raise Failed, output unless status.success?

    new(program, kind)
  end

  def initialize(program, kind)
    @program = program
    @kind = kind
  end

  # The answers to a list of commands, one line each.
  def run(commands)
    output, errors, status = Open3.capture3(*KINDS.fetch(@kind).last, @program, stdin_data: "#{commands.join("\n")}\n")
    raise Failed, "#{@program} ended early: #{output.lines.last}#{errors}" unless status.success?

    output.lines(chomp: true)
  end
end
