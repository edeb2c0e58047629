# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'cycle_bound'

# The bound of controller_step() for a robot and a number of commands in the cycle.
module Bound
  PROGRAM = File.join(LoopBounds::ROOT, 'build/arm/bin/bench-step')
  START = 'controller_step'

  module_function

  def table
    @table ||= YAML.safe_load_file(LoopBounds::TABLE)
  end

  def code
    @code ||= MachineCode.of(PROGRAM)
  end

  def facts(commands)
    table['facts'].to_h { |entry| [entry.fetch('function'), entry.fetch('most') + (commands * entry.fetch('per_command'))] }
  end

  def of(robot, commands, start: START)
    values = table['robots'].fetch(robot).merge('commands' => commands)
    bounds = LoopBounds.new(table, values)
    library = table['library'].to_h { |name, entry| [name, entry['most'] || code.straight(name)] }
    CycleBound.new(code, start, bounds, library: library, never: Regexp.new(values.fetch('elsewhere')),
                                             at_most: facts(commands))
  end
end

if $PROGRAM_NAME == __FILE__
  Bound.table['robots'].each_key do |robot|
    [0, 1, 4].each { |commands| puts format('%-9<robot>s %<commands>d commands: at most %<most>d', robot: robot, commands: commands, most: Bound.of(robot, commands).most) }
  end
end
