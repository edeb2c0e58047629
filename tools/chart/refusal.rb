# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

module Chart
  # The rules of the chart profile. Numbers are stable: a dropped rule leaves a gap.
  RULES = {
    1 => 'the file is well-formed XML without DTD, CDATA or processing instructions',
    2 => 'only the elements of the profile are used, where the profile allows them',
    3 => 'only the attributes of the profile are used',
    4 => 'every attribute the profile demands is there',
    5 => 'every id is used once',
    6 => 'names are lower-case words joined by underscores, and fit their file',
    7 => 'every target, initial state, raised and sent event exists',
    8 => 'every transition and invariant has its own bs:id',
    9 => 'every transition, leaf state and invariant names its requirements',
    10 => 'every transition waits for an event',
    11 => 'events raised by transitions never lead back to themselves',
    12 => 'a timer is started by entering a state and cancelled by leaving the same state',
    13 => 'In() names a state of the chart',
    14 => 'guards are built from In(), declared inputs, ! && || and parentheses',
    15 => 'a delay equals the limit it names',
    16 => 'a chart is one region, or one parallel of two or more regions',
    17 => 'a transition stays inside its region',
    18 => 'the safe configuration names one leaf of every region',
    19 => 'a chart has at most 32 actions, 32 timers and 6 inputs',
    20 => 'every state is reached',
    21 => 'every transition is taken',
    22 => 'two transitions of one state are never enabled together',
    23 => 'every invariant holds in every reached configuration',
    24 => 'every declared input is read'
  }.freeze

  # A chart outside the profile. The message says where, which rule, and what to write instead.
  class Refusal < StandardError
    attr_reader :file, :line, :rule

    def initialize(file, line, rule, message)
      @file = file
      @line = line
      @rule = rule
      super(format('%<file>s:%<line>d: CHART-R%<rule>02d %<message>s',
                   file: file, line: line, rule: rule, message: message))
    end
  end
end
