#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Turns core/interface/*.yml, the only source of the messages between the processes, into the files that they are compiled from:
#
#   DIRECTORY       the headers of the core with their documentation, command.c, event.c, mode_list.c, mode_dispatch.c,
#                   interface_layout.h;
#                   segment_fields.h, if a HEADER declares the exchange's segment
#   DIRECTORY/app   names and sentences, what an event's numbers are, the JSON writer and its types for the console, the
#                   columns of boresight-replay, where the fields stand, the columns of a status, the
#                   answers of each command; what HTTP clients may ask: routes, what answers
#                   them, the tables that read requests, and the document for clients, openapi.json; the words of OpenIGTLink
#
#   ruby tools/compile/interface_compiler.rb core/interface build/gen/charts/charts.json build/gen/interface [HEADER...]
#
# The declarations of each HEADER, and of the charts' headers beside CHARTS_JSON, count for the layout too. A wrong file is refused with file and line.

require 'fileutils'
require 'json'
require_relative '../interface/columns'
require_relative '../interface/event_words'
require_relative '../interface/fields'
require_relative '../interface/handlers'
require_relative '../interface/headers'
require_relative '../interface/igtl_words'
require_relative '../interface/json'
require_relative '../interface/layout'
require_relative '../interface/model'
require_relative '../interface/names'
require_relative '../interface/openapi'
require_relative '../interface/request_tables'
require_relative '../interface/route_table'
require_relative '../interface/segment_fields'
require_relative '../interface/typescript'

module Interface
  # The command line.
  module Command
    USAGE = 'usage: ruby tools/compile/interface_compiler.rb FOLDER CHARTS_JSON DIRECTORY [HEADER...]'
    APP = [Names, EventWords, Json, Typescript, Columns, Fields, Statuses::Files, Answers::Files, RequestTables, RouteTable, Handlers,
           Openapi, IgtlWords].freeze

    # Returns the exit status.
    def self.run(arguments, errors: $stderr)
      folder, charts, directory, *headers = arguments
      unless directory
        errors.puts(USAGE)
        return 2
      end
      model = Model.new(folder, leaves(charts))
      write(directory, Headers.new(model).files.merge(Layout.new(model, headers + chart_headers(charts)).files, SegmentFields.new(headers).files))
      write(File.join(directory, 'app'), APP.map { |part| part.new(model).files }.inject(:merge))
      0
    rescue Refused, SystemCallError, JSON::ParserError => e
      errors.puts(e.message)
      1
    end

    # They declare what the charts keep, and lie beside the file of them. One of a chart that is no more does not count.
    def self.chart_headers(charts)
      names = JSON.parse(File.read(charts)).fetch('charts').map { |chart| chart.fetch('name') }
      names.map { |name| File.join(File.dirname(charts), "#{name}_chart.h") }.select { |header| File.exist?(header) }
    end

    # The leaves of each region, at their values.
    def self.leaves(file)
      JSON.parse(File.read(file)).fetch('charts').each_with_object({}) do |chart, regions|
        chart.fetch('regions').each do |region|
          leaves = region.fetch('leaves').sort_by { |leaf| leaf.fetch('value') }
          regions["#{chart.fetch('name')}.#{region.fetch('name')}"] = leaves.map { |leaf| leaf.fetch('id') }
        end
      end
    end

    # A file that has not changed keeps its time, so that nothing is compiled again for it.
    def self.write(directory, files)
      FileUtils.mkdir_p(directory)
      files.each do |name, text|
        file = File.join(directory, name)
        File.write(file, text) unless File.exist?(file) && File.read(file, encoding: 'UTF-8') == text
      end
    end
  end
end

exit Interface::Command.run(ARGV) if $PROGRAM_NAME == __FILE__
