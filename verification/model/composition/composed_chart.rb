# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'composition'

# A composition as one chart in SCXML, for SPIN: each member is a region, the events between the members are raised,
# and a region "world" takes each stimulus with each value of the free inputs.
class ComposedChart
  def initialize(composition)
    @composition = composition
    @documents = composition.members.to_h { |member| [member, member.chart.document] }
  end

  def emit
    regions = @documents.map { |member, document| region(member, document) }
    [opening, '<parallel id="all">', regions, world, '</parallel>', data, properties, '</scxml>'].flatten.join("\n")
  end

  private

  def opening
    tick = @documents.values.filter_map(&:tick_us).first
    %(<scxml xmlns="http://www.w3.org/2005/07/scxml" xmlns:bs="urn:boresight:chart" version="1.0" initial="all" ) +
      %(datamodel="ecmascript" bs:tick="#{tick / 1000}ms" bs:internal="#{internal.join(' ')}">)
  end

  # Everything but the stimuli of the world and the timers.
  def internal
    reported = @documents.flat_map { |member, document| document.events.map { |event| "#{member.name}.#{event}" } }
    expired = @documents.flat_map { |member, document| document.timers.map { |timer| "#{member.name}.#{timer.event}" } }
    reported - expired + conditional.map { |number| "reported.#{number}" } + %w[world.settle world.end]
  end

  def conditional
    @composition.reactions.each_index.select { |number| @composition.reactions[number].condition }
  end

  def region(member, document)
    initial = document.root.initial.targets.map { |state| id(member, state) }.join(' ')
    [%(<state id="#{member.name}.region" initial="#{initial}">),
     document.root.substates.map { |state| state(member, state) }, '</state>']
  end

  def id(member, state)
    "#{member.name}.#{state.id}"
  end

  def state(member, state)
    kind = state.parallel? ? 'parallel' : 'state'
    initial = state.initial && state.kind == :compound ? %( initial="#{id(member, state.initial.targets.first)}") : ''
    [%(<#{kind} id="#{id(member, state)}"#{initial}>), block('onentry', member, state.entry, entered(member, state)),
     block('onexit', member, state.exit, []), state.transitions.map { |one| transition(member, one) },
     state.substates.map { |one| state(member, one) }, "</#{kind}>"]
  end

  def block(name, member, content, reported)
    lines = content.map { |one| piece(member, one) } + raises(reported)
    lines.empty? ? [] : ["<#{name}>", lines, "</#{name}>"]
  end

  def piece(member, content)
    case content
    when Chart::Raise then %(<raise event="#{member.name}.#{content.event}"/>)
    when Chart::Cancel then %(<cancel sendid="#{member.name}.#{content.timer.id}"/>)
    when Chart::Send
      id, event = [content.timer.id, content.timer.event].map { |name| "#{member.name}.#{name}" }
      %(<send id="#{id}" event="#{event}" delay="#{content.timer.delay_us / 1000}ms"/>)
    else ''
    end
  end

  # An event with a condition goes by the world, which decides when it is heard.
  def raises(reactions)
    reactions.map do |reaction|
      event = reaction.condition ? "reported.#{@composition.reactions.index(reaction)}" : reported(reaction)
      %(<raise event="#{event}"/>)
    end
  end

  def reported(reaction)
    member, event = reaction.reported
    "#{member.name}.#{member.stimuli[event]}"
  end

  def entered(member, state)
    reactions(member, 'enters') { |what| what == state.id }
  end

  def reactions(member, trigger)
    @composition.reactions.select { |one| one.member == member && one.trigger == trigger && yield(one.what) }
  end

  def transition(member, one)
    reported = reactions(member, 'does') { |what| one.actions.include?(what) } +
               reactions(member, 'hears') { |what| one.events.include?(what) }
    target = one.targets.empty? ? '' : %( target="#{one.targets.map { |state| id(member, state) }.join(' ')}")
    events = one.events.map { |event| "#{member.name}.#{event}" }.join(' ')
    [%(<transition event="#{events}"#{target}#{guard(member, one)}#{' type="internal"' if one.internal}>),
     one.content.map { |content| piece(member, content) }, raises(reported), '</transition>']
  end

  def guard(member, transition)
    transition.guard ? %( cond="#{text(transition.guard, member)}") : ''
  end

  # An expression of a member, or of the composition, in the names of this chart.
  def text(expression, member = nil, any = nil)
    kind, left, right = expression
    case kind
    when :in then "In('#{member ? "#{member.name}.#{left}" : left}')"
    when :variable then variable(left, member, any)
    when :not then "!(#{text(left, member, any)})"
    else "(#{text(left, member, any)} #{kind == :and ? '&amp;&amp;' : '||'} #{text(right, member, any)})"
    end
  end

  def variable(name, member, any)
    return any if name == 'any'
    return text(@composition.permits.fetch(name)) unless member

    full = "#{member.name}.#{name}"
    given = @composition.inputs[full]
    given ? text(given, nil, plain(full)) : plain(full)
  end

  def plain(name)
    name.tr('.', '_')
  end

  # The values of free inputs are set, and reset when the events raised with them have been heard.
  def world
    ['<state id="world">', @composition.stimuli.each_with_index.map { |one, number| stimulus(one, number) },
     @composition.reactions.each_with_index.map { |one, number| reaction(one, number) },
     '<transition event="world.settle"><raise event="world.end"/></transition>',
     '<transition event="world.end">', @composition.free.map { |name| assign(name, false) }, '</transition>',
     '</state>']
  end

  # A timer's expiry comes by itself.
  def stimulus(stimulus, number)
    return [] unless stimulus.number < stimulus.member.chart.document.events.length

    condition = stimulus.condition ? %( cond="#{text(stimulus.condition)}") : ''
    (0...(1 << stimulus.free.length)).map do |bits|
      values = stimulus.free.each_with_index.map { |name, bit| assign(name, bits[bit] == 1) }
      settle = values.empty? ? [] : ['<raise event="world.settle"/>']
      [%(<transition event="stimulus.#{number}_#{bits}"#{condition}>), values, %(<raise event="#{stimulus.name}"/>),
       settle, '</transition>']
    end
  end

  def assign(name, value)
    %(<assign location="#{plain(name)}" expr="#{value}"/>)
  end

  def reaction(reaction, number)
    return [] unless reaction.condition

    [%(<transition event="reported.#{number}" cond="#{text(reaction.condition)}">),
     %(<raise event="#{reported(reaction)}"/>), '</transition>']
  end

  def data
    ['<datamodel>', @composition.free.map { |name| %(<data id="#{plain(name)}" expr="false"/>) }, '</datamodel>']
  end

  KINDS = { always: 'invariant', response: 'response', only: 'only' }.freeze

  def properties
    @composition.properties.select { |one| KINDS.key?(one.kind) }.map do |one|
      on = one.stimuli.map { |number| event(@composition.stimuli[number]) }.join(' ')
      %(<bs:#{KINDS.fetch(one.kind)} id="#{one.id.tr('.', '-')}"#{%( on="#{on}") unless on.empty?}) +
        %(#{%( from="#{text(one.from)}") if one.from} expr="#{text(one.expression)}"/>)
    end
  end

  def event(stimulus)
    document = stimulus.member.chart.document
    timer = document.timers.find { |one| one.id == stimulus.member.stimuli[stimulus.number] }
    "#{stimulus.member.name}.#{timer ? timer.event : stimulus.member.stimuli[stimulus.number]}"
  end
end
