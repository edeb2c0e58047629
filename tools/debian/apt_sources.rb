# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Those package sources of this computer that an apt of our own may ask: the release itself, main only. Each entry
# keeps its options, so its mirror, its key and its proxy, but its architectures. `suite` is asked in place of `release`.
module AptSources
  LINE = /\Adeb(?:\s+\[(?<options>[^\]]*)\])?\s+(?<uri>\S+)\s+(?<suite>\S+)\s+(?<components>[^#]*)/
  OURS = /\A(?:Types|Suites|Components|Architectures):/i

  class << self
    # The text of a `.list`. types: deb, deb-src or both.
    def lines(text, release, types, suite = release)
      text.lines.filter_map { |line| line.match(LINE) }.uniq.flat_map do |entry|
        next [] unless entry[:suite] == release && entry[:components].split.include?('main')

        options = entry[:options].to_s.split.grep_v(/\Aarch/)
        options = options.empty? ? '' : "[#{options.join(' ')}] "
        types.map { |type| "#{type} #{options}#{entry[:uri]} #{suite} main\n" }
      end.join
    end

    # The text of a `.sources`.
    def stanzas(text, release, types, suite = release)
      text.split(/\n\s*\n/).filter_map do |stanza|
        next unless means?(stanza, 'Types', 'deb') && means?(stanza, 'Suites', release) &&
                    means?(stanza, 'Components', 'main') && !means?(stanza, 'Enabled', 'no')

        kept = stanza.lines(chomp: true).grep_v(OURS).reject(&:empty?)
        ["Types: #{types.join(' ')}", "Suites: #{suite}", 'Components: main', *kept, ''].join("\n")
      end.join("\n")
    end

    private

    def means?(stanza, field, word)
      stanza[/^#{field}:(.*)$/i, 1].to_s.split.include?(word)
    end
  end
end
