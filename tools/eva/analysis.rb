# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'fileutils'
require 'open3'

module Eva
  # What Eva could not rule out. The same text at several places of a function is one alarm; `times` counts the places.
  Alarm = Struct.new(:file, :function, :text, :times, keyword_init: true) do
    def place
      "#{file}: #{function}: #{text}"
    end
  end

  # Frama-C itself ended badly, or without a report.
  class Failed < StandardError; end

  # One run of Eva over some sources, from one function on.
  #
  # @satisfies SWR-TOOL-231
  class Analysis
    HERE = 'verification/eva'
    # Preprocessed by the compiler of the product; Frama-C's own headers stand in for those of a C library.
    MACHINE = ['-load-script', "#{HERE}/cortex_a9.ml,#{HERE}/reached.ml", '-machdep', 'cortex_a9', '-cpp-frama-c-compliant',
               '-cpp-command', 'arm-linux-gnueabihf-gcc -E -C -I.'].freeze
    INCLUDES = "-D__FC_MACHDEP_GCC_X86_32 -include #{HERE}/compiler.h -I#{HERE}/instead -Icore -Ibuild/gen"
    CONTROLLER = %w[core/*/*.c core/*/*/*.c build/gen/charts/*_chart.c build/gen/robot/*.c
                    build/gen/interface/*.c].freeze
    # Below the least precision in time, but each axis, card and command is kept apart from the next: loops over them are
    # unrolled, sets hold the places of two nested indexes, and writes are followed to as many.
    PRECISION = %w[-eva-precision 0 -eva-min-loop-unroll 8 -eva-auto-loop-unroll 12 -eva-ilevel 80 -eva-plevel 400].freeze
    # Functions whose branches are kept apart: a list of rows is judged by several facts at the same time; the entry point, if
    # there is one, is known; a mode that is not known has asked for no drive. Frama-C has numbered their names.
    APART = %w[-eva-slevel-function trajectory_list_add:10,judge:10,judge_0:10,find_scanner_target:4,mode_dispatch_step:20,run:4
               -eva-split-return-function mode_dispatch_step:0].freeze
    # Sources with a function of which the controller sees a contract (instead); sums.c and parts.c include them.
    BY_CONTRACT = %w[core/base/crc.c core/controller/controller_events.c build/gen/charts/axis_chart.c].freeze
    DRIVER = %W[#{HERE}/driver.c #{HERE}/parts.c #{HERE}/state.c #{HERE}/sums.c].freeze
    # Frama-C numbers what has the same name in several files.
    NUMBER = /(?<=\w)_\d+\b/
    # Of a contract as a whole; each call at which it is not seen to hold is an alarm of its own.
    OF_CALLS = 'precondition: '
    # A line that reached.ml prints.
    REACHED = /^\[kernel\] reached: (\S+): (\w+)$/.freeze
    FIGURES = /(\d+) functions analyzed \(out of (\d+)\).*?(\d+) statements reached \(out of (\d+)\)/m

    def self.of_controller(robot)
      new('run_controller', Dir.glob(CONTROLLER).sort - BY_CONTRACT + DRIVER, "build/eva/#{robot}",
          defines: " -include robot/robot_#{robot}.h -DEVA_ROBOT=robot_#{robot}", options: APART)
    end

    attr_reader :alarms

    def initialize(entry, sources, folder, root: '.', defines: '', options: [])
      @entry = entry
      @sources = sources
      @folder = folder
      @root = root
      @defines = defines
      @options = options
    end

    def run
      FileUtils.mkdir_p(@folder)
      before = processor_seconds
      # Frama-C finds its files by what the shell says of where it is.
      @log, status = Open3.capture2e({ 'PWD' => File.realpath(@root) }, *command, chdir: @root)
      @seconds = (processor_seconds - before).round
      File.write("#{@folder}/log.txt", @log)
      raise Failed, "Eva ended badly: #{@log.lines.last(5).join}" unless status.success? && File.exist?(report)

      @alarms = read(File.readlines(report, chomp: true).drop(1))
      self
    end

    # Statements and functions, of those of the program; copies of functions of headers count in each file.
    def reached
      analysed, functions, reached, statements = FIGURES.match(@log).to_a.drop(1).map(&:to_i)
      { functions: [analysed, functions], statements: [reached, statements] }
    end

    # [file, name] of each function that is reached.
    def functions
      @log.scan(REACHED).map { |file, name| [file.delete_prefix('./'), name] }.uniq
    end

    def figures
      reached.map { |what, (part, whole)| "#{part} of #{whole} #{what} reached" }.join(', ') +
        ", #{alarms.size} alarms, #{@seconds} s of a processor"
    end

    private

    def processor_seconds
      times = Process.times
      times.cutime + times.cstime
    end

    def report
      File.expand_path("#{@folder}/alarms.csv")
    end

    def command
      FileUtils.rm_f(report)
      ['frama-c', *MACHINE, "-cpp-extra-args=#{INCLUDES}#{@defines}", *@sources, '-main', @entry, '-eva',
       '-eva-msg-key=-initial-state,-final-states', *PRECISION, *@options, '-then', '-report-no-proven', '-report-csv', report]
    end

    def read(lines)
      rows = lines.map { |line| row(*line.split("\t")) }.reject { |row| row[2].start_with?(OF_CALLS) }.uniq
      rows.group_by { |row| row.take(3) }.map do |(file, function, text), same|
        Alarm.new(file: file, function: function, text: text, times: same.size)
      end.sort_by(&:place)
    end

    def row(folder, file, line, function, kind, _status, property)
      path = File.join(folder, file).delete_prefix("#{File.expand_path(@root)}/").delete_prefix('./')
      [path, function.gsub(NUMBER, ''), "#{kind}: #{property}".gsub(NUMBER, ''), line]
    end
  end
end
