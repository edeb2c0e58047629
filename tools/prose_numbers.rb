# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'yaml'
require_relative 'trace/requirements'

# Finds spans of time in documents that have no source, or another value than it (tools/prose_numbers.yml). What stands in a
# table that tools/tables.rb fills, and in an indented block, is none of its matter.
class ProseNumbers
  LIST = 'tools/prose_numbers.yml'
  US = { 'us' => 1, 'ms' => 1000, 's' => 1_000_000, 'second' => 1_000_000, 'min' => 60_000_000, 'minute' => 60_000_000,
         'h' => 3_600_000_000, 'hour' => 3_600_000_000, 'cycles' => 1000,
         'looks' => 10_000 }.freeze
  WORDS = { 'one' => 1, 'two' => 2, 'three' => 3, 'five' => 5, 'ten' => 10, 'twelve' => 12, 'fifteen' => 15, 'twenty' => 20,
            'thirty' => 30 }.freeze
  SPAN = /(?<![\w.,:-])(?<count>\d[\d.,]*|#{WORDS.keys.join('|')})\s+(?<unit>us|ms|s|min|h|seconds?|minutes?|hours?)(?![\w-])/i

  def initialize(root)
    @root = root
    file = File.join(root, LIST)
    @list = File.exist?(file) ? YAML.safe_load_file(file) : {}
  end

  # @satisfies SWR-TOOL-037
  def complaints
    @list.flat_map { |file, entries| complaints_of(file, prose_of(file), entries) }
  end

  private

  def complaints_of(file, text, entries)
    covered = entries.to_h { |entry| [entry, places_of(entry['says'], text)] }
    gone = covered.select { |_entry, places| places.empty? }.keys
    gone.map { |entry| "#{LIST}: #{file} does not say '#{entry['says']}'" } + entries.filter_map { |entry| difference(entry, file) } +
      spans_in(text).reject { |place, _span| covered.values.flatten.any? { |range| range.cover?(place) } }
                    .map { |place, span| "#{file}:#{text[0...place].count("\n") + 1}: '#{span}' has no source in #{LIST}" }
  end

  # An entry without a source is an example, or said of the world: why stands beside it.
  def difference(entry, file)
    return if entry['because']

    wanted = entry['limit'] ? limit_us(entry['limit']) : constant_us(entry)
    found = us_of(SPAN.match(entry['says']))
    "#{file}: '#{entry['says']}', but #{entry['limit'] || entry['constant']} is #{wanted || 'not there'}" if found != wanted
  end

  def limit_us(name)
    limit = limits[name]
    limit && (limit.value.to_i * US.fetch(limit.unit))
  end

  def limits
    @limits ||= Trace::Requirements.load('requirements', @root).limits_by_name
  end

  def constant_us(entry)
    text = File.read(File.join(@root, entry['file']))
    value = text[/\b#{Regexp.escape(entry['constant'])}\b[^\n]*?(?<!\w)(\d[\d_.]*)/, 1]
    value && (value.delete('_').to_f * US.fetch(entry['unit'])).round
  end

  def us_of(span)
    count = WORDS[span[:count].downcase] || span[:count].delete(',').to_f
    (count * US.fetch(span[:unit].size > 2 ? span[:unit].delete_suffix('s') : span[:unit])).round
  end

  def spans_in(text)
    text.to_enum(:scan, SPAN).map { [Regexp.last_match.begin(0), Regexp.last_match[0].gsub(/\s+/, ' ')] }
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
