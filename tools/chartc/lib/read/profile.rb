# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

module Chart
  # What may stand in a chart file: elements, attributes, nesting. A form "parent/child" goes before "child".
  module Profile
    Form = Struct.new(:required, :optional, :children)

    CLAIMS = %w[bs:req bs:hazard].freeze
    STATE = [*CLAIMS, 'bs:ignores'].freeze
    ENTERED = %w[onentry onexit].freeze
    PROPERTIES = %w[bs:invariant bs:response bs:only bs:reachable bs:start bs:damaged].freeze
    SCXML = %w[xmlns xmlns:bs version datamodel name initial bs:safe].freeze

    CHART = %w[bs:internal bs:tick bs:enters bs:req].freeze
    TRANSITION = ['bs:id', 'event', 'target', 'cond', 'type', 'bs:do', *CLAIMS].freeze

    PRODUCT = {
      'scxml' => Form.new(SCXML, CHART, ['state', 'parallel', 'final', 'datamodel', *PROPERTIES]),
      'state' => Form.new(%w[id], ['initial', *STATE], %w[state parallel final history transition onentry onexit]),
      'parallel' => Form.new(%w[id], STATE, %w[state parallel history transition onentry onexit]),
      'final' => Form.new(%w[id], STATE, ENTERED),
      'history' => Form.new(%w[id], %w[type], %w[transition]),
      'history/transition' => Form.new([], %w[target event cond], []),
      'transition' => Form.new([], TRANSITION, %w[raise]),
      'onentry' => Form.new([], %w[bs:do], %w[raise send]),
      'onexit' => Form.new([], %w[bs:do], %w[raise cancel]),
      'raise' => Form.new(%w[event], [], []),
      'send' => Form.new(%w[id event delay bs:limit], %w[bs:kind], []),
      'cancel' => Form.new(%w[sendid], [], []),
      'datamodel' => Form.new([], [], %w[data]),
      'data' => Form.new(%w[id expr], [], []),
      'bs:invariant' => Form.new(%w[expr], ['id', *CLAIMS], []),
      'bs:response' => Form.new(%w[on], ['id', 'from', 'expr', 'does', 'starts', 'stays', *CLAIMS], []),
      'bs:only' => Form.new(%w[on from expr], ['id', *CLAIMS], []),
      'bs:reachable' => Form.new(%w[expr], ['id', 'from', 'steps', *CLAIMS], []),
      'bs:start' => Form.new(%w[expr], ['id', 'does', *CLAIMS], []),
      'bs:damaged' => Form.new(%w[expr], ['id', *CLAIMS], [])
    }.freeze

    # Conformance charts carry nothing of ours and use more of SCXML.
    CONTENT = %w[raise send cancel assign log].freeze
    STATES = %w[state parallel history transition onentry onexit datamodel].freeze
    ENGINE = PRODUCT.merge(
      'scxml' => Form.new(%w[version], [*SCXML, 'binding', *CHART],
                          ['state', 'parallel', 'final', 'initial', 'datamodel', *PROPERTIES]),
      'state' => Form.new([], ['id', 'initial', *STATE], [*STATES, 'final', 'initial']),
      'parallel' => Form.new([], ['id', *STATE], STATES),
      'final' => Form.new([], ['id', *STATE], ENTERED),
      'history' => Form.new([], %w[id type], %w[transition]),
      'initial' => Form.new([], [], %w[transition]),
      'initial/transition' => Form.new([], %w[target bs:do], CONTENT),
      'history/transition' => Form.new([], %w[target event cond bs:do], CONTENT),
      'transition' => Form.new([], TRANSITION, CONTENT),
      'onentry' => Form.new([], %w[bs:do], CONTENT),
      'onexit' => Form.new([], %w[bs:do], CONTENT),
      'send' => Form.new(%w[event], %w[id delay delayexpr target type bs:limit bs:kind], []),
      'assign' => Form.new(%w[location expr], [], []),
      'log' => Form.new([], %w[label expr], []),
      'data' => Form.new(%w[id expr], %w[bs:min bs:max bs:input], [])
    ).freeze

    FORMS = { product: PRODUCT, engine: ENGINE, difference: ENGINE }.freeze

    # Attributes that have one value, or a few.
    PROCESSOR = 'http://www.w3.org/TR/scxml/#SCXMLEventProcessor'
    VALUES = {
      'scxml' => { 'xmlns' => ['http://www.w3.org/2005/07/scxml'], 'xmlns:bs' => ['urn:boresight:chart'],
                   'version' => ['1.0'], 'datamodel' => ['ecmascript'], 'binding' => ['early'] },
      'transition' => { 'type' => %w[external internal] },
      'history' => { 'type' => %w[shallow deep] },
      'send' => { 'target' => ['#_internal'], 'type' => [PROCESSOR] },
      'data' => { 'bs:input' => ['true'] },
      'bs:response' => { 'stays' => ['true'] }
    }.freeze

    NAME = /\A[a-z][a-z0-9]*(?:_[a-z0-9]+)*\z/.freeze
    ID = /\A[A-Z][A-Z0-9]*(?:-[A-Z0-9]+)+\z/.freeze
    DONE = /\Adone\.state\.(.+)\z/.freeze
    # Names of conformance charts, and what a transition of theirs may wait for.
    LOOSE_NAME = /\A[A-Za-z_][\w.:-]*\z/.freeze
    LOOSE_EVENT = /\A(?:\*|[A-Za-z_][\w:-]*(?:\.[\w:-]+)*(?:\.\*|\.)?)\z/.freeze
  end
end
