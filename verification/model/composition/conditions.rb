# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'composition'

# The conditions of a composition in C: when something may happen or is answered, what is read, what properties say, and
# the permit.
class CompositionConditions
  def initialize(composition)
    @composition = composition
    @members = composition.members
    @numbers = @members.each_with_index.to_h
    @sets = {}
  end

  def emit
    [inputs, choices('may_happen', @composition.stimuli.map(&:condition)),
     choices('does_react', @composition.reactions.map(&:condition)), properties, permit].flatten.join("\n")
  end

  # The configurations of a member in which a state is active, one bit each.
  def set(member, state)
    @sets[[member, state]] ||= member.configurations.each_with_index.sum do |snapshot, number|
      member.chart.walk.active(snapshot.leaves).include?(state) ? 1 << number : 0
    end
  end

  private

  # An expression of composition.yml; any: what stands for the free value.
  def term(expression, any = nil)
    kind, left, right = expression
    case kind
    when :in then state(left)
    when :variable then left == 'any' ? any : term(@composition.permits.fetch(left))
    when :not then "!(#{term(left, any)})"
    else "(#{term(left, any)} #{kind == :and ? '&&' : '||'} #{term(right, any)})"
    end
  end

  def state(name)
    place, id = name.split('.')
    member = @composition.member(place)
    "is_in(config, #{@numbers.fetch(member)}U, #{set(member, id)}U)"
  end

  # Inputs of a member: free inputs, and conditions on the others.
  def inputs
    cases = @members.each_with_index.map do |member, number|
      values = member.chart.document.inputs.each_with_index.map { |input, bit| input_row(member, input, bit) }
      "    case #{number}U:\n#{values.join}        break;\n"
    end
    <<~TEXT
      static uint32_t inputs_of(config_t config, uint32_t member, uint32_t free)
      {
          uint32_t inputs = 0U;
          (void)free;
          switch (member) {
      #{cases.join}    default:
              break;
          }
          return inputs;
      }
    TEXT
  end

  def input_row(member, input, bit)
    name = "#{member.name}.#{input.name}"
    place = @composition.free.index(name)
    any = place && "(((free >> #{place}U) & 1U) != 0U)"
    given = @composition.inputs[name]
    "        inputs |= #{given ? term(given, any) : any} ? #{1 << bit}U : 0U;\n"
  end

  # A switch over all conditions; what has none holds.
  def choices(name, conditions)
    cases = conditions.each_with_index.filter_map do |condition, number|
      "    case #{number}U:\n        return #{term(condition)};\n" if condition
    end
    <<~TEXT
      static bool #{name}(config_t config, uint32_t number)
      {
          switch (number) {
      #{cases.join}    default:
              return true;
          }
      }
    TEXT
  end

  # A step violates the properties that speak of its stimulus, from the configuration before, and object to the one
  # after. One that may be reached objects to where it is reached.
  def properties
    all = @composition.properties
    steps = all.map { |one| %i[response only].include?(one.kind) }
    [bits('speaks_from', all.zip(steps).map { |one, is| is ? one.from && term(one.from) || 'true' : 'false' }),
     bits('objects_to', all.map { |one| objection(one) }),
     "static const uint64_t spoken_of[] = {#{@composition.stimuli.each_index.map { |one| spoken(one) }.join(', ')}};",
     "#define ALWAYS #{mask(all.map { |one| one.kind == :always })}", '']
  end

  def objection(property)
    holds = term(property.expression)
    %i[always response].include?(property.kind) ? "!#{holds}" : holds
  end

  def spoken(stimulus)
    mask(@composition.properties.map do |one|
      one.kind == :response && one.stimuli.include?(stimulus) || one.kind == :only && !one.stimuli.include?(stimulus)
    end)
  end

  def mask(truths)
    format('UINT64_C(0x%x)', truths.each_with_index.sum { |is, bit| is ? 1 << bit : 0 })
  end

  def bits(name, conditions)
    rows = conditions.each_with_index.reject { |condition, _bit| condition == 'false' }.map do |condition, bit|
      "    bits |= #{condition} ? UINT64_C(1) << #{bit} : 0U;\n"
    end
    "static uint64_t #{name}(config_t config)\n{\n    uint64_t bits = 0U;\n#{rows.join}    return bits;\n}\n"
  end

  # permit_N, the reasons against motion, and the product's own decision on the facts.
  def permit
    cases = @composition.facts.each_with_index.map { |facts, axis| decision(facts, axis) }
    [choices('is_permitted', @composition.permits.values), reasons, <<~TEXT]
      static permit_t decided(config_t config, uint32_t axis)
      {
          permit_common_t common;
          switch (axis) {
      #{cases.join}    default:
              return (permit_t){0};
          }
      }
    TEXT
  end

  def decision(facts, axis)
    common, own = facts.partition { |name, _condition| @composition.common_facts.include?(name) }
    "    case #{axis}U:\n" \
      "        common = permit_decide_common(&(permit_common_facts_t){\n#{initializers(common)}        }, 0U);\n" \
      "        return permit_decide(&common, &(permit_facts_t){\n#{initializers(own)}        });\n"
  end

  def reasons
    cases = @composition.reasons.each_with_index.map do |reasons, axis|
      rows = reasons.map do |name, condition|
        "        reasons |= #{term(condition)} ? 1U << PERMIT_REASON_#{name} : 0U;\n"
      end
      "    case #{axis}U:\n#{rows.join}        break;\n"
    end
    <<~TEXT
      static uint32_t reasons_of(config_t config, uint32_t axis)
      {
          uint32_t reasons = 0U;
          switch (axis) {
      #{cases.join}    default:
              break;
          }
          return reasons;
      }
    TEXT
  end

  def initializers(facts)
    facts.map { |name, condition| "            .#{name} = #{term(condition)},\n" }.join
  end
end
