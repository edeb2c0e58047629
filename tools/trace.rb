#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Follows requirements up to hazards and down to code, charts and test results.
#
#   ruby tools/trace.rb check [--static] [--root FOLDER]   one line per finding, exit 1 if there is any
#   ruby tools/trace.rb matrix [--root FOLDER]             prints the matrix; build/trace.{json,csv,html}
#
# Findings:
#   E01 unknown id                  E06 test without assertion           E11 risk control without requirement
#   E02 test without requirement    E07 requirement nobody fulfils       E12 hazard without risk control
#   E03 requirement without a       E08 id used twice                    E13 test not executed, result of no test
#       passed test                 E09 unknown parent                   E14 requirement without parent
#   E04 failed test                 E10 not exactly one shall            E15 incomplete or malformed item
#   E05 ignored test                                                     E16 tested only at a smaller level
#   E17 hazard in a chart that the element's       E18 results of another tree, checkout or machine
#       requirements do not control
#   E19 known limit that no test shows

require 'optparse'
require_relative 'trace/check'
require_relative 'trace/matrix'

options = { root: '.', static: false }
parser = OptionParser.new do |opts|
  opts.banner = 'usage: trace.rb check|matrix [--static] [--root FOLDER]'
  opts.on('--static') { options[:static] = true }
  opts.on('--root FOLDER') { |folder| options[:root] = folder }
end

begin
  command = parser.parse(ARGV)
  project = Trace::Project.new(options[:root], with_results: !options[:static])
  case command
  when ['check']
    check = Trace::Check.new(project)
    findings = options[:static] ? check.static : check.all
    puts findings
    count = project.requirements.of_kind('SWR').size
    puts "trace: #{count} requirements, #{project.results.size} test results, #{findings.size} findings"
    exit 1 unless findings.empty?
  when ['matrix']
    matrix = Trace::Matrix.new(project)
    puts matrix.text
    matrix.write(File.join(options[:root], 'build'))
  else
    abort parser.banner
  end
rescue Trace::FormatError => e
  abort "TRACE-E15 #{e.message}"
rescue OptionParser::ParseError => e
  abort "#{e.message}\n#{parser.banner}"
end
