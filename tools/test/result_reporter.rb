# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Leaves the results of a minitest run in build/results/<RESULT_NAME>.json for tools/trace.rb.
# Without RESULT_NAME nothing is written, so that running one file by hand disturbs nothing.
#
#   RESULT_NAME=tools ruby -r ./tools/test/result_reporter.rb \
#     -e 'Dir["tools/test/**/test_*.rb"].sort.each { |file| require "./#{file}" }'

require 'fileutils'
require 'json'
require 'minitest'
require 'pathname'

# Collects one row per test.
class ResultReporter < Minitest::AbstractReporter
  ROOT = Pathname.new(File.expand_path('../..', __dir__))

  def initialize(name)
    super()
    @name = name
    @rows = []
  end

  def record(result)
    @rows << { test: result.name, file: file_of(result), result: verdict(result), assertions: result.assertions }
  end

  def report
    folder = ROOT.join('build', 'results')
    FileUtils.mkdir_p(folder)
    rows = @rows.sort_by { |row| [row[:file], row[:test]] }
    File.write(folder.join("#{@name}.json"), "#{JSON.pretty_generate(rows)}\n")
  end

  private

  def file_of(result)
    Pathname.new(File.expand_path(result.source_location.first)).relative_path_from(ROOT).to_s
  end

  def verdict(result)
    return 'ignore' if result.skipped?

    result.passed? ? 'pass' : 'fail'
  end
end

# Minitest's way to add a reporter.
module Minitest
  def self.plugin_result_file_init(_options)
    name = ENV.fetch('RESULT_NAME', '')
    reporter << ResultReporter.new(name) unless name.empty?
  end

  extensions << 'result_file'
end
