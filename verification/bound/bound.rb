# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'cycle_bound'

# Bounds of controller_step() and its stages, in instructions, not time of caches, by robot and by the number of commands in the cycle.
#
#   ruby verification/bound/bound.rb             prints them, and writes build/bound/bound.yml
#   ruby verification/bound/bound.rb ROBOT N     functions with the most instructions on the longest path, N commands
module Bound
  PROGRAM = File.join(LoopBounds::ROOT, 'build/arm/bin/bench-step')
  APPROVED = File.join(__dir__, 'bound.yml')
  WRITTEN = File.join(LoopBounds::ROOT, 'build/bound/bound.yml')
  STAGES = %w[observe obey move drive show all].freeze
  COMMANDS = { 'one_command' => 1, 'four_commands' => 4 }.freeze
  HEAD = <<~TEXT
    # SPDX-License-Identifier: Apache-2.0
    # Instructions, not time of caches, that a control cycle needs at most, written by `make bound-approve`.
    # Of controller_step() and its stages on a Cortex-A9, each with all that it calls: the longest path of the flow graphs
    #   under the loop bounds and facts of bounds.yml. One command in the cycle, or four, the most that a cycle takes.
  TEXT

  module_function

  def table
    @table ||= YAML.safe_load_file(LoopBounds::TABLE)
  end

  def code
    @code ||= MachineCode.of(PROGRAM)
  end

  def approved
    YAML.safe_load_file(APPROVED).fetch('robots')
  end

  def of(robot, commands, start)
    @loops ||= Hash.new { |all, key| all[key] = LoopBounds.new(table, values(*key)) }
    CycleBound.new(code, start, @loops[[robot, commands]], library: library, at_most: facts(commands),
                                                           never: Regexp.new(values(robot, commands).fetch('elsewhere')))
  end

  # Entries of the table that fit no loop of any robot.
  def idle
    @loops.values.map(&:idle).reduce(:&)
  end

  def rows(robot)
    COMMANDS.transform_values { |commands| STAGES.to_h { |stage| [stage, of(robot, commands, function(stage)).most] } }
  end

  def write
    rows = table['robots'].keys.to_h { |robot| [robot, rows(robot)] }
    FileUtils.mkdir_p(File.dirname(WRITTEN))
    File.write(WRITTEN, HEAD + YAML.dump({ 'robots' => rows }).delete_prefix("---\n"))
    rows
  end

  def values(robot, commands)
    table['robots'].fetch(robot).merge('commands' => commands)
  end

  def library
    @library ||= table['library'].to_h { |name, entry| [name, entry['most'] || code.straight(name)] }
  end

  def facts(commands)
    table['facts'].to_h { |entry| [entry.fetch('function'), entry.fetch('most') + (commands * entry.fetch('per_command'))] }
  end

  def function(stage)
    stage == 'all' ? 'controller_step' : "controller_#{stage}"
  end

  def show(robot, commands)
    found = of(robot, commands, 'controller_step')
    found.own.max_by(30) { |_name, own| own }.each do |name, own|
      puts format('%-32<name>s %8<own>d instructions in %6<calls>d calls', name: name, own: own, calls: found.calls[name])
    end
  end
end

if $PROGRAM_NAME == __FILE__
  ARGV.empty? ? puts(YAML.dump(Bound.write)) : Bound.show(ARGV[0], ARGV[1].to_i)
end
