#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Runs the gates of verification/gates.yml, beside each other where they may, and says, last, `N passed, N failed`.
#
#   ruby tools/gates.rb            all gates
#   ruby tools/gates.rb NAME ...   only these and what they need
#
# A gate passes when its command ends with 0 and no test of it failed. Its output is kept in build/log/NAME.log. The
# tests that it leaves in build/results/NAME.json are counted one by one, and a gate without tests counts as one.

require_relative 'gates/run'

Dir.chdir(File.expand_path('..', __dir__))
begin
  gates = Gates::Gate.read('verification/gates.yml')
  run = Gates::Run.new(Gates::Gate.choose(gates, ARGV), $stdout)
  Results.keep_only(gates.map(&:name))
  exit(run.call ? 0 : 1)
rescue Gates::Refused => e
  abort "gates: #{e.message}"
end
