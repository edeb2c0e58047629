# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'tmpdir'
require_relative 'system_test'

# A test of the replay on one recording, made once for all tests of its file: homing is begun and the pedal released.
class StoppedHoming < SystemTest
  # Its bytes.
  def recording
    @@recording ||= begin
      boresight.press_and_command('START_UP')
      boresight.wait_until('an axis is driven') { boresight.moving? }
      begun = boresight.status['cycle']
      boresight.wait_until('it has gone some way') { boresight.status['cycle'] > begun + 1000 }
      boresight.simctl('pedal', 'release')
      boresight.wait_until('the pedal is seen released') { boresight.status['pedal'] == 'released' }
      Process.kill('TERM', boresight.pid)
      boresight.wait_for_end
      File.binread(boresight.recording_files.last)
    end
  end

  # Yields a file with `bytes` in a folder of its own, and the folder.
  def in_file(bytes = recording)
    Dir.mktmpdir do |folder|
      file = File.join(folder, 'from.bsr')
      File.binwrite(file, bytes)
      yield file, folder
    end
  end

  # Output of the replay for it, of which every output is equal.
  def printed(*words)
    text, code = in_file { |file| replay(*words, file) }
    assert_equal 0, code, text
    text
  end
end
