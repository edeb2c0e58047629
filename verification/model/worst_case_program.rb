# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'open3'

module WorstCase
  # A compiler refused the code, a tool stopped, or a call did other than the walk says.
  class Failed < StandardError; end

  ROOT = File.expand_path('../..', __dir__)

  # A chart compiled as in the product, with the program that makes its calls.
  class Program
    # CONFIG of the Makefile.
    CONFIGS = { 'x86' => 'gcc', 'arm' => 'arm' }.freeze

    attr_reader :file, :object, :call_graph

    # Compiler and flags, as the Makefile has them for the charts.
    def self.compiler(processor)
      @compilers ||= {}
      @compilers[processor] ||= reported(processor, '$(CC) $(CFLAGS) $(HARDENED_CORE)')
    end

    # Flags of the linker, the same.
    def self.linked(processor)
      @linked ||= {}
      @linked[processor] ||= reported(processor, '$(LDFLAGS)')
    end

    def self.reported(processor, words)
      execute('make', '-s', '--no-print-directory', '-C', ROOT, "CONFIG=#{CONFIGS.fetch(processor)}",
              "--eval=flags: ; @echo #{words}", 'flags').split
    end

    # Without the warnings: those change no code.
    def self.describe(processor)
      command, *flags = compiler(processor)
      [execute(command, '--version').lines.first.chomp, *flags.grep_v(/\A-(W|pedantic)/)].join(' ')
    end

    def self.execute(*command)
      output, status = Open3.capture2e(*command)
      return output if status.success?

      raise Failed, "#{command.first} gave #{status.exitstatus}: #{output.lines.last(5).join}"
    end

    # The block may change the chart's C before it is compiled.
    def initialize(folder, chart, calls, processor, &change)
      @folder = folder
      @compiler = self.class.compiler(processor)
      @linked = self.class.linked(processor)
      @name = chart.document.name
      @file = path("#{@name}-#{processor}")
      @object = "#{@file}.o"
      write(chart, calls, &change)
      compile
      @call_graph = File.read("#{@file}.ci")
    end

    private

    def write(chart, calls)
      source = chart.source
      source = yield source if block_given?
      File.write(path("#{@name}_chart.c"), source)
      File.write(path("#{@name}_chart.h"), chart.header)
      File.write(path("#{@name}_calls.c"), calls.emit)
    end

    # Writing the call graph changes no code.
    def compile
      command = [*@compiler, '-I', @folder, '-I', File.join(ROOT, 'core')]
      self.class.execute(*command, '-fcallgraph-info=su', '-c', path("#{@name}_chart.c"), '-o', @object)
      self.class.execute(*command, '-O0', '-w', @object, path("#{@name}_calls.c"), *@linked, '-o', @file)
    end

    def path(file)
      File.join(@folder, file)
    end
  end
end
