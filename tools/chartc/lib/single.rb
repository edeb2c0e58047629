# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'optparse'
require_relative 'compiled'
require_relative 'counterexamples'
require_relative 'emit/diagram'
require_relative 'emit/table'
require_relative 'limits'
require_relative 'output'
require_relative 'proves'

module Chart
  # One chart of any project, from the command line: all that its C needs goes into one folder.
  # @satisfies SWR-CHART-036
  class Single
    # The command line asks for what there is not.
    class Misuse < StandardError; end

    # What the code of every chart includes.
    RUNTIME = File.expand_path('../../../core/base', __dir__)
    HEADERS = %w[chart.h contract.h].freeze

    # arguments: FILE --out FOLDER, and what else is said.
    def initialize(arguments)
      @limits = Limits.new({})
      @proves = {}
      @file, *more = options.parse(arguments)
      raise Misuse, 'name one chart' if @file.nil? || more.any?
      raise Misuse, 'name a folder with --out' unless @folder
    rescue OptionParser::ParseError => e
      raise Misuse, e.message
    end

    def run
      Counterexamples.keep(@folder) do
        chart = Compiled.from(@file, File.read(@file, encoding: 'UTF-8'), @limits.values, owners: @limits.owners)
        Output.write(@folder, outputs(chart))
        puts chart.words
      end
      0
    end

    private

    def options
      OptionParser.new do |one|
        one.on('--limits FILE') { |file| @limits = Limits.read(file) }
        one.on('--proves LIST') { |list| @proves = Proves.read(list) }
        one.on('--out FOLDER') { |folder| @folder = folder }
      end
    end

    def outputs(chart)
      name = chart.document.name
      chart.files.merge(chart.tests(proves: @proves), runtime, "#{name}.dot" => Diagram.new(chart.document).dot,
                                                               "#{name}.json" => Table.emit([chart]))
    end

    def runtime
      HEADERS.to_h { |name| ["base/#{name}", File.read(File.join(RUNTIME, name))] }
    end
  end
end
