# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0
# Compiles statecharts to C, diagrams, a table for the console and tests of every pair.
# @satisfies SWR-CHART-003

require_relative 'chartc/lib/command'

exit Chart::Command.run(ARGV) if $PROGRAM_NAME == __FILE__
