# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'psych'

# Knowledge of the tools about hazards, risk controls and software requirements.
#
# The files are read as a tree of nodes, not as values: every scalar stays the text that was written
# (`1.10`, `no`), and every item knows its line.
module Trace
  # A place in a file, printed as `file:line`.
  Place = Struct.new(:file, :line) do
    def to_s
      "#{file}:#{line}"
    end
  end

  # A number that a requirement states, and that C code and boundary tests use by name.
  Limit = Struct.new(:name, :value, :unit, :status, :requirement, :place, keyword_init: true)

  # One entry of a requirements file; `fields` holds everything but id and limits.
  Item = Struct.new(:id, :fields, :limits, :place, keyword_init: true) do
    def [](key)
      fields[key]
    end

    def title
      fields['title'].to_s
    end

    # Ids this item descends from; `derived: reason` is not among them.
    def parents
      Array(fields['parents']).reject { |parent| parent.start_with?('derived:') }
    end

    # The fragment of a link by which a page plays it.
    def scene
      fields['scene']&.delete(" \n")
    end

    def derived?
      Array(fields['parents']).any? { |parent| parent.match?(/\Aderived:\s*\S/) }
    end

    def kind
      id[/\A[A-Z]+/]
    end
  end

  # A file that cannot be read as requirements.
  class FormatError < StandardError; end

  # All items below one folder, in order of file name and line.
  class Requirements
    attr_reader :items

    # Places are relative to `root`.
    def self.load(folder, root = '.')
      new(Dir.glob(File.join(folder, '**', '*.yml'), base: root), root)
    end

    def initialize(files, root = '.')
      @root = root
      @items = files.sort.flat_map { |file| read(file) }
    end

    def of_kind(kind)
      items.select { |item| item.kind == kind }
    end

    def limits
      items.flat_map(&:limits)
    end

    # The sentence with each `{limit_name}` replaced by its value and unit.
    def sentence(item)
      item['text'].to_s.gsub(/\{(\w+)\}/) do
        limit = limits_by_name[Regexp.last_match(1)]
        limit ? [limit.value, limit.unit].compact.join(' ') : Regexp.last_match(0)
      end
    end

    def limits_by_name
      @limits_by_name ||= limits.to_h { |limit| [limit.name, limit] }
    end

    private

    def read(file)
      root = Psych.parse_file(File.expand_path(file, @root))&.root
      raise FormatError, "#{file}:1: expected a list of items" unless root.is_a?(Psych::Nodes::Sequence)

      root.children.map { |node| item(node, file) }
    rescue Psych::SyntaxError => e
      raise FormatError, "#{file}:#{e.line}: #{e.problem} #{e.context}".strip
    end

    def item(node, file)
      place = Place.new(file, node.start_line + 1)
      raise FormatError, "#{place}: expected an item with an id" unless node.is_a?(Psych::Nodes::Mapping)

      fields = pairs(node, file)
      id = plain(fields.delete('id'))
      raise FormatError, "#{place}: an item has no id" unless id.is_a?(String) && !id.empty?

      limits = limits_of(fields.delete('limits'), id, file)
      Item.new(id: id, fields: fields.transform_values { |value| plain(value) }, limits: limits, place: place)
    end

    def pairs(node, file)
      node.children.each_slice(2).with_object({}) do |(key, value), fields|
        place = Place.new(file, key.start_line + 1)
        raise FormatError, "#{place}: #{key.value} is given twice" if fields.key?(key.value)

        fields[key.value] = value
      end
    end

    def limits_of(node, id, file)
      return [] if node.nil?

      node.children.map do |child|
        place = Place.new(file, child.start_line + 1)
        fields = pairs(child, file).transform_values { |value| plain(value) }
        Limit.new(name: fields['name'], value: fields['value'], unit: fields['unit'],
                  status: fields['status'], requirement: id, place: place)
      end
    end

    def plain(node)
      case node
      when Psych::Nodes::Scalar then node.value
      when Psych::Nodes::Sequence then node.children.map { |child| plain(child) }
      when Psych::Nodes::Mapping
        # `- derived: reason` in a list of parents reads as one text.
        pairs = node.children.each_slice(2).to_h { |key, value| [key.value, plain(value)] }
        pairs.keys == ['derived'] ? "derived: #{pairs['derived']}" : pairs
      end
    end
  end
end
