# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'json'

# Software that is linked into programs, as the first table of docs/soup.md has it.
class Soup
  FILE = 'docs/soup.md'
  # A row: what it is called, names of its packages, their versions, what it is linked into, licence.
  Item = Struct.new(:title, :names, :versions, :into, :licence) do
    def npm?
      into.start_with?('console')
    end

    # With its version each, or the title with the one of all.
    def parts
      versions.size > 1 ? names.zip(versions) : [[title, versions.first]]
    end

    def purl(name, version)
      npm? ? "pkg:npm/#{name}@#{version}" : "pkg:deb/debian/#{names.last}@#{version}?distro=bookworm"
    end

    # The Debian package that a program needs where it runs.
    def library
      names.grep_v(/-dev\z/).first unless npm?
    end

    def only_of_board
      into[/of the board `(\w+)`/, 1]
    end
  end

  def initialize(text)
    rows = text[/^## 1\..*?^(?=###|## 2)/m].lines.grep(/^\| /).drop(2)
    @items = rows.map { |row| item(row.split('|').map(&:strip).drop(1)) }
  end

  # Items of a board's programs.
  def items(board)
    @items.select { |item| [nil, board].include?(item.only_of_board) }
  end

  # @satisfies SWR-PACK-006
  def bill(board, version, time)
    JSON.pretty_generate(
      bomFormat: 'CycloneDX', specVersion: '1.5', version: 1,
      metadata: { timestamp: time.utc.strftime('%Y-%m-%dT%H:%M:%SZ'),
                  component: { type: 'application', name: 'boresight', version: version,
                               licenses: [{ license: { id: 'Apache-2.0' } }] } },
      components: items(board).flat_map { |item| item.parts.map { |name, its| component(item, name, its) } }
    ) << "\n"
  end

  private

  def item(cells)
    title = cells[0][/\A[^(]+/].strip
    Item.new(title, cells[0].scan(/`([^`]+)`/).flatten, cells[1].split(', '), cells[2], cells[4])
  end

  def component(item, name, version)
    { type: 'library', name: name, version: version, licenses: [{ license: { name: item.licence } }],
      purl: item.purl(name, version), description: "linked into #{item.into.delete('`')}" }
  end
end
