# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Runs files of minitest beside each other, each in a process of its own, and leaves the results of all:
#
#   ruby tools/beside.rb COUNT FILE...
#
# COUNT files run at once; they begin in the order in which they are given. This is for tests that mostly wait: for
# a motion, for an answer, for a time that must pass. The output of a file appears when the file has ended.

require 'fileutils'
require 'open3'
require_relative 'results'

# One run of such files.
class Beside
  REPORTER = File.expand_path('test/result_reporter.rb', __dir__)
  # The progress is that of all files; a line of one file must not be taken for it.
  PROGRESS = %r{^(?=\[\d+/\d+\] )}
  LAST_LINES = 25

  def initialize(count, files)
    @count = count
    @files = files
    @name = ENV.fetch(Results::NAME, '')
    @rows = []
    @done = 0
    @lock = Mutex.new
  end

  # True if every file ended well and no test failed.
  #
  # @satisfies SWR-TOOL-090
  def run
    queue = Queue.new(@files.each_with_index.to_a).close
    Array.new(@count) { Thread.new { drain(queue) } }.each(&:join)
    Results.leave(@rows.sort_by { |row| row.values_at(:file, :test) })
    @rows.none? { |row| row[:result] == 'fail' }
  end

  private

  def drain(queue)
    while (file, number = queue.pop)
      part = @name.empty? ? '' : "#{@name}-part-#{number}"
      output, status = Open3.capture2e({ Results::NAME => part }, RbConfig.ruby, REPORTER, file)
      take(file, output.scrub, rows_of(part), status)
    end
  end

  # The results of one file. They leave the folder, which holds one file for each gate.
  def rows_of(part)
    Results.read(part).map { |row| row.transform_keys(&:to_sym) }
  ensure
    FileUtils.rm_f(Results.file(part))
  end

  def take(file, output, rows, status)
    fails = rows.count { |row| row[:result] == 'fail' }
    # A file that could not be loaded, or that ended otherwise than its tests say, has failed as a whole.
    rows << { test: File.basename(file, '.rb'), file: file, result: 'fail', message: output.lines.last(LAST_LINES).join } unless
      status.success? || fails.positive?
    @lock.synchronize do
      @rows.concat(rows)
      puts "#{output.gsub(PROGRESS, '  ')}[#{@done += 1}/#{@files.size}] #{file}"
      $stdout.flush
    end
  end
end

exit(Beside.new(Integer(ARGV.fetch(0), 10), ARGV.drop(1)).run ? 0 : 1) if $PROGRAM_NAME == __FILE__
