# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'load'
require_relative 'support'
require_relative '../demo/targets'
require_relative '../demo/workflow'
require_relative '../system/support/boresight'

# Answer times of fifteen clients that ask as fast as they are answered while the bench moves to a target.
class Clients
  ROBOT = 'bench2'
  SECONDS = 2.0
  SAYS = { 'a pose and a status, p50' => 'p50_us', 'p99' => 'p99_us', 'worst' => 'worst_us',
           'acknowledgement of a command, worst' => 'worst_ack_us', 'acknowledgement of STOP' => 'stop_ack_us',
           'STOP obeyed and reported' => 'stop_us' }.freeze

  def run
    puts "OpenIGTLink: 15 clients ask as fast as they are answered, #{SECONDS} s of a move"
    robot = Boresight.start(arguments: ['--robot', ROBOT])
    prepare(robot)
    @seen = Load.measure(robot, 'MOVE_TO_TARGET', SECONDS)
    [title, Table.render(%w[\  us], rows), remark].join("\n")
  rescue Load::Failed => e
    raise BenchFailed, e.message
  ensure
    robot&.kill_all
  end

  private

  # Homed, registered and with a target; its client goes.
  def prepare(robot)
    targets = Targets.new(File.join(ROOT, "core/robot/#{ROBOT}/targets.yml"))
    workflow = Workflow.new(robot)
    workflow.home
    workflow.register(targets.registration)
    workflow.aim(Geometry.rows(targets.each_target.first.rotation, targets.each_target.first.point))
    robot.client.close
    robot.await_released_pedal
  end

  def title
    'OpenIGTLink under load: 7 clients and a commander on one port, 7 on the other, while the robot moves'
  end

  def rows
    SAYS.map { |says, key| [says, @seen.fetch(key)] }
  end

  def remark
    moved = @seen['was_moving'] ? 'it moved until STOP' : 'it had arrived before STOP'
    "#{@seen['questions']} questions, #{@seen['answers']} answers; #{@seen['commands']} commands, " \
      "#{@seen['acknowledgements']} acknowledged; #{moved}.\nThe times are the machine's, and the clients ran on it."
  end
end
