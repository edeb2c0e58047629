#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Holds the records of docs/decisions against the project: each has a number, context, decision and consequence, and what it
# names under "Held by" and quotes in its prose is there.
#
#   ruby tools/decisions.rb      one line for each that is not so, exit 1 if there is any
#
# Under "Held by" stands what would change with the decision: files, functions, tests and requirements, and
#
#   - Rights of both: `JOG`, ...                         what only one sender, or both, may command, in whole
#   - Row `core/interface/modes.yml` `JOG`: `axes: ALL`  a field of the item of this name in a file

require_relative 'documents/project_names'

# One record.
class Decision
  FOLDER = 'docs/decisions'
  PARTS = %w[Context Decision Consequence].freeze

  attr_reader :file

  def initialize(root, file)
    @file = file
    @text = File.read(File.join(root, file), encoding: 'UTF-8')
  end

  def number
    File.basename(@file)[/\A\d{3}(?=-[a-z0-9-]+\.md\z)/].to_s
  end

  def title
    @text[/\A# #{number}: (\S.*)$/, 1]
  end

  def whole?
    @text.scan(/^\*\*(\w+)\.\*\* \S/).flatten == PARTS
  end

  def held_by
    @text[/^## Held by\n\n((?:.+\n)+)\z/, 1].to_s.split(/^- /).drop(1).map { |line| line.tr("\n", ' ') }
  end

  # Line by line, what is quoted in prose.
  def quotes
    DocumentQuotes.new(@text[/\A.*?(?=^## Held by)/m] || @text).quotes
  end
end

# Names that a document has in backticks, with their line; a block of code is none of them.
class DocumentQuotes
  def initialize(text)
    @text = text
  end

  def quotes
    blank = @text.gsub(/^```.*?^```/m) { |block| block.gsub(/[^\n]/, '') }
    blank.lines.each.with_index(1).flat_map { |line, number| line.scan(/`([^`]+)`/).flatten.map { |quote| [number, quote] } }
  end
end

# All records, and the page that refers to them.
class Decisions
  PAGE = 'docs/architecture.md'
  SENDERS = %w[IGTL HTTP].freeze
  # Where the rows of commands stand.
  RIGHTS = %w[core/interface/commands.yml core/interface/modes.yml].freeze

  attr_reader :records

  def initialize(root, names: ProjectNames.new(root))
    @root = root
    @names = names
    @records = Dir.glob("#{Decision::FOLDER}/*", base: root).sort.map { |file| Decision.new(root, file) }
  end

  # @satisfies SWR-TOOL-026
  def complaints
    numbers + records.flat_map { |record| of_record(record) } + of_page
  end

  private

  def numbers
    expected = (1..records.size).map { |number| format('%03d', number) }
    records.map(&:number) == expected ? [] : ["#{Decision::FOLDER}: numbers are not 001 to #{expected.last}"]
  end

  def of_record(record)
    wrong = []
    wrong << 'its first line is not its number and title' unless record.title
    wrong << "it does not consist of #{Decision::PARTS.join(', ')}" unless record.whole?
    wrong << 'nothing would show that it has changed' if record.held_by.empty?
    wrong += record.held_by.filter_map { |line| of_line(line) } + of_quotes(record.quotes)
    wrong.map { |reason| "#{record.file}: #{reason}" }
  end

  def of_line(line)
    names = line.scan(/`([^`]+)`/).flatten
    case line
    when /\ARights of (both|(\w+) alone): / then of_rights(Regexp.last_match(1), names)
    when /\ARow / then of_row(*names)
    else names.size == 1 && held?(names.first) ? nil : "there is no #{names.first}"
    end
  end

  def held?(name)
    name.end_with?('()') ? @names.quoted?(name) : @names.there?(name)
  end

  def of_rights(whose, kinds)
    rights = SENDERS.to_h { |sender| [sender, rights_of(sender)] }
    both = rights.values.reduce(:&)
    found = whose == 'both' ? both : rights.fetch(whose[/\w+/]) - both
    "the rights of #{whose} differ by #{((found | kinds) - (found & kinds)).sort.join(', ')}" unless found.sort == kinds.sort
  end

  def rights_of(sender)
    files = RIGHTS.map { |file| File.join(@root, file) }
    commands(files.map { |file| YAML.safe_load_file(file) }).select { |row| row['from'].include?(sender) }.map { |row| row['name'] }
  end

  # The mappings below `node` that say who may send them.
  def commands(node)
    case node
    when Array then node.flat_map { |one| commands(one) }
    when Hash then node.key?('from') ? [node] : commands(node.values)
    else []
    end
  end

  def of_row(file, name, field)
    key, value = field.split(': ', 2)
    found = items(YAML.safe_load_file(File.join(@root, file)), name).filter_map { |item| item[key] }.map { |one| Array(one).join(', ') }
    "#{key} of #{name} in #{file} is #{found.empty? ? 'not there' : found.join('; ')}" unless found == [value]
  rescue Errno::ENOENT
    "there is no #{file}"
  end

  # The mappings below `node` that have this name.
  def items(node, name)
    case node
    when Hash then (node['name'] == name ? [node] : []) + node.values.flat_map { |child| items(child, name) }
    when Array then node.flat_map { |child| items(child, name) }
    else []
    end
  end

  def of_page
    of_quotes(DocumentQuotes.new(File.read(File.join(@root, PAGE), encoding: 'UTF-8')).quotes).map { |reason| "#{PAGE}: #{reason}" }
  end

  def of_quotes(quotes)
    quotes.filter_map { |number, quote| "line #{number}: there is no #{quote}" unless @names.quoted?(quote) }
  end
end

if $PROGRAM_NAME == __FILE__
  complaints = Decisions.new(File.expand_path('..', __dir__)).complaints
  puts complaints
  exit complaints.empty?
end
