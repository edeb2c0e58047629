# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'fileutils'
require_relative '../../../tools/chart/emit/c/header'
require_relative '../../../tools/chart/emit/c/source'
require_relative 'chart_tables'
require_relative 'composition'

# A composition as a C program: the charts as compiled, the same charts as tables of what the interpreter does, and how
# they act on each other. explorer.c runs it.
class CompositionProgram
  HEAD = "/* SPDX-License-Identifier: Apache-2.0 */\n/* Generated from composition.yml. */".freeze
  STEP = 'violated_by_step(const config_t *before, uint32_t stimulus, const config_t *after)'

  def initialize(composition)
    @composition = composition
    @members = composition.members
    @numbers = @members.each_with_index.to_h
  end

  # Writes all files; the block may change the C of a chart.
  def write(folder)
    FileUtils.mkdir_p(folder)
    @composition.charts.each_value do |chart|
      name = chart.document.name
      source = Chart::C::Source.new(chart.document, chart.walk).emit
      source = yield name, source if block_given?
      File.write(File.join(folder, "#{name}_chart.h"), Chart::C::Header.new(chart.document, chart.walk).emit)
      File.write(File.join(folder, "#{name}_chart.c"), source)
    end
    File.write(File.join(folder, 'numbers.h'), numbers)
    File.write(File.join(folder, 'composition.h'), header)
  end

  # For whoever has charts and wants to know which configurations they are in.
  def numbers
    [HEAD, '#define NEVER 0xFFFFU', includes, tables.map(&:numbers)].flatten.join("\n")
  end

  def header
    [head, tables.map(&:emit), lists, configuration, inputs,
     choices('may_happen', @composition.stimuli.map(&:condition)),
     choices('does_react', @composition.reactions.map(&:condition)), properties, permit].flatten.join("\n")
  end

  private

  def head
    <<~TEXT
      #{HEAD}
      #define MEMBERS #{@members.length}U
      #define STIMULI #{@composition.stimuli.length}U
      #define REACTIONS #{@composition.reactions.length}U
      #define PROPERTIES #{@composition.properties.length}U
      #define AXES #{@composition.axes}U
      #define FREE_INPUTS #{@composition.free.length}U

      #include "explorer.h"
      #include "numbers.h"
    TEXT
  end

  def includes
    @composition.charts.values.map { |chart| "#include \"#{chart.document.name}_chart.h\"" }
  end

  def tables
    @composition.charts.values.map { |chart| ChartTables.new(chart) }
  end

  def lists
    names = @members.map { |member| member.chart.document.name }
    [list('step_t *const compiled_steps', names.map { |name| "#{name}_compiled" }),
     list('step_t *const table_steps', names.map { |name| "#{name}_table" }),
     list('const uint64_t *const active', names.map { |name| "#{name}_active" }),
     list('const char *const free_inputs', @composition.free.map { |name| "\"#{name}\"" }),
     list('const stimulus_t stimuli', @composition.stimuli.map { |one| stimulus(one) }),
     list('const reaction_t reactions', @composition.reactions.map { |one| reaction(one) }),
     list('const property_t properties', @composition.properties.map { |one| "{\"#{one.id}\", #{steps(one)}}" })]
  end

  def list(what, values)
    "static #{what}[] = {\n#{values.map { |value| "    #{value},\n" }.join}};\n"
  end

  def stimulus(one)
    free = one.free.sum { |name| 1 << @composition.free.index(name) }
    "{\"#{one.name}\", #{@numbers.fetch(one.member)}U, #{one.number}U, #{free}U}"
  end

  def reaction(one)
    told, event = one.told
    trigger = "TRIGGER_#{one.trigger.upcase}"
    "{#{@numbers.fetch(one.member)}U, #{trigger}, #{what(one)}U, #{@numbers.fetch(told)}U, #{event}U}"
  end

  def what(reaction)
    document = reaction.member.chart.document
    found = case reaction.trigger
            when 'enters' then document.states.index(document.state(reaction.what))
            when 'does' then document.actions.index(reaction.what)
            else reaction.member.stimuli.index(reaction.what)
            end
    found || raise(Composition::Wrong, "#{reaction.member.name} #{reaction.trigger} #{reaction.what}: no such thing")
  end

  def steps(property)
    property.kind == :reachable ? (property.steps || 'UINT32_MAX') : 0
  end

  def configuration
    starts = @members.each_with_index.map do |member, number|
      "    config->of[#{number}] = #{member.configurations.index(member.chart.walk.start.after)}U;"
    end
    <<~TEXT
      static void begin(config_t *config)
      {
      #{starts.join("\n")}
      }

      static bool is_in(const config_t *config, uint32_t member, uint32_t state)
      {
          return ((active[member][config->of[member]] >> state) & 1U) != 0U;
      }
    TEXT
  end

  # An expression of composition.yml in C; any: what stands for the free value.
  def term(expression, config = 'config', any = nil)
    kind, left, right = expression
    case kind
    when :in then state(left, config)
    when :variable then left == 'any' ? any : term(@composition.permits.fetch(left), config)
    when :not then "!(#{term(left, config, any)})"
    else "(#{term(left, config, any)} #{kind == :and ? '&&' : '||'} #{term(right, config, any)})"
    end
  end

  def state(name, config)
    place, id = name.split('.')
    member = @composition.member(place)
    document = member.chart.document
    "is_in(#{config}, #{@numbers.fetch(member)}U, #{document.states.index(document.state(id))}U)"
  end

  # What a member reads: free inputs, and conditions on the others.
  def inputs
    cases = @members.each_with_index.map do |member, number|
      values = member.chart.document.inputs.each_with_index.map { |input, bit| input_row(member, input, bit) }
      "    case #{number}U:\n#{values.join}        break;\n"
    end
    <<~TEXT
      static uint32_t inputs_of(const config_t *config, uint32_t member, uint32_t free)
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
    "        inputs |= #{given ? term(given, 'config', any) : any} ? #{1 << bit}U : 0U;\n"
  end

  # A switch over all conditions; what has none holds.
  def choices(name, conditions)
    cases = conditions.each_with_index.filter_map do |condition, number|
      "    case #{number}U:\n        return #{term(condition)};\n" if condition
    end
    <<~TEXT
      static bool #{name}(const config_t *config, uint32_t number)
      {
          switch (number) {
      #{cases.join}    default:
              return true;
          }
      }
    TEXT
  end

  def properties
    [first('violated_by(const config_t *config)', :always) { |one| "!#{term(one.expression)}" },
     first(STEP, :response, :only) { |one| broken(one) },
     choices('is_wanted', @composition.properties.map { |one| one.kind == :reachable ? one.expression : nil })]
  end

  # The number of the first property that is violated.
  def first(function, *kinds)
    rows = @composition.properties.each_with_index.filter_map do |one, number|
      "    if (#{yield one}) {\n        return #{number}U;\n    }\n" if kinds.include?(one.kind)
    end
    "static uint32_t #{function}\n{\n#{rows.join}    return PROPERTIES;\n}\n"
  end

  def broken(property)
    by = property.stimuli.map { |number| "(stimulus == #{number}U)" }.join(' || ')
    from = property.from ? term(property.from, 'before') : 'true'
    holds = term(property.expression, 'after')
    property.kind == :response ? "(#{by}) && #{from} && !#{holds}" : "!(#{by}) && #{from} && #{holds}"
  end

  # permit_N, and whether the product's own decision on the facts is the same.
  def permit
    axes = @composition.facts.each_with_index.map do |facts, axis|
      rows = facts.map { |name, condition| "        .#{name} = #{term(condition)},\n" }
      "    facts = (permit_facts_t){\n#{rows.join}    };\n" \
        "    is_same = is_same && (permit_decide(&facts).is_allowed == is_permitted(config, #{axis}U));\n"
    end
    [choices('is_permitted', @composition.permits.values), <<~TEXT]
      static bool does_permit_agree(const config_t *config)
      {
          permit_facts_t facts;
          bool is_same = true;
      #{axes.join}    return is_same;
      }
    TEXT
  end
end
