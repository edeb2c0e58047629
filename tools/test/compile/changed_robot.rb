# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'minitest/mock'
require 'stringio'
require 'tmpdir'
require_relative '../../compile/robot_compiler'

# The file of the NeuroRobot with a change, and what the compiler makes of it.
module ChangedRobot
  ROBOT = File.expand_path('../../../core/robot/neuro/robot.yml', __dir__)
  WHOLE = File.read(ROBOT)
  TEXT = WHOLE.sub(/^poses:\n(?:  .*\n)+/, '') # Poses are added where they are looked at.

  def compile(text)
    Dir.mktmpdir do |directory|
      path = File.join(directory, 'robot.yaml')
      File.binwrite(path, text)
      errors = StringIO.new
      status = Robot::Command.run([path, File.join(directory, 'out')], errors: errors)
      table = File.join(directory, 'out', 'robot_neuro.c')
      @header = File.join(directory, 'out', 'robot_neuro.h').then { |header| File.read(header) if File.exist?(header) }
      return [status, errors.string.gsub("#{directory}/", ''), File.exist?(table) ? File.read(table) : nil]
    end
  end

  # Refused with this message; the line is that of the first line with `at` (after the axis `axis`, if given).
  def assert_refused(text, message, at: nil, axis: nil, line: nil)
    status, errors, table = compile(text)
    line ||= line_of(text, at, axis)
    assert_equal "robot.yaml:#{line}: #{message}\n", errors
    assert_equal 1, status
    assert_nil table
  end

  def line_of(text, part, axis)
    lines = text.lines
    start = axis ? lines.index { |line| line.include?("- name: #{axis}\n") } : 0
    start + lines[start..].index { |line| line.include?(part) } + 1
  end

  # The file with the first `before` (after the axis `axis`, if given) replaced.
  def with(before, after, axis: nil)
    head, mark, tail = axis ? TEXT.partition("- name: #{axis}\n") : ['', '', TEXT]
    refute_nil tail.index(before), "no #{before} in the file"
    head + mark + tail.sub(before) { after }
  end

  def limits_of_neuro
    Robot::Kinematics.new('neuro').coupled_limits
  end

  # As if the kinematics had said so.
  def with_coupled_limits(limits, &block)
    found = Robot::Kinematics.method(:new)
    changed = lambda do |*arguments|
      found.call(*arguments).tap { |one| one.instance_variable_get(:@parts)['coupled_limits'] = limits }
    end
    Robot::Kinematics.stub(:new, changed, &block)
  end
end
