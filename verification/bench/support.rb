# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'etc'
require 'fileutils'
require 'json'
require 'open3'
require_relative '../../tools/neighbours'

ROOT = File.expand_path('../..', __dir__)
BENCH_OUT = File.join(ROOT, 'build/bench')
FileUtils.mkdir_p(BENCH_OUT)

# A sentence for people; ends the benchmark.
class BenchFailed < StandardError; end

# Columns of text: the first to the left, numbers to the right.
module Table
  module_function

  def render(head, rows, left: [0])
    cells = [head, *rows].map { |row| row.map { |cell| text(cell) } }
    widths = cells.transpose.map { |column| column.map(&:length).max }
    lines = cells.map { |row| line(row, widths, left) }
    lines.insert(1, widths.map { |width| '-' * width }.join('  ')).join("\n")
  end

  def line(row, widths, left)
    aligned = row.zip(widths).each_with_index.map do |(cell, width), i|
      left.include?(i) ? cell.ljust(width) : cell.rjust(width)
    end
    aligned.join('  ').rstrip
  end

  def text(cell)
    case cell
    when nil then '-'
    when Float then format('%.2f', cell)
    when Integer then cell.to_s.gsub(/(?<=\d)(?=(\d{3})+$)/, ' ')
    else cell.to_s
    end
  end
end

def median(values)
  sorted = values.sort
  sorted[sorted.length / 2]
end

# Computer that it runs on, for the remarks.
def machine
  virtual = File.read('/proc/cpuinfo').match?(/^flags.*\bhypervisor\b/) ? 'a virtual machine' : 'a computer'
  real_time = File.exist?('/sys/kernel/realtime') && File.read('/sys/kernel/realtime').to_i == 1
  "#{virtual} with #{Etc.nprocessors} cores and #{real_time ? 'a real-time' : 'an ordinary'} kernel"
end
