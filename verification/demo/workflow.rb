# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The workflow of an OpenIGTLink client under the foot pedal: home, register, aim, move, or align and insert, read back,
# retract; poses between. For any robot.
class Workflow
  def initialize(robot)
    @robot = robot
    @client = robot.client
    @heard = []
  end

  def home
    under_pedal('START_UP')
  end

  # Rows of the matrix from the z-frame to the scanner.
  def register(rows)
    phase('PLANNING')
    phase('CALIBRATION')
    say('registration', *rows)
    await('CALIBRATION')
  end

  # With the entry point that was proposed, if it is to decide the depth.
  def aim(pose, accepts_entry: false)
    phase('PLANNING')
    phase('TARGETING')
    accept_entry if accepts_entry
    say('target', *pose)
    await('TARGET')
  end

  def move(pose, accepts_entry: false)
    aim(pose, accepts_entry: accepts_entry)
    under_pedal('MOVE_TO_TARGET')
  end

  # The base alone, with the needle out.
  def align(pose, accepts_entry: false)
    aim(pose, accepts_entry: accepts_entry)
    order('ALIGN')
  end

  # It replaces the order that entering the workphase has armed.
  def insert
    phase('MOVE_TO_TARGET')
    order('INSERT')
  end

  # With the needle out and nothing at the sensor.
  def zero_force
    answered('ZERO_FORCE')
  end

  # Depths below the entry point, mm.
  def expect_membranes(depths)
    answered('MEMBRANES', depths.join(' '))
  end

  # Curvature per m, and the direction of the rotation's axis in degrees.
  def steer(steering)
    answered('STEER', format('BIDIRECTIONAL %<per_m>s /m %<toward>s deg', steering))
  end

  # The block is the hand, under the pedal.
  def cooperate(&hand)
    phase('MOVE_TO_TARGET')
    order('COOPERATE', &hand)
  end

  # All axes but the needle.
  def pose(name)
    phase('MANUAL')
    order('POSE', name.upcase)
  end

  # Message to the operator: the needle lies on the line of its target.
  def aligned?
    heard = say('string', 'IS_IN_TARGETING_POS', 'IS_IN_TARGETING_POS')
    heard += say('wait', 'STRING', 'IS_IN_TARGETING_POS')
    heard.reverse.find { |line| line['type'] == 'STRING' && line['name'] == 'IS_IN_TARGETING_POS' }['text'] == '1'
  end

  # Returns with the pedal pressed, before the end of the move.
  def begin_move(pose)
    aim(pose)
    phase('MOVE_TO_TARGET')
    @robot.simctl('pedal', 'press')
  end

  # Where the needle is at its target.
  def retract
    order('RETRACT_NEEDLE')
  end

  # Where the treatment point is, mm.
  def measured
    matrix = say('get', 'CURRENT_POSITION').reverse.find { |line| line['type'] == 'TRANSFORM' }['matrix']
    [matrix[3], matrix[7], matrix[11]]
  end

  private

  def accept_entry
    answered('ACCEPT_ENTRY')
  end

  # A word that moves nothing.
  def answered(word, text = word)
    say('string', word, text)
    await(word)
  end

  # A motion with a word of its own, which it is answered by. The block is done under the pedal, while the client reads.
  def order(word, text = word, &)
    say('string', word, text)
    await("ACK_#{word}")
    hold_pedal(word, &)
  end

  # Commands with the pedal up, then holds the pedal until the result is there.
  def under_pedal(phase)
    phase(phase)
    hold_pedal(phase)
  end

  def hold_pedal(result, &)
    @robot.simctl('pedal', 'press')
    beside = Thread.new(&) if block_given?
    await(result)
    beside&.join
    @robot.simctl('pedal', 'release')
    @robot.wait_until('the pedal is seen released') { @robot.status['pedal'] == 'released' }
  end

  def phase(name)
    say('phase', name)
  end

  # Sends one command to the client; returns the messages that arrived until it was done.
  def say(*words)
    @client.write(words.join(' '))
    heard = []
    heard << @client.read until heard.last&.key?('done')
    @heard.concat(heard)
    heard
  end

  # Waits for STATUS name and demands code 1.
  def await(name)
    say('wait', 'STATUS', name)
    message = @heard.reverse.find { |line| line['type'] == 'STATUS' && line['name'] == name }
    raise "#{name}: #{message['text']}" unless message['code'] == 1
  end
end
