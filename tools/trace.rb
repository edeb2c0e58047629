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
#   E19 known limit that no test shows             E20 requirement of method proof without a passed proof

require 'optparse'
require_relative 'trace/check'
require_relative 'trace/matrix'

module Trace
  # The command line.
  module Command
    BANNER = 'usage: trace.rb check|matrix [--static] [--root FOLDER]'

    class << self
      # The exit code.
      def run(arguments)
        options = { root: '.', static: false }
        command = parser(options).parse(arguments)
        case command
        when ['check'] then check(options)
        when ['matrix'] then matrix(options)
        else refuse(BANNER)
        end
      rescue FormatError => e
        refuse("TRACE-E15 #{e.message}")
      rescue OptionParser::ParseError => e
        refuse("#{e.message}\n#{BANNER}")
      end

      private

      def parser(options)
        OptionParser.new do |opts|
          opts.banner = BANNER
          opts.on('--static') { options[:static] = true }
          opts.on('--root FOLDER') { |folder| options[:root] = folder }
        end
      end

      def project(options)
        Project.new(options[:root], with_results: !options[:static])
      end

      def check(options)
        project = project(options)
        check = Check.new(project)
        findings = options[:static] ? check.static : check.all
        puts findings
        count = project.requirements.of_kind('SWR').size
        puts "trace: #{count} requirements, #{project.results.size} test results, #{findings.size} findings"
        findings.empty? ? 0 : 1
      end

      def matrix(options)
        matrix = Matrix.new(project(options))
        puts matrix.text
        matrix.write(File.join(options[:root], 'build'))
        0
      end

      def refuse(words)
        warn words
        1
      end
    end
  end
end

exit Trace::Command.run(ARGV) if $PROGRAM_NAME == __FILE__
