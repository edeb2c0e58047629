# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# An insertion by a hand at the handle of the needle, on the simulated box: it presses under the pedal, and lets go where the robot
# wants to see it off, at first and after each vibration that answers a membrane.
class Cooperation
  GRIP_MN = 2000
  # In them the hand is seen off.
  OFF_CYCLES = 250
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

  def push
    from = @robot.log.last['number'] + 1
    press(from) until ended?(from)
  end

  def press(from)
    @robot.simctl('hand', 'release')
    last = @robot.status['cycle'] + OFF_CYCLES
    @robot.wait_until('the hand is seen off') { @robot.status['cycle'] >= last }
    @robot.simctl('hand', 'press')
    @robot.wait_until('the needle is at its depth, or the hand is to be seen off') { ended?(from) || unproven? }
  end

  def ended?(from)
    named(from, *ENDS).any?
  end

  def unproven?
    @robot.motors['axes'].any? { |axis| axis['permit']['reasons'].any? { |reason| reason['name'] == 'HAND_UNPROVEN' } }
  end

  def named(from, *names)
    @robot.log(from).select { |event| names.include?(event['name']) }
  end
end
