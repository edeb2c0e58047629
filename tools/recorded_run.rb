# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'open3'

# Results of boresight-replay on all recordings of the run in a folder, for a demonstration or a report.
#
# @satisfies SWR-DEMO-003
# @satisfies SWR-CHECK-014
class RecordedRun
  # The last time: that every output is equal, or why not; otherwise what is missing.
  attr_reader :said

  # `replay` is the program.
  def initialize(folder, replay)
    @folder = folder
    @replay = replay
  end

  # Whether every output of the whole run is equal.
  def replay
    @said, status = Open3.capture2e(@replay, @folder)
    status.success?
  end

  # Writes its motion to the file `csv`; whether it is that of the whole run.
  def write_table(csv)
    File.open(csv, 'w') { |file| print('--table') { |rows| IO.copy_stream(rows, file) } }
  end

  # Yields each line of its intervals; whether they are those of the whole run.
  def each_interval(&)
    print('--loop') { |rows| rows.each_line(&) }
  end

  private

  def print(option)
    Open3.popen3(@replay, option, @folder) do |_, rows, notes, process|
      said = Thread.new { notes.read }
      yield rows
      @said = said.value
      process.value.success?
    end
  end
end
