# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'fileutils'
require 'json'
require_relative 'compiled'
require_relative 'difference'
require_relative 'emit/c/header'
require_relative 'emit/c/source'
require_relative 'emit/diagram'
require_relative 'emit/page'
require_relative 'emit/table'
require_relative 'emit/tests/walk_test'
require_relative 'refusal'

module Chart
  # The command line: read all charts, then write all files. One refused chart, and nothing is written.
  class Command
    USAGE = <<~TEXT
      usage: ruby tools/chart_compiler.rb CHART_FOLDER OUTPUT_FOLDER        compile all charts of a folder
             ruby tools/chart_compiler.rb page CHART_FOLDER OUTPUT_FOLDER   draw them, and list all that they hold
             ruby tools/chart_compiler.rb diff OLD_FOLDER NEW_FOLDER        what differs in meaning
    TEXT
    LIMITS = 'build/gen/limits/limits.json'

    def self.run(arguments)
      verb = %w[page diff].include?(arguments.first) ? arguments.first : 'compile'
      folders = verb == 'compile' ? arguments : arguments.drop(1)
      return complain(USAGE, 2) unless folders.length == 2

      new(*folders).public_send(verb)
    rescue Refusal, Diagram::Failed => e
      complain(e.message, 1)
    end

    def self.complain(words, status)
      warn words
      status
    end

    def initialize(source, target)
      @source = source
      @target = target
    end

    def compile
      @limits_file = File.join(@target, 'limits', 'limits.json')
      charts = read(@source)
      outputs(charts).each { |path, content| write(path, content) }
      charts.each { |chart| report(chart) }
      0
    end

    def page
      charts = read(@source)
      charts.each { |chart| write("#{chart.document.name}.svg", Diagram.svg(Diagram.new(chart.document).dot)) }
      write('index.html', Page.new(charts, nil).emit)
      puts "#{File.join(@target, 'index.html')}: #{charts.length} charts"
      0
    end

    def diff
      puts Difference.of_folders(read(@source), read(@target))
      0
    end

    private

    def read(folder)
      charts = Dir[File.join(folder, '*.scxml')].sort.map do |file|
        Compiled.from(file, File.read(file, encoding: 'UTF-8'), limits)
      end
      check_ids_across(charts.map(&:document))
      charts
    end

    # name => value; only the delays of timers are looked up here.
    def limits
      @limits ||= begin
        file = @limits_file || LIMITS
        raise Refusal.new(file, 1, 15, 'the file is missing; generate the limits first') unless File.exist?(file)

        JSON.parse(File.read(file)).to_h { |limit| [limit.fetch('name'), limit.fetch('value')] }
      end
    end

    def check_ids_across(documents)
      seen = {}
      documents.each do |document|
        (document.transitions + document.properties).each do |one|
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
        files["charts/#{name}_chart.h"] = C::Header.new(chart.document, chart.walk).emit
        files["charts/#{name}_chart.c"] = C::Source.new(chart.document, chart.walk).emit
        files["tests/test_#{name}_walk.c"] = WalkTest.new(chart.document, chart.walk).emit
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
