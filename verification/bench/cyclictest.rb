# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'etc'
require 'json'
require 'open3'
require 'tempfile'

# The reference for wake-up latency, with the control loop's settings.
class Cyclictest
  LAST_CORE = Etc.nprocessors - 1
  LONGEST_US = 4095 # Longest time of its histogram, as of the loop's.
  QUANTILES = { p50: 0.5, p99: 0.99, p999: 0.999 }.freeze
  # The control process leaves power saving as it is, so cyclictest is started to do the same.
  COMMAND = ['cyclictest', '-m', '-q', '-p80', '-i1000', '-t1', "-a#{LAST_CORE}", '--mainaffinity=0',
             '--default-system', "-h#{LONGEST_US + 1}"].freeze

  # Why it could not run.
  attr_reader :refusal

  # Latencies of so many seconds, in us; nil, with the reason kept, when it is not allowed or not installed.
  def measure(seconds)
    Tempfile.create('cyclictest') do |file|
      output, status = Open3.capture2e(*COMMAND, "-D#{seconds}", "--json=#{file.path}")
      return parse(JSON.parse(File.read(file.path))) if status.success?

      @refusal = output.lines.grep(/\S/).first.to_s.strip
      nil
    end
  rescue Errno::ENOENT
    @refusal = 'cyclictest is not installed'
    nil
  end

  private

  def parse(json)
    thread = json['thread'].values.first
    counts = thread['histogram'].map { |bucket, count| [bucket.to_i, count] }.sort
    QUANTILES.transform_values { |share| quantile(counts, thread['cycles'], share) || thread['max'] }
             .merge(worst: thread['max'], cycles: thread['cycles'])
  end

  # Smallest value that this share of the counts does not exceed; nil when it is beyond the histogram.
  def quantile(counts, total, share)
    wanted = (total * share).ceil
    seen = 0
    counts.find { |_, count| (seen += count) >= wanted }&.first
  end
end
