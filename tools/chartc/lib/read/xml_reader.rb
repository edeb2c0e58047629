# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'strscan'
require_relative '../refusal'

module Chart
  # One element: name and attributes without the prefix of SCXML and with "bs:" for ours, child elements, line of its
  # start tag, the comment directly before it, and the line of the first text inside it.
  Element = Struct.new(:name, :attributes, :children, :line, :comment, :text_line) do
    # This element and all inside it, in document order.
    def all
      [self] + children.flat_map(&:all)
    end

    def child(name)
      children.find { |child| child.name == name }
    end
  end

  # Reads the small part of XML that charts use, and keeps the line of every element.
  class XmlReader
    SCXML = 'http://www.w3.org/2005/07/scxml'
    OURS = 'urn:boresight:chart'
    NAME = /[A-Za-z_][\w.-]*(?::[A-Za-z_][\w.-]*)?/.freeze
    QUOTED = /"[^"<]*"|'[^'<]*'/.freeze
    # <?xml ...?>; the encoding stands in its quotes.
    DECLARATION = /<\?xml\s+version\s*=\s*(?:"1\.0"|'1\.0')(?:\s+encoding\s*=\s*(?<encoding>#{QUOTED}))?
                   (?:\s+standalone\s*=\s*(?:#{QUOTED}))?\s*\?>/x.freeze
    # So many elements inside each other.
    DEEPEST = 32
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
      refuse('the file is not UTF-8; save it so') unless @scanner.string.valid_encoding?
      refuse('the file begins with a byte order mark; save it without') if @scanner.check(/\uFEFF/)
      refuse_forbidden
      read_declaration
      skip_between
      root = read_element({}, 1)
      skip_between
      refuse('something stands after the root element; remove it') unless @scanner.eos?
      root
    end

    private

    # Counted on from where it was asked last.
    def line
      @line ||= 1
      @counted ||= 0
      @line += @scanner.string.byteslice(@counted, @scanner.pos - @counted).count("\n")
      @counted = @scanner.pos
      @line
    end

    # XML knows no other control characters, and no U+FFFE or U+FFFF. Those that turn text around are known to XML, but
    # what is read of them, here and in the C, is not what is meant.
    # @satisfies SWR-CHART-043
    def refuse_forbidden
      refuse_character(/[\u0000-\u0008\u000B\u000C\u000E-\u001F\uFFFE\uFFFF]/, 'is forbidden in XML; remove it')
      refuse_character(/[\u061C\u200E\u200F\u202A-\u202E\u2066-\u2069]/, 'turns around what is read; remove it')
    end

    def refuse_character(set, words)
      stray = @scanner.search_full(set, false, true) || return
      @scanner.pos += stray.bytesize - stray[-1].bytesize
      refuse(format('the character U+%<code>04X %<words>s', code: stray[-1].ord, words: words))
    end

    def read_declaration
      return unless @scanner.check(/\s*<\?xml\s/)

      @scanner.skip(DECLARATION) ||
        refuse('this is no XML declaration; write <?xml version="1.0" encoding="UTF-8"?>')
      encoding = @scanner[:encoding]&.slice(1..-2)
      return if encoding.nil? || %w[UTF-8 US-ASCII].include?(encoding.upcase)

      refuse("the declared encoding is #{encoding}; save the file as UTF-8 and write encoding=\"UTF-8\"")
    end

    def refuse(message, rule = 1)
      raise Refusal.new(@file, line, rule, message)
    end

    def refuse_markup
      refuse('neither an element nor a comment; remove the DTD, CDATA, instruction or stray <')
    end

    def skip_between
      @comment = nil
      loop do
        @scanner.skip(/\s+/)
        break unless @scanner.skip(/<!--/)

        text = @scanner.scan_until(/--/) || refuse('comment without end; write -->')
        @scanner.skip(/>/) || refuse('"--" stands inside a comment, which XML forbids; write a single dash')
        @comment = text.delete_suffix('--').strip.gsub(/\s+/, ' ')
      end
    end

    # scope: prefix => namespace, as declared around the element.
    def read_element(scope, depth)
      refuse("more than #{DEEPEST} elements stand inside each other; split the chart", 19) if depth > DEEPEST
      element = Element.new(nil, {}, [], line, @comment)
      @scanner.skip(/</) || refuse('no element stands here; write <scxml ...>')
      tag = @scanner.scan(NAME) || refuse_markup
      read_attributes(element)
      scope = resolve_names(element, tag, scope)
      return element if @scanner.skip(%r{/>})

      @scanner.skip(/>/) || refuse("start tag of <#{tag}> does not end; write > or />")
      read_children(element, tag, scope, depth)
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
      quoted = @scanner.scan(QUOTED) || refuse("attribute #{name} is not in quotes; write #{name}=\"...\"")
      quoted[1..-2].gsub(/&[^;\s]*;?/) do |entity|
        ENTITIES.fetch(entity) { refuse("#{entity} is not known; write &amp; for &") }
      end
    end

    def resolve_names(element, tag, outer)
      declared = element.attributes.select { |name, _uri| name == 'xmlns' || name.start_with?('xmlns:') }
      scope = outer.merge(declared.transform_keys { |name| name.delete_prefix('xmlns').delete_prefix(':') })
      element.name = resolve(tag, scope)
      names = element.attributes.keys.to_h do |name|
        [name, name.include?(':') && !declared.key?(name) ? resolve(name, scope) : name]
      end
      twice = names.values.find { |name| names.values.count(name) > 1 }
      refuse("attribute #{twice} stands twice, under two prefixes; write it once") if twice
      element.attributes = element.attributes.transform_keys(names)
      scope
    end

    def resolve(name, scope)
      *prefix, local = name.split(':')
      return local if prefix.empty?

      case scope.fetch(prefix.first) { refuse("prefix #{prefix.first} is unknown; declare xmlns:#{prefix.first}") }
      when SCXML then local
      when OURS then "bs:#{local}"
      else name
      end
    end

    def read_children(element, tag, scope, depth)
      loop do
        skip_between
        break if @scanner.check(%r{</})
        next if skip_text(element)

        element.children << read_element(scope, depth + 1)
      end
      name = @scanner.scan(%r{</#{Regexp.escape(tag)}\s*>})
      refuse("<#{tag}> of line #{element.line} is not closed; write </#{tag}>") unless name
    end

    # Text is kept by its line only: whether it or its element is refused is for the profile to say.
    def skip_text(element)
      here = line
      found = @scanner.skip(/[^<]+/)
      element.text_line ||= here if found
      refuse("<#{element.name}> is not closed; add its end tag") if @scanner.eos?
      refuse_markup unless found || @scanner.check(/<[A-Za-z_]/)
      found
    end
  end
end
