# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'fileutils'
require 'json'
require_relative 'c_header'
require_relative 'c_source'
require_relative 'c_test'
require_relative 'diagram'
require_relative 'parser'
require_relative 'refusal'
require_relative 'static_checks'
require_relative 'table'
require_relative 'walk'
require_relative 'walk_checks'

module Chart
  # A chart that passed every rule, with its walk.
  Compiled = Struct.new(:document, :walk) do
    def self.from(file, text, limits)
      document = Parser.parse(file, text, limits)
      StaticChecks.run(document)
      walk = Walk.new(document).run
      WalkChecks.run(document, walk)
      new(document, walk)
    end
  end

  # The command line: read all charts, then write all files. One refused chart, and nothing is written.
  class Command
    USAGE = 'usage: ruby tools/chart_compiler.rb CHART_FOLDER OUTPUT_FOLDER'

    def self.run(arguments)
      new(*arguments).run
    rescue Refusal, Diagram::Failed => e
      warn e.message
      1
    rescue ArgumentError
      warn USAGE
      2
    end

    def initialize(source, target)
      @source = source
      @target = target
    end

    def run
      charts = Dir[File.join(@source, '*.scxml')].sort.map do |file|
        Compiled.from(file, File.read(file, encoding: 'UTF-8'), limits)
      end
      check_ids_across(charts.map(&:document))
      outputs(charts).each { |path, content| write(path, content) }
      charts.each { |chart| report(chart) }
      0
    end

    private

    # name => value; only the delays of timers are looked up here.
    def limits
      @limits ||= begin
        file = File.join(@target, 'limits', 'limits.json')
        raise Refusal.new(file, 1, 15, 'the file is missing; generate the limits first') unless File.exist?(file)

        JSON.parse(File.read(file)).to_h { |limit| [limit.fetch('name'), limit.fetch('value')] }
      end
    end

    def check_ids_across(documents)
      seen = {}
      documents.each do |document|
        (document.transitions + document.invariants).each do |one|
          if seen.key?(one.id)
            raise Refusal.new(document.file, one.line, 8, "#{one.id} stands in #{seen[one.id]} already; choose another")
          end
          seen[one.id] = document.file
        end
      end
    end

    def outputs(charts)
      charts.each_with_object({}) do |chart, files|
        name = chart.document.name
        files["charts/#{name}_chart.h"] = CHeader.new(chart.document).emit
        files["charts/#{name}_chart.c"] = CSource.new(chart.document).emit
        files["tests/test_#{name}_walk.c"] = CTest.new(chart.document, chart.walk).emit
        files["charts/#{name}.dot"] = Diagram.new(chart.document).dot
        files["charts/#{name}.svg"] = Diagram.svg(files["charts/#{name}.dot"])
      end.merge('charts/charts.json' => Table.emit(charts))
    end

    def write(path, content)
      full = File.join(@target, path)
      FileUtils.mkdir_p(File.dirname(full))
      File.write(full, content)
    end

    def report(chart)
      walk = chart.walk
      puts format('%-15<name>s %3<reached>d configurations, %6<pairs>d pairs', name: chart.document.name,
                                                                            reached: walk.reached.length,
                                                                            pairs: walk.pair_count)
    end
  end
end
