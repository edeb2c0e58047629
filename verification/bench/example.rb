# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'support'
require_relative '../system/support/boresight'

# A recording of our own: homing under the pedal, a registration, targets in and out of reach, and a move.
class Example
  FILE = File.join(BENCH_OUT, 'example.bsr')
  REGISTRATION = '1 0 0 0 0 1 0 0 0 0 1 0'
  # Poses in scanner coordinates, with the registration above: in the workspace, at its border, beyond it.
  TARGETS = ['-0.719331 -0.593747 -0.360594 11.173943 -0.074838 0.582304 -0.809519 225.277747 ' \
             '0.690625 -0.555326 -0.463305 66.443691',
             '-0.719331 -0.593747 -0.360594 11.173943 -0.074838 0.582304 -0.809519 245.277747 ' \
             '0.690625 -0.555326 -0.463305 66.443691',
             '1 0 0 11 0 1 0 300 0 0 1 66'].freeze

  # Returns the file.
  def self.make
    new.make
  end

  def make
    @robot = Boresight.start
    @client = @robot.client
    under_pedal('START_UP')
    ['phase PLANNING', 'phase CALIBRATION', "registration #{REGISTRATION}", 'wait STATUS CALIBRATION',
     'phase TARGETING'].each { |line| say(line) }
    TARGETS.reverse_each { |target| say("target #{target}", 'wait STATUS TARGET') }
    under_pedal('MOVE_TO_TARGET')
    keep_recording
  ensure
    @robot&.kill_all
  end

  private

  # Whether the motion ends well is not our matter: a stop is a cycle like others.
  def under_pedal(phase)
    say("phase #{phase}")
    @robot.simctl('pedal', 'press')
    say("wait STATUS #{phase}")
    @robot.simctl('pedal', 'release')
    @robot.wait_until('the pedal is seen released') { @robot.status['pedal'] == 'released' }
  end

  def say(*lines)
    lines.each do |line|
      @client.write(line)
      nil until @client.read.key?('done')
    end
  end

  def keep_recording
    Process.kill('TERM', @robot.pid)
    @robot.wait_for_end
    FileUtils.cp(@robot.recording_files.last, FILE)
    FILE
  end
end
