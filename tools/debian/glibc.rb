#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Names what a program needs of a C library that is newer than the one of a box.
#
#   ruby tools/debian/glibc.rb PROGRAM 2.24      one line per symbol, exit 1 if there is any

require 'open3'

# The symbols of a dynamic program, as objdump lists them. A static one has none.
#
# @satisfies SWR-NI-016
class Glibc
  NEEDS = /\*UND\*.*\(?GLIBC_(?<version>[0-9.]+)\)?\s+(?<symbol>\S+)\s*\z/

  def self.of(program)
    text, status = Open3.capture2e('objdump', '-T', program)
    return new(text) if status.success? || text.include?('not a dynamic object')

    abort "glibc: #{program} cannot be read: #{text.lines.last}"
  end

  def initialize(text)
    @needs = text.lines.filter_map { |line| NEEDS.match(line) }
  end

  # "symbol@version" of each that is newer than `most`.
  def newer_than(most)
    limit = Gem::Version.new(most)
    @needs.select { |need| Gem::Version.new(need[:version]) > limit }
          .map { |need| "#{need[:symbol]}@GLIBC_#{need[:version]}" }.sort
  end
end

if $PROGRAM_NAME == __FILE__
  abort 'usage: glibc.rb PROGRAM VERSION' unless ARGV.size == 2 && ARGV[1].match?(/\A\d+(\.\d+)+\z/)
  newer = Glibc.of(ARGV[0]).newer_than(ARGV[1])
  newer.each { |symbol| puts "#{ARGV[0]}: #{symbol} is newer than #{ARGV[1]}" }
  exit newer.empty?
end
