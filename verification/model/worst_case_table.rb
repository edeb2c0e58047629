# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'fileutils'
require 'yaml'
require_relative 'product_charts'
require_relative 'worst_case'

module WorstCase
  # The rows of all charts; the approved ones are in the same form.
  class Table
    APPROVED = File.join(ROOT, 'verification/model/worst_case.yml')
    WRITTEN = File.join(ROOT, 'build/conformance/worst_case.yml')
    APPROVE = 'make worst-case-approve'
    GATED = %w[x86_instructions x86_check_instructions arm_instructions arm_check_instructions stack_bytes
               ram_bytes].freeze
    HEAD = <<~TEXT
      # SPDX-License-Identifier: Apache-2.0
      # What a chart costs at most, written by `make worst-case`, approved by `#{APPROVE}`.
      # instructions: of NAME_chart_dispatch() for an event, or NAME_chart_advance() where timers expire, from its entry
      #   to its return with all inside, over all `pairs`: every reachable configuration with every stimulus and every
      #   valuation of the inputs. The witness is the first pair that needs so many.
      # check_instructions: of NAME_chart_check(), once a cycle, on a sound chart.
      # x86: counted by callgrind. arm: Cortex-A9, counted by qemu-arm; an instruction that its condition skips counts.
      # stack_bytes: the deepest path through the call graph of the Cortex-A9 code (gcc -fcallgraph-info=su), without
      #   contract_broken(); a bound, for a call in the place of a return needs less. ram_bytes: the struct there.
    TEXT

    def self.approved
      new(YAML.safe_load_file(APPROVED).fetch('charts'))
    end

    # Measures all product charts, writes the table and prints it.
    def self.run
      table = new(ProductCharts::ALL.values.to_h { |chart| [chart.document.name, Measurement.new(chart).row] })
      table.write
      puts table.summary
    end

    attr_reader :rows

    def initialize(rows)
      @rows = rows
    end

    def write
      compilers = Measurement::PROCESSORS.to_h { |processor| [processor, Program.describe(processor)] }
      text = YAML.dump({ 'compilers' => compilers, 'charts' => rows }, line_width: -1)
      FileUtils.mkdir_p(File.dirname(WRITTEN))
      File.write(WRITTEN, HEAD + text.delete_prefix("---\n"))
    end

    # One line per chart.
    def summary
      rows.map do |name, row|
        format('%-15<name>s %4<pairs>d pairs: at most %3<x86>d instructions on x86-64, %3<arm>d on Cortex-A9; ' \
               'stack %3<stack>d, RAM %3<ram>d bytes',
               name: name, pairs: row['pairs'], x86: row['x86_instructions'], arm: row['arm_instructions'],
               stack: row['stack_bytes'], ram: row['ram_bytes'])
      end
    end

    # Figures above those of the approved table, one sentence each.
    def complaints(approved)
      new, gone = [rows.keys - approved.rows.keys, approved.rows.keys - rows.keys]
      lines = new.map { |name| "#{name} is not approved" } + gone.map { |name| "#{name} is approved, but no chart" } +
              (rows.keys - new).flat_map { |name| growths(name, rows[name], approved.rows[name]) }
      lines.map { |line| "#{line}; if it must be, approve it anew: #{APPROVE}" }
    end

    private

    def growths(name, row, approved)
      GATED.select { |key| row.fetch(key) > approved.fetch(key) }.map do |key|
        witness = row[key.sub('instructions', 'witness')]
        where = " (#{witness})" if witness.is_a?(String)
        "#{name}: #{key} grew from #{approved[key]} to #{row[key]}#{where}"
      end
    end
  end
end
