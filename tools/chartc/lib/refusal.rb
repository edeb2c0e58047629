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
    7 => 'a chart waits for an event, and every target, initial state, raised, sent, ignored, internal and entering event exists',
    8 => 'every transition and property has its own id',
    9 => 'every transition, leaf state and property names its requirements',
    11 => 'every macrostep ends: no chain of eventless transitions or raised events leads back to itself',
    12 => 'a timer is started by entering a state and cancelled by leaving the same state',
    13 => 'In() names a state of the chart',
    14 => 'expressions are built from In(), declared data, integers, ! && || comparisons, + - and parentheses',
    15 => 'a delay is constant and equals the limit it names',
    18 => 'the safe configuration names one leaf of every region',
    19 => 'a chart has at most 400 states in 200,000 configurations, 64 regions, 32 actions, 32 timers and 7 inputs, ' \
          'and nests at most 32 deep',
    20 => 'every state is reached',
    21 => 'every transition is taken',
    22 => 'two transitions of one state are never enabled together',
    23 => 'every invariant holds in every reached configuration',
    24 => 'every declared input is read',
    25 => 'every event in every configuration is taken, or declared to be ignored there',
    26 => 'every declared ignore is needed',
    27 => 'the guard of an eventless transition reads states and data, not inputs',
    28 => 'several targets lie in different regions of one parallel',
    29 => 'a history has one default transition without event and guard, to a state of its parent',
    30 => 'a transition to a history starts outside the parent of the history',
    32 => 'a timer says how it rounds, lasts at least one tick and at most 4,294,967,295 microseconds',
    33 => 'a timer is not started again while it runs',
    34 => 'an assigned value stays inside the range of its variable',
    35 => 'every guard is seen true and false where its event arrives',
    36 => 'every response holds after every step that it speaks of',
    37 => 'every step between the states of a bs:only is by one of its events',
    38 => 'every bs:reachable configuration is reached in its number of steps',
    39 => 'the limit of a delay belongs to a requirement that its state names',
    40 => 'every bs:start holds of the configuration that the chart starts in',
    41 => 'every bs:damaged holds of the configuration that a damaged chart goes to',
    42 => 'an event of bs:enters enters a state, and one leaf says from where'
  }.freeze

  # A chart outside the profile. The message says where, which rule, and what to write instead.
  class Refusal < StandardError
    # counterexample: the Counterexample, where one shows what is wrong, else nil.
    attr_reader :file, :line, :rule, :counterexample

    def initialize(file, line, rule, message, counterexample: nil)
      @file = file
      @line = line
      @rule = rule
      @counterexample = counterexample
      super(format('%<file>s:%<line>d: CHART-R%<rule>02d %<message>s',
                   file: file, line: line, rule: rule, message: message))
    end
  end
end
