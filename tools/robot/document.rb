# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'psych'

module Robot
  # A robot file that is refused: where and why.
  class Refused < StandardError
    def initialize(place, field, reason)
      super("#{place}: #{field}: #{reason}")
    end
  end

  # One node of a YAML file that knows its file, line and field.
  class Node
    attr_reader :field, :line

    def initialize(file, field, yaml, line: nil)
      @file = file
      @field = field
      @yaml = yaml
      @line = line || (yaml.start_line + 1)
    end

    # The top of the file `path` with the content `text`.
    def self.parse(path, text)
      document = Psych.parse(text)
      raise Refused.new("#{path}:1", 'file', 'is empty; expected a robot') unless document

      new(path, 'file', document.root)
    rescue Psych::SyntaxError => e
      raise Refused.new("#{path}:#{e.line}", 'file', "is not YAML: #{[e.problem, e.context].compact.join(' ')}")
    end

    def refuse(reason)
      raise Refused.new("#{@file}:#{@line}", @field, reason)
    end

    # The nodes of a mapping by key. Exactly the keys of `required` and, if present, of `optional`.
    def mapping(required, optional = [])
      refuse('is not a mapping of keys to values') unless @yaml.is_a?(Psych::Nodes::Mapping)
      nodes = pairs(required + optional)
      absent = (required - nodes.keys).first
      refuse_key(absent, @line, 'is missing') if absent
      nodes
    end

    def sequence
      refuse('is not a list') unless @yaml.is_a?(Psych::Nodes::Sequence)
      @yaml.children.each_with_index.map { |child, i| self.class.new(@file, "#{@field}[#{i}]", child) }
    end

    def integer(range)
      text = plain
      refuse("is #{text}; expected a whole number") unless text.match?(/\A(0|-?[1-9][0-9]*)\z/)
      in_range(Integer(text, 10), range)
    end

    def decimal(range)
      text = plain
      refuse("is #{text}; expected a number such as 18.32") unless text.match?(/\A-?[0-9]+(\.[0-9]+)?\z/)
      in_range(Rational(text), range)
    end

    def choice(values)
      text = plain
      refuse("is #{text}; expected #{values.join(' or ')}") unless values.include?(text)
      text
    end

    def name(longest = 11)
      text = plain
      refuse("is #{text}; expected 1 to #{longest} of a-z, 0-9 and _") \
        unless text.match?(/\A[a-z][a-z0-9_]{0,#{longest - 1}}\z/)
      text
    end

    # A number and one of `units`.
    def quantity(units)
      number, unit = plain.split(' ', 2)
      is_whole = unit != 'ticks' || number.match?(/\A-?[0-9]+\z/)
      refuse("is #{plain}; expected a number and #{units.join(' or ')}") \
        unless number.match?(/\A-?[0-9]+(\.[0-9]+)?\z/) && units.include?(unit) && is_whole
      [Rational(number), unit]
    end

    # As it stands there.
    def word
      plain
    end

    # major << 16 | minor << 8 | patch
    def version
      text = plain
      refuse("is #{text}; expected a version such as 1.2.0") unless text.match?(/\A(?:[0-9]{1,2}\.){2}[0-9]{1,2}\z/)
      text.split('.').map { |part| Integer(part, 10) }.inject { |sum, part| (sum << 8) | part }
    end

    private

    def plain
      refuse('is not a plain value') unless @yaml.is_a?(Psych::Nodes::Scalar) && @yaml.plain && !@yaml.value.empty?
      @yaml.value
    end

    def in_range(value, range)
      return value if range.cover?(value)

      refuse("is #{plain}; expected #{range.begin} to #{range.end}")
    end

    def pairs(allowed)
      @yaml.children.each_slice(2).with_object({}) do |(key, value), nodes|
        line = key.start_line + 1
        name = key.is_a?(Psych::Nodes::Scalar) ? key.value : '?'
        refuse_key(name, line, "is unknown; expected #{allowed.join(', ')}") unless allowed.include?(name)
        refuse_key(name, line, 'is given twice') if nodes.key?(name)
        nodes[name] = self.class.new(@file, child_field(name), value, line: line)
      end
    end

    def refuse_key(name, line, reason)
      raise Refused.new("#{@file}:#{line}", child_field(name), reason)
    end

    def child_field(name)
      @field == 'file' ? name : "#{@field}.#{name}"
    end
  end
end
