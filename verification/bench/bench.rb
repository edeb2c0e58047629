#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# `make bench`: what a control cycle costs, how large its recording is, what our OpenIGTLink codec costs beside the
# standard's own library, how it stands many clients, what a crowd at the HTTP server costs, and how punctually a cycle
# begins.
#
#   ruby verification/bench/bench.rb [instructions] [recordings] [codec] [clients] [crowds] [latency]      without a word: all
#
# Nothing here passes or fails. Times of a shared or virtual machine are its own, not the program's, so none of them is
# a limit. Instructions are the same on every run of one build with one compiler: test_cost.rb and test_codec_cost.rb
# hold them to limits.

$stdout.sync = true
require_relative 'clients'
require_relative 'codec'
require_relative 'crowds'
require_relative 'instructions'
require_relative 'latency'
require_relative 'recordings'

parts = { 'instructions' => Instructions, 'recordings' => Recordings, 'codec' => Codec,
          'clients' => Clients, 'crowds' => Crowds, 'latency' => Latency }
unknown = ARGV - parts.keys
abort "unknown: #{unknown.join(' ')}; usage: bench.rb [#{parts.keys.join('] [')}]" unless unknown.empty?

begin
  tables = (ARGV.empty? ? parts.keys : ARGV.uniq).map { |name| parts[name].new.run }
  puts '', tables.join("\n\n")
rescue Interrupt
  code = 130
rescue BenchFailed, Boresight::TimedOut, SystemCallError => e
  warn "bench: #{e.message}"
  code = 1
ensure
  Boresight.running.dup.each(&:kill_all)
end
# The harness of the system tests would now run the tests of this program; it has none.
exit! code || 0
