# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# An insertion by a hand at the handle of the needle, on the simulated box: under the pedal it presses and lets go as the next step of
# the operator has it.
class Cooperation
  GRIP_MN = 2000
  FELT = %w[MEMBRANE_FOUND MEMBRANE_UNEXPECTED MEMBRANE_MISSED MEMBRANE_PASSED VIBRATION_BEGUN VIBRATION_CUT].freeze
  ENDS = %w[ORDER_DONE ORDER_DISCARDED ORDER_EXPIRED].freeze

  def initialize(robot, workflow)
    @robot = robot
    @workflow = workflow
  end

  # With its membranes and its steering, if it has some.
  def insert(target)
    @membranes = target.membranes || []
    from = @robot.log.last['number'] + 1
    zero(from)
    @workflow.expect_membranes(@membranes) if @membranes.any?
    @workflow.steer(target.steer) if target.steer
    @robot.simctl('tissue', 'whole') # Where no needle has been.
    @robot.simctl('grip', GRIP_MN.to_s)
    @workflow.cooperate { push }
    @felt = named(from, *FELT)
  ensure
    @robot.simctl('hand', 'release')
  end

  # Each membrane that was expected was found and answered, and no other.
  def found_all?
    @felt.map { |event| event['name'] } == (%w[MEMBRANE_FOUND VIBRATION_BEGUN] * @membranes.size)
  end

  def told
    @felt.map { |event| "#{event['name']} #{(event['value'] / 1e6).round(2)} mm below the entry point" }
  end

  private

  def zero(from)
    @workflow.zero_force
    @robot.wait_until('both forces are zeroed') { named(from, 'FORCE_ZEROED').size == 2 }
  end

  # Until the order ends.
  def push
    from = @robot.log.last['number'] + 1
    @robot.wait_until('the needle is at its depth') do
      do_as_told
      named(from, *ENDS).any?
    end
  end

  def do_as_told
    case @robot.status['next_step']['name']
    when 'PUSH' then @robot.simctl('hand', 'press')
    when 'LET_GO' then @robot.simctl('hand', 'release')
    end
  end

  def named(from, *names)
    @robot.log(from).select { |event| names.include?(event['name']) }
  end
end
