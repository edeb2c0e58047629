# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'guard'

# Everything that one may forget or weaken in a chart, once: where it starts and where it goes when it is damaged, each
# transition, guard, part of a guard, action, raised event, timer, limit and ignored event. A mutant is the tree of the
# file's elements with that one change.
class Mutants
  # name: what is changed, in words; no two of a chart have one.
  Mutant = Struct.new(:name, :tree)

  ADDED = { 'bs:id' => 'MUTANT-T01', 'bs:req' => 'SWR-CHART-030' }.freeze

  # limits: Chart::Limits. whole: with every action that may be added to a place; else each place gets one of them.
  def self.of(tree, limits, whole: true)
    new(tree, limits, whole).all
  end

  def initialize(tree, limits, whole)
    @tree = tree
    @whole = whole
    @limits = limits.values.select { |name, _value| name.end_with?('_us') }
    @transitions = tree.all.select { |one| one.attributes.key?('bs:id') }
    @states = tree.all.select { |one| %w[state parallel].include?(one.name) }
    @mutants = []
  end

  def all
    @transitions.each { |one| transition(one) }
    questions.each { |event, atom| ask_not(event, atom) }
    @states.each { |one| state(one) }
    starts
    refuges
    actions
    @mutants.uniq { |one| one.tree }
  end

  private

  # The block changes a copy of the tree, in which it finds the elements that are given.
  def mutant(name, *elements)
    tree = Marshal.load(Marshal.dump(@tree))
    copies = elements.map { |one| tree.all[@tree.all.index { |other| other.equal?(one) }] }
    yield(*copies, tree)
    @mutants << Mutant.new(name, tree)
  end

  def parent(tree, element)
    tree.all.find { |one| one.children.any? { |child| child.equal?(element) } }
  end

  def remove(tree, element)
    parent(tree, element).children.delete_if { |one| one.equal?(element) }
  end

  def transition(one)
    id = one.attributes['bs:id']
    mutant("#{id} is ignored", one) { |copy, tree| remove(tree, copy) }
    mutant("#{id} leads nowhere", one) { |copy, _tree| copy.attributes.delete('target') } if one.attributes['target']
    guards(one, id)
    contents(one, id)
    (places - [one.attributes['target']]).each do |target|
      mutant("#{id} leads to #{target}", one) { |copy, _tree| copy.attributes.update('target' => target) }
    end
  end

  # Where a transition may lead.
  def places
    @places ||= leaves(@tree)
  end

  # The states without states inside an element.
  def leaves(element)
    inside = element.all & @states
    inside.reject { |one| one.all.any? { |inner| inner != one && @states.include?(inner) } }
          .map { |one| one.attributes['id'] }
  end

  def starts
    [@tree, *@states].select { |one| one.attributes.key?('initial') }.each do |one|
      (leaves(one) - begun(one)).each do |leaf|
        mutant("#{one.attributes['id'] || 'the chart'} starts in #{leaf}", one) do |copy, _tree|
          copy.attributes['initial'] = leaf
        end
      end
    end
  end

  # The leaves that an element begins with.
  def begun(element)
    inside = element.children & @states
    return [element.attributes['id']] if inside.empty?
    return inside.flat_map { |one| begun(one) } if element.name == 'parallel'

    begun(@states.find { |one| one.attributes['id'] == element.attributes['initial'] })
  end

  # For each leaf of the safe configuration, every other one.
  def refuges
    safe = @tree.attributes['bs:safe'].split
    safe.product(places - safe).each do |leaf, other|
      mutant("damaged it goes to #{other}, not to #{leaf}", @tree) do |copy, _tree|
        copy.attributes['bs:safe'] = safe.map { |one| one == leaf ? other : one }.join(' ')
      end
    end
  end

  def guards(one, id)
    guard = one.attributes['cond'] or return
    mutant("#{id} asks nothing", one) { |copy, _tree| copy.attributes.delete('cond') }
    Guard.weakened(guard).each do |part, rest|
      mutant("#{id} does not ask #{part}", one) { |copy, _tree| copy.attributes['cond'] = rest }
    end
  end

  def contents(one, id)
    actions = one.attributes.fetch('bs:do', '').split
    actions.each do |action|
      mutant("#{id} does not #{action}", one) do |copy, _tree|
        copy.attributes['bs:do'] = (actions - [action]).join(' ')
      end
    end
    one.children.each do |raised|
      mutant("#{id} does not raise #{raised.attributes['event']}", raised) { |copy, tree| remove(tree, copy) }
    end
  end

  # Something is done where it is not asked for: by a transition, or where an event is ignored.
  def actions
    @actions = @tree.all.flat_map { |one| one.attributes.fetch('bs:do', '').split }.uniq
    @transitions.each { |one| act("#{one.attributes['bs:id']} does", one) { |copy| copy } }
    @states.each do |one|
      id = one.attributes['id']
      one.attributes.fetch('bs:ignores', '').split.each do |event|
        act("#{id} takes #{event} and does", one) { |copy| added('event' => event).tap { |new| copy.children << new } }
      end
    end
  end

  # The block gives the element that acts.
  def act(words, one)
    has = one.attributes.fetch('bs:do', '').split
    choice(@actions - has).each do |action|
      mutant("#{words} #{action}", one) { |copy, _tree| yield(copy).attributes['bs:do'] = [*has, action].join(' ') }
    end
  end

  # The places take turns.
  def choice(actions)
    return actions if @whole || actions.empty?

    [actions[(@turn = (@turn || -1) + 1) % actions.length]]
  end

  # Questions of the guards of an event: [event, atom].
  def questions
    @transitions.flat_map do |one|
      Guard.atoms(one.attributes['cond']).map { |atom| [one.attributes['event'], atom] }
    end.uniq
  end

  # In all guards of the event, so that they still fit each other.
  def ask_not(event, atom)
    asking = @transitions.select { |one| one.attributes['event'] == event && one.attributes['cond'] }
    [true, false].each do |answer|
      mutant("#{event} takes #{atom} for #{answer}", *asking) do |*copies, tree|
        copies.each { |copy| assume(tree, copy, atom, answer) }
      end
    end
  end

  def assume(tree, copy, atom, answer)
    case (guard = Guard.assuming(copy.attributes['cond'], atom, answer))
    when true then copy.attributes.delete('cond')
    when false then remove(tree, copy)
    else copy.attributes['cond'] = guard
    end
  end

  def state(one)
    one.attributes.fetch('bs:ignores', '').split.each { |event| hear(one, event) }
    one.children.select { |child| child.name == 'onentry' }.flat_map(&:children).select { |send| send.name == 'send' }
       .each { |send| timer(one, send) }
  end

  # An event that is ignored here is taken as it is elsewhere.
  def hear(state, event)
    @transitions.select { |one| one.attributes['event'] == event }
                .uniq { |one| [one.attributes.values_at('target', 'bs:do'), one.children.map(&:attributes)] }
                .each { |one| take(state, event, one) }
  end

  def take(state, event, one)
    name = "#{state.attributes['id']} takes #{event} as #{one.attributes['bs:id']}"
    mutant(name, state, one) do |copy, like, _tree|
      copy.children << added(like.attributes.slice('event', 'target', 'bs:do'), like.children)
    end
  end

  def added(attributes, children = [])
    Chart::Element.new('transition', attributes.merge(ADDED), children, 1)
  end

  def timer(state, send)
    id, event, limit = send.attributes.values_at('id', 'event', 'bs:limit')
    (@limits.keys - [limit]).each do |other|
      mutant("#{id} lasts #{other}", send) do |copy, _tree|
        copy.attributes.update('bs:limit' => other, 'delay' => "#{@limits.fetch(other)}us")
      end
    end
    mutant("#{id} rounds the other way", send) do |copy, _tree|
      copy.attributes['bs:kind'] = (%w[watchdog hold_off] - [copy.attributes['bs:kind']]).first
    end
    never(state, id)
    (ignored(state) - [event]).each { |one| again(state, id, one) }
  end

  # Neither started nor cancelled.
  def never(state, id)
    mutant("#{id} never runs", state) do |copy, _tree|
      copy.all.each { |block| block.children.reject! { |one| names?(one, id) } }
    end
  end

  def names?(element, timer)
    %w[send cancel].include?(element.name) && element.attributes.values_at('id', 'sendid').include?(timer)
  end

  # Events that nothing takes in the state, or in some of what is inside.
  def ignored(state)
    around = @states.select { |one| one.all.include?(state) }
    (around + state.all).flat_map { |one| one.attributes.fetch('bs:ignores', '').split }.uniq
  end

  def again(state, id, event)
    mutant("#{id} starts again by #{event}", state) do |copy, _tree|
      copy.children << added('event' => event, 'target' => state.attributes['id'])
    end
  end
end
