# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# A composition with its first two axes in each other's place. All that composition.yml says must read the same then,
# but for reactions that are said to be of one axis. With one axis there is nothing to exchange.
class Exchange
  PLACE = /\A[a-z]+_[12](?=\.|\z)|(?<=\.)[12]\z/.freeze
  UNORDERED = %i[and or set].freeze

  def initialize(composition)
    @composition = composition
    @reactions = composition.reactions.to_h { |one| [one, reaction_row(one)] }.compare_by_identity
    rows.each { |what, all| check(what, all) }
    @alone = lacking(@reactions.values)
  end

  # New name for a name.
  def name(text)
    @composition.axes > 1 ? text.sub(PLACE) { |found| found.tr('12', '21') } : text
  end

  # Numbers in a list of names that change places.
  def pairs(names)
    twins = names.map { |one| names.index(name(one)) }
    twins.each_with_index.select { |twin, number| number < twin }.map(&:reverse)
  end

  # A reaction that the other axis has no part in.
  def alone?(reaction)
    @alone.include?(@reactions.fetch(reaction))
  end

  private

  # All that the composition says; the strings of a row name it.
  def rows
    { 'member' => @composition.members.map { |one| [one.name, one.chart.document.name] },
      'input' => @composition.inputs.to_a, 'permit' => @composition.permits.to_a,
      'facts' => @composition.permits.keys.zip(@composition.facts.map(&:to_a)),
      'reasons' => @composition.permits.keys.zip(@composition.reasons.map(&:to_a)),
      'stimulus' => @composition.stimuli.map { |one| [one.name, one.condition, [:set, *one.free]] },
      'reaction' => @reactions.reject { |one, _row| one.of }.values,
      'property' => @composition.properties.map { |one| property_row(one) } }
  end

  def reaction_row(one)
    reported, event = one.reported
    [one.member.name, one.trigger, one.what, reported.name, reported.stimuli[event], one.condition]
  end

  def property_row(one)
    stimuli = one.stimuli.map { |number| @composition.stimuli[number].name }
    [one.id, one.kind, [:set, *stimuli], one.from, one.expression, one.steps]
  end

  def check(what, all)
    row = lacking(all).first or return
    raise Composition::Wrong, "#{what} #{row.grep(String).join(' ')}: the other axis has none like it"
  end

  # Rows that are not there when the axes change places.
  def lacking(all)
    there = all.map { |row| ordered(row) }
    all.reject { |row| there.include?(ordered(exchanged(row))) }
  end

  def exchanged(value)
    case value
    when String then name(value)
    when Array then value.map { |one| exchanged(one) }
    else value
    end
  end

  # The same for what means the same: no order where it means nothing.
  def ordered(value)
    return value unless value.is_a?(Array)

    kind, *rest = value.map { |one| ordered(one) }
    return [kind, *rest] unless UNORDERED.include?(kind)

    [kind, *rest.flat_map { |one| one.is_a?(Array) && one.first == kind ? one.drop(1) : [one] }.sort_by(&:inspect)]
  end
end
