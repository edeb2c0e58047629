# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'compiled'
require_relative 'counterexamples'
require_relative 'difference'
require_relative 'emit/console'
require_relative 'emit/diagram'
require_relative 'emit/page'
require_relative 'emit/table'
require_relative 'limits'
require_relative 'output'
require_relative 'proves'
require_relative 'refusal'
require_relative 'single'

module Chart
  # The command line. A folder of charts is read first, then all files are written: one refused chart, and nothing is.
  # @satisfies SWR-CHART-003
  class Command
    USAGE = <<~TEXT
      usage: chartc FILE --out FOLDER [--limits FILE] [--proves LIST]
                                           compile one chart
             chartc build CHARTS OUTPUT [--proves LIST]
                                           compile all charts of a folder; OUTPUT/limits/limits.json must be there
             chartc page CHARTS OUTPUT     draw them, and list all that they hold
             chartc diff OLD NEW           what differs in meaning, of folders or files;
                                           exit code 0: nothing, 1: something, 2: trouble
      LIST is KIND=ID,KIND=ID: the requirements that generated tests are named after
    TEXT
    VERBS = %w[build page diff].freeze
    LIMITS = 'build/gen/limits/limits.json'

    # No chart where some were promised.
    class Nothing < StandardError; end

    # What the system hands over as bytes is UTF-8, whatever the language of the shell.
    # @satisfies SWR-CHART-042
    def self.run(arguments)
      arguments = arguments.map { |one| one.dup.force_encoding('UTF-8') }
      raise Single::Misuse, 'an argument is not UTF-8' unless arguments.all?(&:valid_encoding?)

      verb, *paths = arguments
      return Single.new(arguments).run unless VERBS.include?(verb)

      proves = verb == 'build' ? take_proves(paths) : {}
      return complain(USAGE, 2) unless paths.length == 2

      new(*paths, proves).public_send(verb)
    rescue OptionParser::ParseError => e
      complain("#{USAGE}#{e.message}", 2)
    rescue Single::Misuse => e
      complain("#{USAGE}#{e.message}", 2)
    rescue Refusal, Diagram::Failed, Nothing => e
      complain(e.message, verb == 'diff' ? 2 : 1)
    rescue SystemCallError => e
      complain(unusable(e), verb == 'diff' ? 2 : 1)
    end

    # Out of the arguments of build.
    def self.take_proves(arguments)
      found = {}
      OptionParser.new { |one| one.on('--proves LIST') { |list| found = Proves.read(list) } }.parse!(arguments)
      found
    end

    def self.complain(words, status)
      warn words
      status
    end

    # A file or folder that the system did not give.
    def self.unusable(error)
      "#{error.message[/ - (.+)\z/m, 1]}: #{error.class.new.message}; correct the path, or what stands there"
    end

    def initialize(source, target, proves)
      @source = source
      @target = target
      @proves = proves
    end

    def build
      @limits_file = File.join(@target, 'limits', 'limits.json')
      Counterexamples.keep(@target) do
        charts = read
        Output.write(@target, outputs(charts))
        puts charts.map(&:words)
      end
      0
    end

    def page
      charts = read
      drawings = charts.to_h { |chart| ["#{chart.document.name}.svg", Diagram.svg(Diagram.new(chart.document).dot)] }
      Output.write(@target, drawings.merge('index.html' => Page.new(charts, Version.worst_case(@source)).emit))
      puts "#{File.join(@target, 'index.html')}: #{charts.length} charts"
      0
    end

    def diff
      versions = [@source, @target].map { |path| files(path) && Version.new(path, limits.values) }
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
        Compiled.from(file, File.read(file, encoding: 'UTF-8'), limits.values, owners: limits.owners)
      end
      check_ids_across(charts.map(&:document))
      check_names_across(charts.map(&:document))
      charts
    end

    # Only the delays of timers are looked up in them.
    def limits
      @limits ||= Limits.read(@limits_file || LIMITS)
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
        chart.files.each { |file, content| files["charts/#{file}"] = content }
        chart.tests(proves: @proves).each { |file, content| files["tests/#{file}"] = content }
        files["charts/#{name}.dot"] = Diagram.new(chart.document).dot
        files["charts/#{name}.svg"] = drawings[name] = Diagram.svg(files["charts/#{name}.dot"])
      end.merge('charts/charts.json' => Table.emit(charts), 'charts/charts.ts' => Console.emit(charts, drawings))
    end
  end
end
