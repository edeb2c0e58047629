# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative '../robot/document'

module Interface
  Refused = Robot::Refused

  # One node of a file of core/interface.
  #
  # @satisfies SWR-TOOL-012
  class Node < Robot::Node
    NUMBER = (0..(2**31) - 1)

    # Words for people: one line, whatever the file's lines are.
    def text
      refuse('is not a text') unless scalar?
      refuse('is empty; expected a text') if @yaml.value.strip.empty?
      refuse('holds the end of a comment') if @yaml.value.include?('*/')
      @yaml.value.strip.gsub(/\s+/, ' ')
    end

    # A name in C.
    def identifier(capitals: false)
      pattern, letters = capitals ? [/\A[A-Z][A-Z0-9_]*\z/, 'A-Z'] : [/\A[a-z][a-z0-9_]*\z/, 'a-z']
      refuse("is #{plain}; expected a name of #{letters}, 0-9 and _") unless plain.match?(pattern)
      plain
    end

    # The node of `key` in a mapping that may hold others; nil without it.
    def at(key)
      pair = @yaml.children.each_slice(2).find { |name, _| name.value == key } if @yaml.is_a?(Psych::Nodes::Mapping)
      pair && self.class.new(@file, child_field(key), pair.last)
    end

    # The nodes of a mapping with any keys.
    def all
      refuse('is not a mapping of keys to values') unless @yaml.is_a?(Psych::Nodes::Mapping)
      pairs(@yaml.children.each_slice(2).map { |key, _| key.value })
    end

    # The top of what a row stands for, as if it were written in its file.
    def stands_for(plain, texts)
      lines = plain.map { |key, value| "#{key}: #{value}" } + texts.map { |key, value| "#{key}: #{value.inspect}" }
      self.class.parse(@file, lines.join("\n"))
    end

    # Words between spaces.
    def words
      plain.split
    end

    def number
      integer(NUMBER)
    end

    def true?
      choice(%w[true false]) == 'true'
    end

    def scalar?
      @yaml.is_a?(Psych::Nodes::Scalar)
    end

    def list?
      @yaml.is_a?(Psych::Nodes::Sequence)
    end
  end
end
