# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'stringio'
require 'tmpdir'
require_relative '../../compile/robot_compiler'

# The file of the ProstateRobot, changed in one line, and what the compiler makes of it.
module ProstateFile
  WHOLE = File.read(File.expand_path('../../../core/robot/prostate/robot.yml', __dir__))

  def compile(text)
    Dir.mktmpdir do |directory|
      path = File.join(directory, 'robot.yml')
      File.write(path, text)
      errors = StringIO.new
      status = Robot::Command.run([path, File.join(directory, 'out')], errors: errors)
      [status, errors.string, status.zero? ? File.read(File.join(directory, 'out/robot_prostate.c')) : nil]
    end
  end

  # Refused for this reason in the line that begins with `key`.
  def assert_refused_at(key, text, reason)
    line = WHOLE.lines.index { |one| one.start_with?("#{key}:") } + 1
    status, errors, = compile(text)
    assert_equal 1, status
    assert_match(/robot\.yml:#{line}: .*#{Regexp.escape(reason)}/, errors)
  end
end
