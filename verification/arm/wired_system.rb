# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'arm_system'

# Boresight for the board sbrio in the emulated machine: the cards of a simulated box behind its /dev/spidev9.0, contacts
# soldered to its GPIO, its watchdog.
class WiredSystem < ArmSystem
  LINES = { pedal_a: 0, pedal_b: 1, estop: 2, scanner: 3 }.freeze
  POWER = 8
  WATCHDOG = '/sys/class/watchdog/watchdog0'
  DEVICE = 'spidev9.0'
  # As much as the paced machine needs to be punctual.
  SLOWNESS = 10
  WIRING = <<~WIRING
    spidev:   /dev/#{DEVICE}, slots=0-9, clock=100000000
    gpio:     /dev/gpiochip4, #{LINES.map { |name, line| "#{name}=#{line}" }.join(', ')}, power=#{POWER}
    watchdog: /dev/watchdog, timeout=60
    slow:     #{SLOWNESS}
  WIRING

  def initialize(machine, robot:)
    super(machine, robot:, slowness: SLOWNESS)
    @box += ' --real-time'
    @command = "/sbrio/boresight --robot #{robot} --wiring #{FOLDER}/wiring --accounts #{FOLDER}/accounts " \
               "--recordings #{RECORDINGS}"
  end

  # Homes under the pedal until something is so, again when it was stopped or is done.
  def drive_until(reason)
    wait_until(reason) do
      arm_homing && press_pedal if status['order'] == 'none'
      yield
    end
  end

  # A contact to each line.
  def press_pedal
    solder(pedal_a: 1, pedal_b: 1)
  end

  def release_pedal
    solder(pedal_a: 0, pedal_b: 0)
    wait_until('the pedal is released') { status['pedal'] == 'released' }
  end

  def pull_estop
    solder(estop: 0)
  end

  def reset_estop
    solder(estop: 1)
  end

  def powered?
    machine.line(POWER) == 1
  end

  def watchdog
    machine.run!("cat #{WATCHDOG}/state").strip
  end

  # The watchdog would restart the computer: it is disarmed there, since time there may pass quickly. Returns what it was
  # before.
  def kill_control
    machine.run!("kill -9 $(pidof boresight-control); until test -s #{EXIT}; do sleep 1; done; " \
                 "cat #{WATCHDOG}/state; echo V >/dev/watchdog").strip
  end

  # Positions of the axes, in ticks, as the box sees them.
  def positions
    axes.map { |words| Float(words[4]) }
  end

  # How often the watchdogs of the cards have tripped.
  def trips
    axes.sum { |words| Integer(words.last) }
  end

  # As a person ends it.
  def interrupt
    machine.run!('kill -INT $(pidof boresight)')
  end

  private

  def axes
    simctl('show').lines.map(&:split).select { |words| words.first.to_s.match?(/\A\d+\z/) }
  end

  # It is refused in a second in which the loop has taken a page of memory, as in its first one.
  def arm_homing
    release_pedal
    wait_until('homing is armed') do
      answers = count_answers
      command('START_UP')
      wait_until('START_UP is answered') { count_answers > answers }
      status['order'] != 'none'
    end
  end

  def count_answers
    count('ORDER_ARMED') + count('COMMAND_REFUSED')
  end

  def start_box
    super
    solder(pedal_a: 0, pedal_b: 0, estop: 1, scanner: 1)
    machine.run!("echo '#{WIRING}' >#{FOLDER}/wiring")
    machine.run!("echo a long password | boresight-passwd #{FOLDER}/accounts set tester operator")
    machine.run!("cards-on-spi #{DEVICE} #{BOX} >#{FOLDER}/spi 2>&1 </dev/null &")
    wait_until("#{DEVICE} is there") { machine.run("test -c /dev/#{DEVICE}").last.zero? }
  end

  def solder(levels)
    levels.each { |name, level| machine.set_line(LINES.fetch(name), level) }
  end
end
