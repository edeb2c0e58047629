# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'yaml'
require_relative '../trace/requirements'

# Finds spans of time, sizes and counts in documents that have no source, or another value than it (tools/documents/prose_numbers.yml). A
# value in a table that tools/tables.rb fills, in code and in an indented block, is none of its matter.
class ProseNumbers
  LIST = 'tools/documents/prose_numbers.yml'
  # How much each unit of documents, limits and constants is, by what it measures.
  MEASURES = {
    time: { 'us' => 1, 'µs' => 1, 'ms' => 1000, 's' => 1_000_000, 'second' => 1_000_000, 'min' => 60_000_000, 'minute' => 60_000_000,
            'h' => 3_600_000_000, 'hour' => 3_600_000_000, 'day' => 86_400_000_000, 'cycles' => 1000, 'looks' => 10_000 },
    memory: { 'bytes' => 1, 'kB' => 1000, 'KiB' => 1024, 'MB' => 1_000_000 },
    length: { 'nm' => 1, 'um' => 1000, 'µm' => 1000, 'mm' => 1_000_000 },
    angle: { 'bam' => 360.0 / (2**32), 'degrees' => 1, 'µrad' => 180e-6 / Math::PI },
    speed: { '0.1 ticks/s' => 0.1, 'ticks/s' => 1, 'mm/s' => 1 },
    frequency: { 'Hz' => 1, 'kHz' => 1000, 'Hz x 22009' => 1.0 / 22_009 },
    heat: { '0.1 degree Celsius' => 0.1, '°C' => 1 },
    current: { 'mA' => 1 },
    share: { 'percent' => 1, '%' => 1 }
  }.merge(%w[ticks rows files points entries cards clients connections instructions].to_h { |name| [name.to_sym, { name => 1 }] }).freeze
  UNITS = MEASURES.flat_map { |measure, units| units.map { |unit, size| [unit, [measure, size]] } }.to_h.merge('counts' => [:ticks, 1]).freeze

  WORDS = { 'one' => 1, 'two' => 2, 'three' => 3, 'four' => 4, 'five' => 5, 'six' => 6, 'seven' => 7, 'eight' => 8, 'ten' => 10,
            'twelve' => 12, 'fifteen' => 15, 'twenty' => 20, 'thirty' => 30 }.freeze
  NUMBER = '\d[\d.,]*'
  # Only spans of time are also found in words: "two cards" is seldom a count that has a source.
  SPAN = /(?<![\w.,:-])(?<count>#{NUMBER}|#{WORDS.keys.join('|')})\s+(?<unit>[uµ]s|ms|s|min|h|seconds?|minutes?|hours?|days?)(?![\w-])/i
  SIZES = UNITS.keys.select { |unit| unit.match?(/\A\D+\z/) } - MEASURES[:time].keys + %w[cycles] - %w[bam]
  SIZE = %r{(?<![\w.,:-])(?<count>#{NUMBER})\s+(?<unit>#{Regexp.union(SIZES.sort_by { |unit| -unit.size })})(?![\w/-])}
  # A number without a unit is compared where it is listed.
  COUNT = /(?<![\w.,:-])(?<count>#{NUMBER}|#{WORDS.keys.join('|')})(?<unit>)(?!\w)/i

  def initialize(root)
    @root = root
    file = File.join(root, LIST)
    @list = File.exist?(file) ? YAML.safe_load_file(file) : {}
  end

  # @satisfies SWR-TOOL-037
  # @satisfies SWR-TOOL-046
  def complaints
    @list.flat_map { |file, entries| complaints_of(file, prose_of(file), entries) }
  end

  private

  def complaints_of(file, text, entries)
    covered = entries.to_h { |entry| [entry, places_of(entry['says'], text)] }
    gone = covered.select { |_entry, places| places.empty? }.keys
    gone.map { |entry| "#{LIST}: #{file} does not say '#{entry['says']}'" } + entries.filter_map { |entry| difference(entry, file) } +
      numbers_in(text).reject { |place, _number| covered.values.flatten.any? { |range| range.cover?(place) } }
                      .map { |place, number| "#{file}:#{text[0...place].count("\n") + 1}: '#{number}' has no source in #{LIST}" }
  end

  # An entry without a source is an example, or said of the world: why stands beside it.
  def difference(entry, file)
    return if entry['because']

    value, unit = entry['limit'] ? value_of_limit(entry['limit']) : value_of_constant(entry)
    said = said_in([SPAN, SIZE, COUNT].filter_map { |pattern| pattern.match(entry['says']) }.first)
    return if value && amount(*said) == amount(value, said.last ? unit : nil)

    "#{file}: '#{entry['says']}', but #{entry['limit'] || entry['constant']} is #{value ? "#{value} #{unit}" : 'not there'}"
  end

  def value_of_limit(name)
    limit = limits[name]
    limit && [limit.value, limit.unit]
  end

  def limits
    @limits ||= Trace::Requirements.load('requirements', @root).limits_by_name
  end

  def value_of_constant(entry)
    text = File.read(File.join(@root, entry['file']))
    value = text[/\b#{Regexp.escape(entry['constant'])}\b[^\n]*?(?<!\w)(\d[\d_.]*)/, 1]
    value && [value.delete('_'), entry['unit']]
  end

  def said_in(match)
    unit = match[:unit] unless match[:unit].empty?
    [WORDS[match[:count].downcase] || match[:count].delete(','), unit && !UNITS.key?(unit) ? unit.downcase.delete_suffix('s') : unit]
  end

  # Angles of limits are whole numbers of their small unit.
  def amount(value, unit)
    measure, size = unit ? UNITS.fetch(unit) : [:count, 1]
    [measure, (value.to_f * size).round(4)]
  end

  def numbers_in(text)
    [SPAN, SIZE].flat_map do |pattern|
      text.to_enum(:scan, pattern).map { [Regexp.last_match.begin(0), Regexp.last_match[0].gsub(/\s+/, ' ')] }
    end
  end

  # A phrase may go on in the next line.
  def places_of(phrase, text)
    pattern = /#{phrase.split.map { |word| Regexp.escape(word) }.join('\s+')}/
    text.to_enum(:scan, pattern).map { Regexp.last_match.begin(0)...Regexp.last_match.end(0) }
  end

  def prose_of(file)
    text = File.read(File.join(@root, file), encoding: 'UTF-8')
    text.gsub(/^<!-- table:.*?^<!-- end -->|^```.*?^```|^ {4}.*?$/m) { |part| part.gsub(/[^\n]/, '') }
  end
end
