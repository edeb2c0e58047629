# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'strscan'
require_relative 'refusal'

module Chart
  # One element: qualified name, attributes in file order, child elements, line of its start tag,
  # and the comment that stands directly before it.
  Element = Struct.new(:name, :attributes, :children, :line, :comment)

  # Reads the small part of XML that charts use, and keeps the line of every element.
  class XmlReader
    NAME = /[A-Za-z_][\w.-]*(?::[A-Za-z_][\w.-]*)?/.freeze
    ENTITIES = { '&amp;' => '&', '&lt;' => '<', '&gt;' => '>', '&quot;' => '"', '&apos;' => "'" }.freeze

    def self.read(file, text)
      new(file, text).read
    end

    def initialize(file, text)
      @file = file
      @scanner = StringScanner.new(text)
      @comment = nil
    end

    def read
      @scanner.skip(/<\?xml[^?]*\?>/)
      skip_between
      root = read_element
      skip_between
      refuse('text after the root element; remove it') unless @scanner.eos?
      root
    end

    private

    def line
      @scanner.string.byteslice(0, @scanner.pos).count("\n") + 1
    end

    def refuse(message)
      raise Refusal.new(@file, line, 1, message)
    end

    def skip_between
      @comment = nil
      loop do
        @scanner.skip(/\s+/)
        break unless @scanner.skip(/<!--/)

        text = @scanner.scan_until(/-->/) || refuse('comment without end; write -->')
        @comment = text.delete_suffix('-->').strip.gsub(/\s+/, ' ')
      end
    end

    def read_element
      element = Element.new(nil, {}, [], line, @comment)
      @scanner.skip(/</) || refuse('expected an element; write <name ...>')
      element.name = @scanner.scan(NAME) || refuse('expected the name of an element')
      read_attributes(element)
      return element if @scanner.skip(%r{/>})

      @scanner.skip(/>/) || refuse("start tag of <#{element.name}> does not end; write > or />")
      read_children(element)
      element
    end

    def read_attributes(element)
      while @scanner.skip(/\s+/) && (name = @scanner.scan(NAME))
        refuse("attribute #{name} stands twice; write it once") if element.attributes.key?(name)
        @scanner.skip(/\s*=\s*/) || refuse("attribute #{name} has no value; write #{name}=\"...\"")
        element.attributes[name] = read_value(name)
      end
    end

    def read_value(name)
      quoted = @scanner.scan(/"[^"<]*"|'[^'<]*'/) || refuse("attribute #{name} is not in quotes")
      quoted[1..-2].gsub(/&[^;\s]*;?/) do |entity|
        ENTITIES.fetch(entity) { refuse("#{entity} is not known; write &amp; for &") }
      end
    end

    def read_children(element)
      loop do
        skip_between
        break if @scanner.check(%r{</})

        refuse("text inside <#{element.name}>; only elements may stand here") unless @scanner.check(/<[A-Za-z_]/)
        element.children << read_element
      end
      name = @scanner.scan(%r{</#{Regexp.escape(element.name)}\s*>})
      refuse("<#{element.name}> of line #{element.line} is not closed; write </#{element.name}>") unless name
    end
  end
end
