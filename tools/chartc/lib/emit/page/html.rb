# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'cgi'

module Chart
  # Pieces of HTML. What comes in as text is escaped; what comes in as Markup is not.
  module Html
    # A piece of HTML that is ready.
    Markup = Struct.new(:text) do
      def to_s
        text
      end
    end

    module_function

    def escape(piece)
      piece.is_a?(Markup) ? piece.text : CGI.escapeHTML(piece.to_s)
    end

    def markup(text)
      Markup.new(text)
    end

    # Text in an element; kind is its class.
    def tag(name, content, kind = nil)
      markup("<#{name}#{" class=\"#{kind}\"" if kind}>#{escape(content)}</#{name}>")
    end

    def link(address, text)
      markup("<a href=\"#{escape(address)}\">#{escape(text)}</a>")
    end

    def code(words)
      join(Array(words).map { |word| tag('code', word) }, ' ')
    end

    def lines(pieces)
      join(pieces, '<br>')
    end

    def join(pieces, between)
      markup(pieces.map { |piece| escape(piece) }.join(between))
    end

    # Columns without anything in them are left out. The first column heads its row.
    def table(heads, rows, kind = nil)
      kept = heads.each_index.reject { |column| rows.all? { |row| escape(row[column]).empty? } }
      top = kept.map { |column| head(heads[column], rows.map { |row| row[column] }) }
      body = rows.map { |row| "<tr>#{kept.map { |column| cell(row[column], column) }.join}</tr>" }
      markup("<div class=\"scroll\"><table#{" class=\"#{kind}\"" if kind}>\n<thead><tr>#{top.join}</tr></thead>\n" \
             "<tbody>\n#{body.join("\n")}\n</tbody></table></div>\n")
    end

    def head(title, cells)
      numbers = cells.compact.all?(Integer)
      "<th scope=\"col\"#{' class="number"' if numbers}>#{escape(title)}</th>"
    end

    def cell(piece, column)
      return "<th scope=\"row\">#{escape(piece)}</th>" if column.zero?

      number = piece.is_a?(Integer) ? ' class="number"' : ''
      "<td#{number}>#{escape(piece.is_a?(Integer) ? grouped(piece) : piece)}</td>"
    end

    def grouped(number)
      number.to_s.gsub(/(\d)(?=(\d{3})+\z)/, '\1 ')
    end
  end
end
