#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Finds in documents what goes stale, or sends its reader to look for a place: "not yet", "as above".
#
#   ruby tools/prose.rb      one line for each, exit 1 if there is any

# What README.md and docs say in words.
class Prose
  STALE = ['not yet', 'currently', 'at the moment', 'at present', 'for now', 'nowadays', 'recently', 'as above',
           'as mentioned', 'to be done', 'TODO', 'TBD'].freeze
  FOUND = /(?<![\w-])(?:#{STALE.map { |phrase| phrase.gsub(' ', '\\s+') }.join('|')})(?![\w-])/i

  def initialize(root)
    @root = root
  end

  # @satisfies SWR-TOOL-027
  def complaints
    Dir.glob(%w[README.md docs/**/*.md], base: @root).sort.flat_map do |file|
      text = words_of(File.read(File.join(@root, file), encoding: 'UTF-8'))
      found_in(text).map { |line, phrase| "#{file}:#{line}: '#{phrase}' goes stale, or names no place" }
    end
  end

  private

  # A phrase may go on in the next line.
  def found_in(text)
    text.to_enum(:scan, FOUND).map { [Regexp.last_match.pre_match.count("\n") + 1, Regexp.last_match[0].gsub(/\s+/, ' ')] }
  end

  # Blocks of code and quoted words are nobody's prose; lines keep their numbers.
  def words_of(text)
    text.gsub(/^```.*?^```|`[^`]*`/m) { |code| code.gsub(/[^\n]/, '') }
  end
end

if $PROGRAM_NAME == __FILE__
  complaints = Prose.new(File.expand_path('..', __dir__)).complaints
  puts complaints
  exit complaints.empty?
end
