# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'yaml'

module Eva
  # The alarms that are known, with the reason why each cannot happen, or `open`; by robot, file and function.
  class AlarmList
    FILE = 'verification/eva/alarms.yml'
    HEAD = <<~TEXT
      # SPDX-License-Identifier: Apache-2.0
      # What Eva could not rule out, by robot, file and function: why it cannot happen, or `open`. `N x` stands before a
      # text that is in N places of its function. `ceiling` is how many are open; it may only fall. Written by
      # `make eva-list`, which keeps the reasons; they are written by hand, and each names the lines that it rests on.
    TEXT
    OPEN = 'open'

    def self.read(file)
      new(file, File.exist?(file) ? YAML.safe_load_file(file) : {})
    end

    def initialize(file, content)
      @file = file
      @ceilings = content.fetch('ceiling', {})
      @robots = content.fetch('alarms', {})
    end

    # One line each; none if the alarms are those of the list.
    #
    # @satisfies SWR-TOOL-230
    # @satisfies SWR-TOOL-232
    def problems(robot, alarms)
      found = alarms.map { |alarm| path(alarm) }
      known = paths(robot)
      (found - known.keys).map { |path| "new alarm: #{path.join(': ')}" } +
        (known.keys - found).map { |path| "listed, but gone: #{path.join(': ')}" } +
        known.select { |_, reason| reason.to_s.strip.empty? }.map { |path, _| "without a reason: #{path.join(': ')}" } +
        check_ceiling(robot, known.values.count(OPEN))
    end

    # [file, function] of the open alarms.
    def open_functions(robot)
      paths(robot).select { |_, reason| reason == OPEN }.keys.map { |path| path.take(2) }.uniq
    end

    # By the place of their alarm.
    def reasons(robot)
      paths(robot).reject { |_, reason| reason == OPEN }.transform_keys { |path| path.join(': ') }
    end

    # The alarms found become the list; what is still there keeps its reason.
    def replace(robot, alarms)
      known = paths(robot)
      @robots[robot] = alarms.each_with_object({}) do |alarm, tree|
        file, function, text = path(alarm)
        ((tree[file] ||= {})[function] ||= {})[text] = known.fetch([file, function, text], OPEN)
      end
      @ceilings[robot] = [@ceilings[robot], paths(robot).values.count(OPEN)].compact.min
    end

    def save
      File.write(@file, HEAD + YAML.dump({ 'ceiling' => @ceilings, 'alarms' => @robots }, line_width: -1))
    end

    private

    def path(alarm)
      [alarm.file, alarm.function, alarm.times > 1 ? "#{alarm.times} x #{alarm.text}" : alarm.text]
    end

    def paths(robot)
      @robots.fetch(robot, {}).flat_map do |file, functions|
        functions.flat_map { |function, texts| texts.map { |text, reason| [[file, function, text], reason] } }
      end.to_h
    end

    def check_ceiling(robot, open)
      ceiling = @ceilings.fetch(robot, 0)
      return ["#{open} alarms of #{robot} are open, more than the ceiling of #{ceiling}"] if open > ceiling
      return ["#{open} alarms of #{robot} are open: lower its ceiling from #{ceiling}"] if open < ceiling

      []
    end
  end
end
