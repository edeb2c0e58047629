#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Finds in documents what goes stale, or sends its reader to look for a place: "not yet", "as above".
#
#   ruby tools/prose.rb      one line for each, exit 1 if there is any
#
# It does the same in the texts of the console and of its page, and in the sentences of the interface. Numbers with a unit: tools/documents/prose_numbers.rb.

require_relative 'documents/prose_numbers'

# Prose of README.md, docs and the console.
class Prose
  DOCUMENTS = %w[README.md docs/**/*.md].freeze
  TEXTS = %w[app/console/*.html app/console/src/**/*.{ts,tsx} core/interface/*.yml].freeze
  STALE = ['not yet', 'currently', 'at the moment', 'at present', 'for now', 'nowadays', 'recently', 'as above', 'as below',
           'see above', 'see below', 'mentioned above', 'described above', 'described below', 'as mentioned', 'coming soon', 'to be done',
           'TODO', 'TBD'].freeze
  FOUND = /(?<![\w-])(?:#{STALE.map { |phrase| phrase.gsub(' ', '\\s+') }.join('|')})(?![\w-])/i

  def initialize(root)
    @root = root
  end

  # @satisfies SWR-TOOL-027
  # @satisfies SWR-TOOL-038
  def complaints
    stale_in(DOCUMENTS) { |text| words_of(text) } + stale_in(TEXTS) { |text| without_comments(text) }
  end

  private

  def stale_in(files)
    Dir.glob(files, base: @root).grep_v(/\.test\./).sort.flat_map do |file|
      text = yield File.read(File.join(@root, file), encoding: 'UTF-8')
      found_in(text).map { |line, phrase| "#{file}:#{line}: '#{phrase}' goes stale, or names no place" }
    end
  end

  # A phrase may go on in the next line.
  def found_in(text)
    text.to_enum(:scan, FOUND).map { [Regexp.last_match.pre_match.count("\n") + 1, Regexp.last_match[0].gsub(/\s+/, ' ')] }
  end

  # Blocks of code and quoted words are no prose; lines keep their numbers.
  def words_of(text)
    text.gsub(/^```.*?^```|`[^`]*`/m) { |code| code.gsub(/[^\n]/, '') }
  end

  # Readers of a page do not see comments.
  def without_comments(text)
    text.gsub(%r{/\*.*?\*/|^\s*(?://|#).*?$}m) { |comment| comment.gsub(/[^\n]/, '') }
  end
end

if $PROGRAM_NAME == __FILE__
  root = File.expand_path('..', __dir__)
  complaints = Prose.new(root).complaints + ProseNumbers.new(root).complaints
  puts complaints
  exit complaints.empty?
end
