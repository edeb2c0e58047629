# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'fileutils'
require 'json'
require_relative 'compiled'
require_relative 'difference'
require_relative 'emit/c/header'
require_relative 'emit/c/source'
require_relative 'emit/console'
require_relative 'emit/diagram'
require_relative 'emit/page'
require_relative 'emit/table'
require_relative 'emit/tests/paths_test'
require_relative 'emit/tests/walk_test'
require_relative 'output'
require_relative 'refusal'

module Chart
  # The command line: read all charts, then write all files. One refused chart, and nothing is written.
  class Command
    USAGE = <<~TEXT
      usage: ruby tools/chart_compiler.rb CHARTS OUTPUT        compile all charts of a folder
             ruby tools/chart_compiler.rb page CHARTS OUTPUT   draw them, and list all that they hold
             ruby tools/chart_compiler.rb diff OLD NEW         what differs in meaning, of folders or files;
                                                               exit code 0: nothing, 1: something, 2: trouble
    TEXT
    LIMITS = 'build/gen/limits/limits.json'
    COUNTEREXAMPLES = 'counterexamples'

    # No chart where some were promised.
    class Nothing < StandardError; end

    def self.run(arguments)
      verb = %w[page diff].include?(arguments.first) ? arguments.first : 'compile'
      paths = verb == 'compile' ? arguments : arguments.drop(1)
      return complain(USAGE, 2) unless paths.length == 2

      new(*paths).public_send(verb)
    rescue Refusal, Diagram::Failed, Nothing => e
      complain(e.message, verb == 'diff' ? 2 : 1)
    rescue SystemCallError => e
      complain(unusable(e), verb == 'diff' ? 2 : 1)
    end

    def self.complain(words, status)
      warn words
      status
    end

    # A file or folder that the system did not give.
    def self.unusable(error)
      "#{error.message[/ - (.+)\z/m, 1]}: #{error.class.new.message}; correct the path, or what stands there"
    end

    def initialize(source, target)
      @source = source
      @target = target
    end

    def compile
      @limits_file = File.join(@target, 'limits', 'limits.json')
      FileUtils.rm_rf(File.join(@target, COUNTEREXAMPLES))
      charts = read
      Output.write(@target, outputs(charts))
      charts.each { |chart| report(chart) }
      0
    rescue Refusal => e
      keep(e.counterexample) if e.counterexample
      raise
    end

    def page
      charts = read
      drawings = charts.to_h { |chart| ["#{chart.document.name}.svg", Diagram.svg(Diagram.new(chart.document).dot)] }
      Output.write(@target, drawings.merge('index.html' => Page.new(charts, Version.worst_case(@source)).emit))
      puts "#{File.join(@target, 'index.html')}: #{charts.length} charts"
      0
    end

    def diff
      versions = [@source, @target].map { |path| files(path) && Version.new(path, limits) }
      versions.flat_map(&:refusals).each { |refusal| puts "refused by today's profile: #{refusal.message}" }
      differences = Difference.of(*versions)
      puts differences.join
      differences.all?(&:none?) ? 0 : 1
    end

    private

    def files(path)
      found = Version.files(path)
      found.empty? ? raise(Nothing, "#{path} is no chart, and no folder with charts") : found
    end

    def read
      charts = files(@source).map do |file|
        Compiled.from(file, File.read(file, encoding: 'UTF-8'), limits, owners: @owners)
      end
      check_ids_across(charts.map(&:document))
      check_names_across(charts.map(&:document))
      charts
    end

    # Beside the message, which tells the same in words.
    def keep(counterexample)
      folder = File.join(@target, COUNTEREXAMPLES)
      Output.write(folder, code(counterexample).merge(counterexample.file_name => counterexample.test))
      warn "#{File.join(folder, counterexample.file_name)}: the list of events as a test of the code beside it, " \
           'which fails as long as that path is open'
    end

    # name => value; only the delays of timers are looked up here. Whose they are is read with them.
    def limits
      @limits ||= begin
        file = @limits_file || LIMITS
        raise Refusal.new(file, 1, 15, 'the file is missing; generate the limits first') unless File.exist?(file)

        listed(file)
      end
    end

    def listed(file)
      rows = JSON.parse(File.read(file))
      @owners = rows.to_h { |limit| [limit.fetch('name'), limit.fetch('requirement')] }
      rows.to_h { |limit| [limit.fetch('name'), limit.fetch('value')] }
    rescue JSON::ParserError
      raise Refusal.new(file, 1, 15, 'the file is no JSON; remove it, and generate the limits anew')
    rescue KeyError => e
      raise Refusal.new(file, 1, 15, "a limit has no \"#{e.key}\"; remove the file, and generate the limits anew")
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

    # Two headers that a file may include must not say the same name.
    def check_names_across(documents)
      seen = {}
      documents.each do |document|
        C::Names.new(document).of_header.each do |name|
          if seen.key?(name)
            raise Refusal.new(document.file, 1, 6, "#{name} comes of #{seen[name]} too; choose another name for " \
                                                   'the chart or its region')
          end
          seen[name] = document.file
        end
      end
    end

    def outputs(charts)
      drawings = {}
      charts.each_with_object({}) do |chart, files|
        name = chart.document.name
        code(chart).each { |file, content| files["charts/#{file}"] = content }
        files["tests/test_#{name}_walk.c"] = WalkTest.new(chart.document, chart.walk).emit
        files["tests/test_#{name}_paths.c"] = PathsTest.new(chart.document, chart.walk).emit
        files["charts/#{name}.dot"] = Diagram.new(chart.document).dot
        files["charts/#{name}.svg"] = drawings[name] = Diagram.svg(files["charts/#{name}.dot"])
      end.merge('charts/charts.json' => Table.emit(charts), 'charts/charts.ts' => Console.emit(charts, drawings))
    end

    # chart: a Compiled, or the counterexample of a refused one.
    def code(chart)
      { "#{chart.document.name}_chart.h" => C::Header.new(chart.document, chart.walk).emit,
        "#{chart.document.name}_chart.c" => C::Source.new(chart.document, chart.walk).emit }
    end

    def report(chart)
      walk = chart.walk
      puts format('%-15<name>s %3<reached>d configurations, %6<pairs>d pairs', name: chart.document.name,
                                                                            reached: walk.reached.length,
                                                                            pairs: walk.pair_count)
    end
  end
end
