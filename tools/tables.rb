#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Fills the tables of the documents from their sources, so that they say what the programs say.
#
#   ruby tools/tables.rb [--root FOLDER]           rewrites the marked blocks of README.md, SOUNDNESS.md and docs/*.md
#   ruby tools/tables.rb --check [--root FOLDER]   one line per stale block, exit 1 if there is any
#
# A block begins with the line `<!-- table:NAME -->` and ends with the line `<!-- end -->`. NAME is an enumeration or a
# structure of core/interface; `routes` or `problems`, for those of core/interface/routes.yml; `commands`, for how each is sent, and
# `answers`, for what may become of it; `modes`, for the whole table of core/interface/modes.yml; `limits`, for those of
# requirements/; `known_limits`, for those of
# requirements/known_limits.yml; `rooms`, for tools/rooms.yml; `decisions`, for docs/decisions;
# `waits`, for tools/documents/waits.yml; `proofs`, for verification/proof/proofs.yml; `proved`, a sentence of proved.yml beside it;
# `bound`, for verification/bound/bound.yml beside the counted cycles of verification/bench/cost.yml;
# `robots`, for the axes of core/robot/*/robot.yml;
# or one of tools/documents/card_tables.rb, for the frames of the cards.

require 'optparse'
require_relative 'documents/card_tables'
require_relative 'documents/console_names'
require_relative 'decisions'
require_relative 'gates/plan'
require_relative 'interface/model'
require_relative 'proof/harness'
require_relative 'proof/proved_list'
require_relative 'robot/description'
require_relative 'rooms'
require_relative 'trace/requirements'

# A row for each axis of each robot, for the operator.
class RobotRows
  HOMES = { 'in_place' => 'where it stands', 'lower' => 'switch, lower end', 'upper' => 'switch, upper end' }.freeze

  def initialize(file)
    @robot = Robot::Description.new(file, File.read(file, encoding: 'UTF-8'))
  end

  def rows
    @robot.axes.map do |axis|
      ["`#{@robot.name}`", axis['name'], axis['slot'], range(axis), HOMES[axis['home']] || HOMES[axis['limit_switch']],
       axis['home_stage'], followed(axis)]
    end
  end

  private

  def range(axis)
    low, high = %w[minimum_ticks maximum_ticks].map { |key| axis.units(axis[key]) }
    return format('%<low>.1f to %<high>.1f mm', low: low, high: high) if axis.linear?

    format('%<low>.1f to %<high>.1f degrees', low: low * 180 / Math::PI, high: high * 180 / Math::PI)
  end

  def followed(axis)
    axis['follows'].map { |stage, leader| "#{leader.name} in #{stage}" }.join(', ')
  end
end

