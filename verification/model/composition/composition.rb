# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'yaml'
require_relative '../product_charts'
require_relative 'exchange'
require_relative 'shape'

# composition.yml with every axis written out and every name resolved.
class Composition
  # composition.yml cannot be read, says what means nothing, or names what does not exist.
  class Wrong < StandardError; end

  FILE = File.join(ProductCharts::ROOT, 'statecharts/composition.yml')
  TRIGGERS = %w[enters does hears].freeze

  # configurations: the snapshots that the chart's own walk reaches; stimuli: its events, then its timers.
  Member = Struct.new(:name, :chart, :configurations, :stimuli)
  # number: of the member's stimulus; condition: expression or nil; free: names "member.input" that it may come to read.
  Stimulus = Struct.new(:name, :member, :number, :condition, :free)
  # trigger: one of TRIGGERS; what: the id of a state, an action or an event; of: the axis whose it is alone, or nil.
  Reaction = Struct.new(:member, :trigger, :what, :reported, :condition, :of)
  # kind as in Chart::Property; stimuli: numbers.
  Property = Struct.new(:id, :kind, :stimuli, :from, :expression, :steps)

  # permits: name => expression; facts, reasons: of each axis, name => expression.
  attr_reader :axes, :charts, :members, :permits, :inputs, :reactions, :stimuli, :facts, :common_facts, :reasons,
              :properties, :free, :exchange

  # commands: with what the section of that name adds.
  def initialize(axes: nil, file: FILE, commands: false, exchange: Exchange)
    @rows = rows(file, commands)
    @axes = axes || @rows.fetch('axes')
    read_members
    @permits = (1..@axes).to_h { |axis| ["permit_#{axis}", expression(number(@rows.fetch('permit'), axis))] }
    @inputs = spread(@rows.fetch('inputs')).to_h { |name, text| [input(name), expression(text, %w[any])] }
    @reactions = spread_rows('reactions').flat_map { |row| reaction(row) }
    @free = free_inputs
    @stimuli = spread_rows('stimuli').map { |row| stimulus(*resolve(row.fetch('send')), row['when']) } + expiries
    @common_facts = @rows.fetch('facts').fetch('common').keys
    @facts = of_each_axis('facts')
    @reasons = of_each_axis('reasons')
    @properties = @rows.fetch('properties').flat_map { |row| copies(row) }.map { |row| property(row) }
    @exchange = exchange.new(self)
  end

  def member(name)
    members.find { |member| member.name == name } || raise(Wrong, "there is no member #{name}")
  end

  private

  # Common expressions of each axis, and its own.
  def of_each_axis(section)
    (1..@axes).map do |axis|
      @rows.fetch(section).values.reduce(:merge).transform_values { |text| expression(number(text, axis)) }
    end
  end

  def rows(file, commands)
    rows = YAML.safe_load_file(file)
    raise Wrong, 'the file holds no sections' unless rows.is_a?(Hash)

    more = rows.delete('commands')
    CompositionShape.check(rows, Wrong)
    rows = merged(rows, more) if commands
    CompositionShape.check(rows, Wrong)
    rows
  rescue Psych::Exception => e
    raise Wrong, e.message
  end

  # A hash has what both have, a row the place of one of its name; what is no collection is the later.
  def merged(one, other)
    case other
    when Hash then !one.is_a?(Hash) ? other : one.merge(other) { |_key, before, after| merged(before, after) }
    when Array
      return other unless [*one, *other].all?(Hash) && one.is_a?(Array)

      one.reject { |row| named(row) && other.any? { |late| named(late) == named(row) } } + other
    else other
    end
  end

  def named(row)
    row['id'] || (row['send'] unless row.key?('after'))
  end

  def read_members
    @charts = @rows.fetch('members').values.uniq.to_h { |file| [file, chart(File.join(ProductCharts::ROOT, file))] }
    @members = spread(@rows.fetch('members')).map do |name, file|
      chart = @charts.fetch(file)
      stimuli = chart.document.events + chart.document.timers.map(&:id)
      Member.new(name, chart, chart.walk.reached.keys, stimuli)
    end
  end

  def chart(file)
    ProductCharts::ALL.fetch(file) { Chart.compile(file, ProductCharts::LIMITS, mode: :engine) }
  rescue Chart::Refusal, SystemCallError => e
    raise Wrong, e.message
  end

  # axis_N becomes axis_1, axis_2 ...
  def number(value, axis)
    case value
    when String then value.gsub(/_N\b/, "_#{axis}")
    when Array then value.map { |one| number(one, axis) }
    when Hash then value.to_h { |key, one| [number(key, axis), number(one, axis)] }
    else value
    end
  end

  def spread(hash)
    hash.flat_map do |key, value|
      key.include?('_N') ? (1..@axes).map { |axis| [number(key, axis), number(value, axis)] } : [[key, value]]
    end.to_h
  end

  # A stimulus that names axis_N, and a reaction to axis_N, stand for each axis.
  def spread_rows(name)
    @rows.fetch(name).flat_map do |row|
      subject = row['after'] || row.to_s
      subject.include?('_N') ? (1..@axes).map { |axis| number(row, axis) } : [row]
    end
  end

  # A property that names axis_N stands for each axis, but a reachable one for all of them together.
  def copies(row)
    return [row] if row.key?('reaches') || row.to_s !~ /_N\b/

    (1..@axes).map { |axis| number(row, axis).merge('id' => "#{row.fetch('id')}.#{axis}") }
  end

  def input(name)
    place, what = name.split('.')
    return name if member(place).chart.document.inputs.any? { |one| one.name == what }

    raise Wrong, "#{name}: no such input"
  end

  # words: variables that it may read, beside the permits that are known.
  def expression(text, words = [])
    return nil unless text

    parts = text.match?(/_N\b/) ? (1..@axes).map { |axis| number(text, axis) } : [text]
    parts.map { |part| check(Chart::Expression.parse(part), words) }.reduce { |all, one| [:and, all, one] }
  rescue Chart::Expression::Unsupported, Chart::Expression::TooDeep => e
    raise Wrong, "#{text}: #{e.message}"
  end

  # Checks an expression of names of states, joined by ! && ||.
  def check(expression, words)
    kind, *operands = expression
    case kind
    when :in then check_state(operands.first)
    when :variable then check_variable(operands.first, words)
    when :not, :and, :or then operands.each { |one| check(one, words) }
    else raise Wrong, "a condition may not hold #{kind}"
    end
    expression
  end

  def check_state(name)
    place, id = name.split('.')
    raise Wrong, "#{name}: no such state" unless member(place).chart.document.state(id)
  end

  def check_variable(name, words)
    raise Wrong, "a condition reads #{name}" unless words.include?(name) || @permits&.key?(name)
  end

  def resolve(name)
    place, what = name.split('.')
    found = member(place)
    [found, found.stimuli.index(what) || raise(Wrong, "#{name}: no such event")]
  end

  def stimulus(member, number, text = nil)
    name = "#{member.name}.#{member.stimuli[number]}"
    Stimulus.new(name, member, number, expression(text), read_by(member, number))
  end

  def expiries
    members.flat_map do |member|
      member.chart.document.timers.map { |timer| stimulus(member, member.stimuli.index(timer.id)) }
    end
  end

  def reaction(row)
    place, trigger, what = row.fetch('after').split
    raise Wrong, "#{row['after']}: no such trigger" unless TRIGGERS.include?(trigger)

    source = member(place)
    row.fetch('send').flat_map { |name| name.include?('_N') ? (1..@axes).map { |axis| [name, axis] } : [[name, nil]] }
       .map { |name, axis| reported(row, source, trigger, what, name, axis) }
  end

  def reported(row, source, trigger, what, name, axis)
    text = axis && row['when'] ? number(row['when'], axis) : row['when']
    member, event = resolve(axis ? number(name, axis) : name)
    internal = member.chart.document.internal_events.include?(member.stimuli[event])
    raise Wrong, "#{name} is internal to its chart" if internal

    Reaction.new(source, trigger, what, [member, event], expression(text), row['of'])
  end

  # Inputs that no condition gives.
  def free_inputs
    members.flat_map { |one| one.chart.document.inputs.map { |input| "#{one.name}.#{input.name}" } } -
      @inputs.reject { |_name, given| Chart::Expression.atoms(given).include?([:variable, 'any']) }.keys
  end

  # The free inputs that this stimulus, or the events of its reactions, may read.
  def read_by(member, number)
    known = []
    waiting = [[member, number]]
    until waiting.empty?
      step = waiting.shift
      next if known.include?(step)

      known << step
      waiting += @reactions.select { |one| may_cause?(step, one) }.map(&:reported)
    end
    known.flat_map { |place, what| inputs_read(place, what) }.uniq & @free
  end

  def may_cause?(step, reaction)
    member, number = step
    return false unless reaction.member == member
    return reaction.what == member.stimuli[number] if reaction.trigger == 'hears'

    pairs_of(member, number).any? do |pair|
      pair.outcomes.any? do |outcome|
        next outcome.actions.include?(reaction.what) if reaction.trigger == 'does'

        enters?(member, pair, outcome, reaction.what)
      end
    end
  end

  def enters?(member, pair, outcome, state)
    walk = member.chart.walk
    walk.active(outcome.after.leaves).include?(state) && !walk.active(pair.before.leaves).include?(state)
  end

  def pairs_of(member, number)
    name = member.stimuli[number]
    @pairs ||= {}
    @pairs[[member.chart.document.name, name]] ||= member.chart.walk.reachable_pairs.select do |pair|
      [name, [name]].include?(pair.stimulus.last)
    end
  end

  def inputs_read(member, number)
    outcomes = pairs_of(member, number).flat_map { |pair| pair.outcomes.uniq(&:object_id) }
    outcomes.flat_map(&:reads).uniq.map { |input| "#{member.name}.#{input}" }
  end

  def property(row)
    kind = { 'always' => :always, 'after' => :response, 'only' => :only, 'reaches' => :reachable }
           .find { |key, _kind| row.key?(key) }&.last || raise(Wrong, "#{row['id']} says nothing")
    events = (row['after'] || row['only'] || []).map { |name| stimulus_number(name) }
    text = row['then'] || row['always'] || row['reaches']
    Property.new(row.fetch('id'), kind, events, expression(row['from']), expression(text), row['steps'])
  end

  def stimulus_number(name)
    stimuli.index { |one| one.name == name } || raise(Wrong, "#{name} is no stimulus")
  end
end
