# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'fileutils'
require 'json'
require 'open3'

# Runs a file of app/console/e2e once.
module BrowserRun
  FOLDER = File.expand_path('../../../app/console', __dir__)
  REPORT = File.expand_path('../../../build/browser-tests-%s.json', __dir__)

  class << self
    # The verdict of each part by its title. `options` are vitest's.
    def results(file, environment, *options)
      report = format(REPORT, Process.pid)
      words = ['npm', 'run', '--silent', 'e2e', file, '--', "--outputFile.json=#{report}", *options]
      said, = Open3.capture2e(environment, *words, chdir: FOLDER)
      raise "the browser did not run:\n#{said}" unless File.exist?(report)

      parts = JSON.parse(File.read(report)).fetch('testResults').flat_map { |one| one.fetch('assertionResults') }
      parts.to_h { |part| [part.fetch('title'), verdict(part)] }
    ensure
      FileUtils.rm_f(report)
    end

    private

    def verdict(part)
      part.fetch('status') == 'passed' ? 'passed' : "#{part.fetch('status')}: #{part.fetch('failureMessages').join("\n")}"
    end
  end
end

# For a test whose class has the verdicts, `results`.
module BrowserVerdicts
  def assert_parts(requirement)
    parts = self.class.results.select { |title, _| title.start_with?("#{requirement} ") }
    refute_empty parts
    parts.each { |title, verdict| assert_equal 'passed', verdict, title }
  end
end
