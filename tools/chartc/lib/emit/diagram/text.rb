# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'cgi'

module Chart
  class Diagram
    # Text as Graphviz' HTML-like labels have it: phrases, each of one style, in one line if they fit into the width,
    # else each in lines of its own.
    class Text
      BREAK = '<BR ALIGN="LEFT"/>'
      COLOURS = { quiet: '#66727f', guard: '#8a4b08', work: '#0b5394', time: '#6d3a9c' }.freeze

      def self.escape(text)
        CGI.escapeHTML(text)
      end

      def initialize(width)
        @width = width
        @phrases = []
      end

      # style: :strong or one of the colours. A phrase is broken between its words only.
      def add(style, words)
        @phrases << [style, words] unless words.empty?
        self
      end

      # The same with commas between the words.
      def add_list(style, words, start = nil)
        words = words.each_with_index.map { |word, index| index == words.length - 1 ? word : "#{word}," }
        words = ["#{start} #{words.first}", *words.drop(1)] if start && words.any?
        add(style, words)
      end

      def to_s
        return @phrases.map { |style, words| styled(style, words.join(' ')) }.join(' ') if length <= @width

        @phrases.flat_map { |style, words| lines(words).map { |line| styled(style, line) } }.join(BREAK)
      end

      private

      def length
        @phrases.sum { |_style, words| words.sum(&:length) + words.length } - 1
      end

      def lines(words)
        words.each_with_object([]) do |word, lines|
          fits = lines.any? && lines.last.length + word.length < @width
          fits ? lines.last << ' ' << word : lines << word.dup
        end
      end

      def styled(style, text)
        text = Text.escape(text)
        style == :strong ? "<B>#{text}</B>" : "<FONT COLOR=\"#{COLOURS.fetch(style)}\">#{text}</FONT>"
      end
    end
  end
end
