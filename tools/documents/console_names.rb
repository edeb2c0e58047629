# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Commands whose name an element of the console shows: on a button, or in the line on the last command of the page.
class ConsoleNames
  ELEMENTS = 'app/console/src/**/*.tsx'
  TEST = /\.test\.tsx\z/
  NAMED = /\bcommands\.([A-Z_]+)\b/
  CHOSEN = /"([A-Z_]+)"/ # In an element that takes its command by a name.
  CHOOSES = /\bcommands\[|\bpathOf\(/
  BUTTONS = 'modeButtons'

  def initialize(root, interface)
    @root = root
    @interface = interface
  end

  # By the name of its row in core/interface.
  def shown
    names = texts.flat_map { |text| text.scan(NAMED) + (text.match?(CHOOSES) ? text.scan(CHOSEN) : []) }.flatten
    names += bare if texts.any? { |text| text.include?(BUTTONS) }
    names.uniq
  end

  private

  def texts
    @texts ||= Dir[File.join(@root, ELEMENTS)].grep_v(TEST).map { |file| File.read(file, encoding: 'UTF-8') }
  end

  # Each mode whose command has no payload has a button.
  def bare
    @interface.modes.modes.flat_map { |mode| mode.commands.reject { |command| command.more.key?('payload') } }.map(&:name)
  end
end