# Contents that can be shown as a table, read from one project.
class TableSources
  # Tables that are no enumeration and no structure: a method of the same name.
  OTHERS = %w[answers bound commands decisions known_limits limits modes problems proofs proved robots rooms routes waits].freeze

  LINE = 130 # characters

  def initialize(root)
    @root = root
  end

  # Lines of the table, nil when nothing has this name.
  def table(name)
    return send(name) if OTHERS.include?(name)

    return cards.table(name, method(:markdown)) if CardTables::NAMES.key?(name)

    enumeration = interface.enumeration(name)
    return values_of(enumeration) if enumeration

    structure = interface.structure(name)
    structure && fields_of(structure)
  end

  def names
    ((interface.enumerations + interface.structures).map(&:name) + OTHERS + CardTables::NAMES.keys).sort
  end

  private

  def interface
    @interface ||= Interface::Model.new(File.join(@root, 'core', 'interface'))
  end

  def cards
    @cards ||= CardTables.new(@root, Trace::Requirements.load('requirements', @root).limits_by_name)
  end

  def values_of(enumeration)
    return events if enumeration.name == 'event_id'

    markdown(['No.', 'Name', 'What it says'], enumeration.values.map { |value| [value.code, "`#{value.name}`", value.says] })
  end

  # @satisfies SWR-TOOL-483
  def events
    rows = interface.events.events.map do |event|
      [event.value.code, "`#{event.value.name}`", event.severity, event.subject_title, event.about, event.value.says]
    end
    markdown(['No.', 'Name', 'Severity', 'Subject', 'Value', 'What it says'], rows)
  end

  def fields_of(structure)
    rows = structure.fields.map do |field|
      shown = field.shown.map { |one| "`#{one.message}.#{one.key}`" }
      ["`#{field.name}`", "#{field.type.c}#{"[#{field.count}]" if field.count}", field.comment, shown.join(', '),
       field.column && "`#{field.column.name}`"]
    end
    markdown(['Field', 'Type', 'What it says', 'JSON', 'Column of the replay'], rows)
  end

  # A list, as its sentences are too long for a table.
  #
  # @satisfies SWR-TOOL-032
  def known_limits
    requirements = Trace::Requirements.load('requirements', @root)
    requirements.of_kind('LIM').flat_map do |item|
      lines = "- **#{item.title}** (#{item.id}). #{requirements.sentence(item)}".scan(/\S.{0,#{LINE - 3}}(?=\s|\z)/)
      lines.take(1) + lines.drop(1).map { |line| "  #{line}" }
    end
  end

  def limits
    rows = Trace::Requirements.load('requirements', @root).limits.sort_by(&:name).map do |limit|
      ["`#{limit.name}`", limit.value, limit.unit, limit.requirement]
    end
    markdown(%w[Limit Value Unit Requirement], rows)
  end

  def modes
    rows = interface.modes.modes.drop(1).map do |mode|
      ["`#{mode.value.name}`", mode.value.says, "`#{mode.command}`",
       mode.workphases.map { |name| "`#{name}`" }.join(', '), mode.axes.downcase, mode.unhomed ? 'no' : 'yes']
    end
    markdown(['Mode', 'What it does', 'Armed by', 'In', 'Axes it needs', 'They must be homed'], rows)
  end

  # How pages and peers send each command. A name is said only if an element of the console shows it.
  #
  # @satisfies SWR-TOOL-320
  def commands
    shown = ConsoleNames.new(@root, interface).shown
    rows = interface.commands.to_a.drop(1).map do |command|
      words = command.more['words']&.sequence.to_a.map { |word| "`#{word.at('word').word}`" }
      name = command.more['label']&.text if shown.include?(command.name)
      ["`#{command.name}`", name, requests_of(command).map { |route| "`#{route.method} #{route.path}`" }.join(', '), words.join(', ')]
    end
    markdown(['Command', 'Name in the console', 'HTTP', 'Words of OpenIGTLink'], rows)
  end

  # The statuses with which each command may be refused, and may end early.
  #
  # @satisfies SWR-TOOL-341
  def answers
    all = interface.answers
    rows = interface.commands.to_a.drop(1).map do |command|
      ["`#{command.name}`", *[all.refused(command), all.ended(command)].map { |names| all.shown(names).join(', ') }]
    end
    markdown(['Command', 'Refused with', 'Ended early with'], rows)
  end

  # Those that send it: its own, or that of another command. A request that empties a list sends the beginning of one alone.
  #
  # @satisfies SWR-TOOL-321
  def requests_of(command)
    node = command.more['http']
    return interface.routes.routes.select { |route| route.command == command } unless node&.scalar?

    interface.routes.routes.select { |route| route.command == interface.commands.find(node.word) && route.method == 'POST' }
  end

  def decisions
    markdown(%w[No. Decision], Decisions.new(@root).records.map do |record|
      [record.number, "[#{record.title}](#{record.file.delete_prefix('docs/')})"]
    end)
  end

  def proofs
    Dir.chdir(@root) do
      rows = Proof::Harness.all.map do |harness|
        by_day = harness.functions(at_night: false).keys
        named = harness.functions(at_night: true).keys.map { |name| "`#{name}`#{' at night' unless by_day.include?(name)}" }
        ["`#{harness.file}`", harness.tool, named.join(', '), harness.functions_proved.map { |name| "`#{name}`" }.join(', '), harness.mutants.size]
      end
      markdown(['Harness', 'Prover', 'Proofs', 'Functions in which every check holds', 'Mutants refuted'], rows)
    end
  end

  # The largest counted cycle has one command.
  def bound
    bounds, counted = %w[bound/bound bench/cost].map { |name| YAML.safe_load_file(File.join(@root, "verification/#{name}.yml"))['robots'] }
    rows = bounds.flat_map do |robot, by_commands|
      by_commands['one_command'].map do |stage, most|
        worst = counted[robot][stage]['worst']
        [robot, stage, worst, most, format('%.1f', most.fdiv(worst)), by_commands['four_commands'][stage]]
      end
    end
    markdown(['Robot', 'Stage', 'Largest counted', 'Bound, one command', 'Ratio', 'Bound, four commands'], rows)
  end

  # @satisfies SWR-TOOL-283
  def proved
    Proof::ProvedList.read(File.join(@root, Proof::ProvedList::FILE)).summary.scan(/\S.{0,#{LINE - 1}}(?=\s|\z)/)
  end

  def robots
    files = Dir.glob(File.join(@root, 'core/robot/*/robot.yml')).sort
    markdown(['Robot', 'Axis', 'Slot', 'Range', 'Homes by', 'Stage', 'Follows'],
             files.flat_map { |file| RobotRows.new(file).rows })
  end

  def rooms
    rows = Rooms.new(@root).rooms.map do |room|
      ["`#{room.folder}`", room.holds, room.sees.map { |seen| "`#{seen}`" }.join(', ')]
    end
    markdown(%w[Folder Holds Sees], rows)
  end

  def routes
    rows = interface.routes.routes.map { |route| ["`#{route.path}`", route.method, route.who.downcase, route.says, parameters(route)] }
    markdown(['Path', 'Method', 'Who', 'What', 'Query and headers'], rows)
  end

  # @satisfies SWR-TOOL-036
  # @satisfies SWR-TOOL-045
  def waits
    rows = YAML.safe_load_file(File.join(@root, 'tools/documents/waits.yml')).map do |row|
      ["`#{row['command']}`#{row['when']}", [span(*seconds_of(row['seconds'])) + machine_of(row), *row['says']].join('; ')]
    end
    markdown(['Command', 'How long it takes, about, on two free cores'], rows)
  end

  def machine_of(row)
    row['seconds'] == 'gates' ? " on #{row.fetch('machine')}" : ''
  end

  def seconds_of(seconds)
    return seconds unless seconds == 'gates'

    gates = Gates::Gate.read(File.join(@root, 'verification/gates.yml'))
    [Gates::Plan.new(2, gates.to_h { |gate| [gate.name, gate.seconds] }).seconds_left([], {}, gates)] * 2
  end

  def span(least, most)
    unit, size = most < 60 ? ['s', 1] : ['minutes', 60]
    "#{[least, most].map { |seconds| (seconds.to_f / size).round }.uniq.join(' to ')} #{unit}"
  end

  def parameters(route)
    (route.parameters.members + route.headers).map { |one| "`#{one.name}`: #{one.says}" }.join(' ')
  end

  def problems
    markdown(%w[Status Code What], interface.routes.problems.map { |one| [one.http, "`#{one.name}`", one.says] })
  end

  def markdown(heads, rows)
    [heads, heads.map { '---' }, *rows].map { |cells| "| #{cells.map { |cell| escape(cell) }.join(' | ')} |" }
  end

  def escape(cell)
    cell.to_s.gsub('|', '\\|')
  end
end

# A document with marked blocks.
class TabledDocument
  BEGINNING = /\A<!-- table:(?<name>\w+) -->\s*\z/
  ENDING = /\A<!-- end -->\s*\z/

  # One marked block: the number of its first line, what it holds and what it should hold.
  Block = Struct.new(:name, :number, :found, :wanted, keyword_init: true) do
    def stale?
      found != wanted
    end
  end

  # A mark that leads nowhere.
  class MarkError < StandardError; end

  attr_reader :blocks

  def initialize(file, text, sources)
    @file = file
    @lines = text.lines(chomp: true)
    @sources = sources
    @blocks = []
    read_blocks
  end

  # The text with every block filled.
  def text
    filled = @lines.dup
    @blocks.reverse_each { |block| filled[block.number, block.found.size] = block.wanted }
    "#{filled.join("\n")}\n"
  end

  def findings
    @blocks.select(&:stale?).map do |block|
      "#{@file}:#{block.number}: table #{block.name} is stale; run ruby tools/tables.rb"
    end
  end

  private

  def read_blocks
    @lines.each_with_index do |line, index|
      next unless (mark = BEGINNING.match(line))

      wanted = @sources.table(mark[:name])
      fail_at(index, "there is no table #{mark[:name]}; there are #{@sources.names.join(', ')}") unless wanted
      @blocks << Block.new(name: mark[:name], number: index + 1, found: lines_up_to_end(index), wanted: wanted)
    end
  end

  def lines_up_to_end(index)
    rest = @lines.drop(index + 1)
    size = rest.index { |line| line.match?(ENDING) || line.match?(BEGINNING) }
    fail_at(index, 'the block has no end; write <!-- end -->') unless size && rest[size].match?(ENDING)
    rest.take(size)
  end

  def fail_at(index, what)
    raise MarkError, "#{@file}:#{index + 1}: #{what}"
  end
end

if $PROGRAM_NAME == __FILE__
  options = { root: File.expand_path('..', __dir__), check: false }
  begin
    OptionParser.new do |parser|
      parser.banner = 'usage: tables.rb [--check] [--root FOLDER]'
      parser.on('--check') { options[:check] = true }
      parser.on('--root FOLDER') { |folder| options[:root] = folder }
    end.parse!
    sources = TableSources.new(options[:root])
    documents = Dir.glob(%w[README.md SOUNDNESS.md docs/*.md], base: options[:root]).sort.to_h do |file|
      [file, TabledDocument.new(file, File.read(File.join(options[:root], file), encoding: 'UTF-8'), sources)]
    end
  rescue OptionParser::ParseError, TabledDocument::MarkError, Trace::FormatError, Interface::Refused, Robot::Refused,
         Errno::ENOENT => e
    abort e.message
  end
  if options[:check]
    findings = documents.values.flat_map(&:findings)
    puts findings
    exit findings.empty?
  end
  documents.each { |file, document| File.write(File.join(options[:root], file), document.text) if document.blocks.any? }
end
