# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'fileutils'
require_relative 'chart_tables'
require_relative 'composition'
require_relative 'conditions'

# A composition as a C program: the charts as compiled, the same charts as tables of what the interpreter does, and how
# they act on each other. explorer.c runs it.
class CompositionProgram
  HEAD = "/* SPDX-License-Identifier: Apache-2.0 */\n/* Generated from composition.yml. */".freeze

  def initialize(composition)
    @composition = composition
    @members = composition.members
    @numbers = @members.each_with_index.to_h
    @conditions = CompositionConditions.new(composition)
  end

  # Writes all files; the block may change the C of a chart, and that of the composition.
  def write(folder, &mutate)
    mutate ||= ->(_name, source) { source }
    FileUtils.mkdir_p(folder)
    @composition.charts.each_value do |chart|
      name = chart.document.name
      source = chart.source
      File.write(File.join(folder, "#{name}_chart.h"), chart.header)
      File.write(File.join(folder, "#{name}_chart.c"), mutate.call(name, source))
    end
    File.write(File.join(folder, 'numbers.h'), numbers)
    File.write(File.join(folder, 'composition.h'), mutate.call('composition', header))
  end

  # For a reader of charts who wants to know their configurations.
  def numbers
    [HEAD, '#define NEVER 0xFFFFU', '#define ANOTHER_CARD_LOST 0x80000000U', includes,
     tables.map(&:numbers)].flatten.join("\n")
  end

  def header
    [head, tables.map(&:emit), lists, start, exchanges, @conditions.emit].flatten.join("\n")
  end

  private

  def head
    <<~TEXT
      #{HEAD}
      #define MEMBERS #{@members.length}U
      #define LARGEST #{@members.map { |member| member.configurations.length }.max}U
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
    [list('const member_t members', @members.map { |one| member(one) }),
     list('const char *const free_inputs', @composition.free.map { |name| "\"#{name}\"" }),
     list('const stimulus_t stimuli', @composition.stimuli.map { |one| stimulus(one) }),
     list('const reaction_t reactions', @composition.reactions.map { |one| reaction(one) }),
     list('const property_t properties', @composition.properties.map { |one| property(one) })]
  end

  def list(what, values)
    "static #{what}[] = {\n#{values.map { |value| "    #{value},\n" }.join}};\n"
  end

  def member(one)
    name = one.chart.document.name
    sizes = [one.configurations, one.stimuli, one.chart.walk.valuations].map { |all| "#{all.length}U" }
    "{#{["#{name}_compiled", "#{name}_interpreted", *sizes].join(', ')}}"
  end

  def stimulus(one)
    free = one.free.sum { |name| 1 << @composition.free.index(name) }
    twin = twin_in(@composition.stimuli.map(&:name), one.name)
    "{\"#{one.name}\", #{@numbers.fetch(one.member)}U, #{one.number}U, #{free}U, #{twin}U}"
  end

  def twin_in(names, name)
    names.index(@composition.exchange.name(name))
  end

  def reaction(one)
    reported, event = one.reported
    numbers = [@numbers.fetch(reported), event].map { |number| "#{number}U" }
    trigger = "TRIGGER_#{one.trigger.upcase}, #{what(one)}U"
    "{#{@numbers.fetch(one.member)}U, #{trigger}, #{numbers.join(', ')}, #{@composition.exchange.alone?(one)}}"
  end

  def what(reaction)
    document = reaction.member.chart.document
    found = case reaction.trigger
            when 'enters' then document.state(reaction.what) && @conditions.set(reaction.member, reaction.what)
            when 'does' then document.actions.index(reaction.what)
            else reaction.member.stimuli.index(reaction.what)
            end
    found || raise(Composition::Wrong, "#{reaction.member.name} #{reaction.trigger} #{reaction.what}: no such thing")
  end

  def property(one)
    steps = one.kind == :reachable ? (one.steps || 'UINT32_MAX') : 0
    "{\"#{one.id}\", #{steps}, #{twin_in(@composition.properties.map(&:id), one.id)}U}"
  end

  def start
    places = @members.each_with_index.map do |member, number|
      "    config = with_own(config, #{number}U, #{member.configurations.index(member.chart.walk.start.after)}U);\n"
    end
    "static config_t start(void)\n{\n    config_t config = 0U;\n#{places.join}    return config;\n}\n"
  end

  # The axes in each other's place.
  def exchanges
    [exchange('config_t exchanged(config_t all)', 'swapped', @members.map(&:name)),
     exchange('uint32_t exchanged_inputs(uint32_t all)', 'swapped_bits', @composition.free)]
  end

  def exchange(function, swap, names)
    swaps = @composition.exchange.pairs(names).map { |one, other| "    all = #{swap}(all, #{one}U, #{other}U);\n" }
    "static #{function}\n{\n#{swaps.join}    return all;\n}\n"
  end
end
