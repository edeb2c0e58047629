# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'json'
require_relative '../system/support/igtl_client'
require_relative '../system/support/session_client'

# Plays by chance until it is asked to leave. A time that passes is part of the play.
class Player
  GONE = [SystemCallError, IOError, Net::OpenTimeout, Net::ReadTimeout, Net::HTTPBadResponse].freeze

  def initialize(robot, random)
    @robot = robot
    @random = random
    @goes_on = true
  end

  def play
    pause(*self.class::PACE_S) { act } while @goes_on
    finish
  end

  def leave
    @goes_on = false
  end

  private

  # A killed program comes again.
  def pause(least, most)
    yield
  rescue *GONE
    lose
  ensure
    sleep @random.rand(least..most) if @goes_on
  end

  # One of them, each as often as its number says.
  def draw(acts)
    acts.flat_map { |name, share| [name] * share }.sample(random: @random)
  end

  def lose; end
  def finish; end
end

# A connection of the workphases' port.
class Connection < Player
  PACE_S = [0.05, 1.0].freeze
  ACTS = { 'MOVE_TO_TARGET' => 6, 'START_UP' => 1, 'CURRENT_STATUS' => 2, 'STOP' => 1, leave: 5 }.freeze

  private

  def act
    said = draw(ACTS)
    return lose if said == :leave

    @socket ||= TCPSocket.new('127.0.0.1', @robot.brp_port)
    @number = @number.to_i + 1
    @socket.write(RawIgtl.string(format('CMD_%06d', @number), said))
    @socket.read_nonblock(65_536, exception: false)
  end

  def lose
    @socket&.close
    @socket = nil
  end
  alias finish lose
end

# A page of the console. A sulking page sends nothing for longer than a page may.
class Page < Player
  PACE_S = [0.1, 1.2].freeze
  SULK_S = 6
  QUIT_S = 3
  ACTS = { take: 8, keep: 4, give_up: 1, ask: 3, jog: 3, quit: 5, move: 1, stop: 1, sulk: 2 }.freeze

  private

  def act
    @client ||= log_in
    send(draw(ACTS)) if @client
    @client = nil if @client&.last&.code == '401'
  end

  def log_in
    client = SessionClient.new(@robot.http_port)
    client.log_in('anna')
    client if client.last.code == '200'
  end

  def take = @client.take
  def keep = @client.keep
  def give_up = @client.give_up
  def ask = @client.act('authority/request', { what: 'TAKE' })
  def move = @client.act('workphase', { workphase: 'MOVE_TO_TARGET' })
  def stop = @robot.post_stop

  def jog
    @client.act('workphase', { workphase: 'MANUAL' })
    @client.act('motors/needle/jog', { position: @random.rand(0.0..30.0), unit: 'mm' })
  end

  # On the way, if the pedal is pressed soon.
  def quit
    take
    jog
    wait(QUIT_S) { @robot.moving? }
    pause(0.0, 0.5) { nil }
    give_up
  end

  def sulk
    take
    jog
    wait(SULK_S) { false }
  end

  # So long, or until the block is true.
  def wait(seconds)
    ends = Boresight.now + seconds
    sleep 0.1 until !@goes_on || Boresight.now > ends || yield
  end

  def lose
    @client = nil
  end
end

# At the box: the pedal or the button, never both for long.
class Hand < Player
  PACE_S = [0.2, 2.0].freeze
  ACTS = { press: 8, release: 1, confirm: 2 }.freeze
  CONFIRM_S = 1.3 # confirm_hold_us, and a bit.

  private

  def act
    send(draw(ACTS))
  end

  def press
    release
    pause(0.1, 0.3) { @robot.simctl('pedal', 'press') }
  end

  def release
    @robot.simctl('pedal', 'release')
  end

  def confirm
    release
    pause(CONFIRM_S, CONFIRM_S) { @robot.simctl('button', 'press') }
    @robot.simctl('button', 'release')
  end

  alias finish release
end

# Kills the processes between players and control, which the supervisor starts again, or holds them longer than they
# may be silent.
class Reaper < Player
  PACE_S = [3.0, 6.0].freeze
  ACTS = { kill: 1, hold: 1 }.freeze
  VICTIMS = %w[igtl http].freeze
  HOLD_S = 2.5

  private

  def act
    pid = @robot.pid_of(VICTIMS.sample(random: @random))
    send(draw(ACTS), pid) if pid
  end

  def kill(pid)
    Process.kill('KILL', pid)
  end

  def hold(pid)
    Process.kill('STOP', pid)
    sleep HOLD_S
  ensure
    Process.kill('CONT', pid)
  end
end
