# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'c'

module Interface
  # A number for all that two programs must agree on: names, types and enumerators of core/interface, the states of the
  # charts, and types and macros of further headers. Words and functions may differ.
  #
  # @satisfies SWR-TOOL-013
  class Layout
    START = 0xCBF29CE484222325 # FNV-1a
    PRIME = 0x00000100000001B3
    COMMENT = %r{/\*.*?\*/}m
    MACRO = /^[ \t]*#[ \t]*define\b(?:\\\n|[^\n])*/
    TYPE = /^typedef\b[^{;]*(?:(?<braces>\{(?:[^{}]|\g<braces>)*\})[^;]*)?;/

    # `headers`: files whose types and macros count too.
    def initialize(model, headers)
      @lines = model.enumerations.map(&:layout) + model.structures.map(&:layout) + [model.modes&.layout].compact +
               model.charts.to_h.map { |region, leaves| "chart #{region} #{leaves.join(' ')}" } +
               headers.flat_map { |header| declarations(File.read(header, encoding: 'UTF-8').gsub(COMMENT, ' ')) }
    end

    def number
      @lines.sort.join("\n").each_byte.inject(START) { |sum, byte| ((sum ^ byte) * PRIME) & 0xFFFFFFFFFFFFFFFF }
    end

    def declarations(text)
      found = []
      text.scan(Regexp.union(MACRO, TYPE)) { found << Regexp.last_match(0).split.join(' ') }
      found
    end

    def files
      body = "/** Differs from that of a build whose processes cannot be understood. */\n" \
             "#define INTERFACE_LAYOUT UINT64_C(0x#{format('%016X', number)})\n"
      { 'interface_layout.h' => C.file('Layout that all processes must agree on.', 'core/interface') +
        C.guard('interface_layout', body) }
    end
  end
end
