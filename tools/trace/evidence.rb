# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'json'
require_relative '../origin'
require_relative 'requirements'

module Trace
  # One test that ran, as its runner reported it. doubt: why it shows nothing of this tree, or nil.
  Result = Struct.new(:test, :file, :result, :assertions, :source, :doubt, keyword_init: true) do
    # Ids in the test's name, with underscores or hyphens.
    def requirements
      Trace.ids_in(test)
    end

    def function
      test[/\A\w+/]
    end

    def empty?
      result == 'pass' && assertions == 0
    end

    def passed?
      result == 'pass' && !empty?
    end

    def good?
      passed? && !doubt
    end

    def level
      LEVEL_OF_FILE.find { |pattern, _| file.match?(pattern) }&.last
    end
  end

  # Tests that run the whole controller are integration tests, wherever they stand.
  LEVEL_OF_FILE = { %r{\Averification/(?:integration/|supervise/|bench/|unit/test_controller)} => 'integration',
                    %r{\A(?:verification/unit|core/robot|build/gen/tests)/} => 'unit',
                    %r{\Averification/(?:bound|eva|model|mutants)/} => 'tool',
                    %r{\Averification/proof/} => 'proof',
                    %r{\Averification/} => 'system',
                    %r{\Aapp/console/} => 'console',
                    %r{\Atools/(?:test|chartc)/} => 'tool' }.freeze

  ID_IN_NAME = /SWR[_-]([A-Z0-9]+)[_-](\d+)/

  def self.ids_in(name)
    name.scan(ID_IN_NAME).map { |area, number| "SWR-#{area}-#{number}" }
  end

  # Results of the tests, and whether they were made here of the tree as it stands.
  class Evidence
    # doubts: file => why its results do not count
    attr_reader :results, :doubts

    def initialize(root, files)
      @root = root
      @runs = {}
      @doubts = {}
      @results = files.flat_map { |file| read(file) }
    end

    # Where the results that count come from; the runs of several gates differ in time only.
    def origin
      runs = @runs.except(*@doubts.keys).values
      return { 'tree' => tree } if runs.empty?

      times = runs.map { |run| run['time'] }
      runs.last.except('time').merge('tools' => runs.map { |run| run['tools'] }.reduce(:merge),
                                     'from' => times.min, 'to' => times.max)
    end

    # The same in a few lines, with what does not count.
    def head
      made = origin
      doubtful = @doubts.map { |file, doubt| "not counted: #{file}, #{doubt}" }
      return ["Of #{Origin.tree_of(made)} there are no results.", *doubtful] unless made.key?('machine')

      ["Results of #{Origin.tree_of(made)}, from #{made['from']} to #{made['to']}", "on #{Origin.machine_of(made)}",
       "with #{made['tools'].map { |tool| tool.join(' ') }.join(', ')}", *doubtful]
    end

    private

    def read(file)
      document = JSON.parse(File.read(File.join(@root, file)))
      # Older results are a list without an origin.
      @runs[file], tests = document.is_a?(Array) ? [nil, document] : document.values_at('run', 'tests')
      reason = doubt(@runs[file])
      @doubts[file] = reason if reason
      tests.map { |row| result(row, file, reason) }
    rescue JSON::ParserError, KeyError, TypeError, NoMethodError => e
      raise FormatError, "#{file}:1: no results of tests (#{e.message[0, 80]})"
    end

    def result(row, file, doubt)
      Result.new(test: row.fetch('test'), file: row.fetch('file'), result: row.fetch('result'),
                 assertions: row['assertions'], source: File.basename(file), doubt: doubt)
    end

    def doubt(run)
      return 'for they do not say where they come from' unless run.is_a?(Hash) && run['tree'] && run['checkout']
      return "for they come from another checkout or machine: #{Origin.machine_of(run)}" unless run['checkout'] == checkout
      return if run['tree'] == tree

      "for they were made of #{Origin.tree_of(run)} at #{run['time']}, which is not what stands here"
    end

    def tree
      @tree ||= Origin.tree(@root)
    end

    def checkout
      @checkout ||= Origin.checkout(@root)
    end
  end
end
