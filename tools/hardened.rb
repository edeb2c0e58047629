#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Whether programs were built as what is delivered must be: a smashed stack, an overrun buffer or an overwritten table of
# functions ends them.
#
#   ruby tools/hardened.rb build/bin/boresight build/bin/boresight-http ...
#
# Says what is missing, one line each, and ends with 1 then.

require 'open3'

# One program.
class Hardened
  # The last one counts.
  GUARD = /-f(?:no-)?stack-protector\S*/
  # The checked form of a library function.
  CHECKED = /\b__\w+_chk\b/

  # @satisfies SWR-ARM-003
  def self.complaints(files)
    files.flat_map { |file| new(file).complaints.map { |complaint| "#{file}: #{complaint}" } }
  end

  def initialize(file)
    @head = read(file, '-l', '-d', '-s')
    @units = read(file, '--debug-dump=info', '--dwarf-depth=1').scan(/DW_AT_producer.*: (.*)/).flatten
  end

  def complaints
    [('can be written where it runs' if writable_code?),
     ('its stack can run' if @head !~ /GNU_STACK.* RW /),
     ('its table of functions stays writable (RELRO)' if @head !~ /GNU_RELRO/),
     ('is neither static nor at an address by chance (PIE), bound at its start' unless static? || bound_pie?),
     ('has units without a guard of the stack' unless guarded?),
     ('calls no library function in its checked form (FORTIFY)' if @head !~ CHECKED)].compact
  end

  private

  def read(file, *what)
    text, status = Open3.capture2e({ 'LC_ALL' => 'C' }, 'readelf', '-W', *what, file)
    status.success? ? text : raise("readelf: #{text.lines.first}")
  end

  def static?
    @head !~ /INTERP/
  end

  def bound_pie?
    @head =~ /FLAGS_1.*NOW.*PIE/
  end

  def writable_code?
    @head =~ /LOAD.* RWE /
  end

  def guarded?
    @units.any? && @units.all? { |unit| unit.scan(GUARD).last.to_s.start_with?('-fstack') }
  end
end

if $PROGRAM_NAME == __FILE__
  abort 'usage: ruby tools/hardened.rb PROGRAM...' if ARGV.empty?
  complaints = Hardened.complaints(ARGV)
  puts complaints
  exit complaints.empty?
end
