# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'json'
require_relative 'machine'
require_relative '../system/support/boresight'

# Boresight in the emulated machine, on a simulated box that outlives it.
class ArmSystem
  BOX = 'lone'
  FOLDER = '/tmp/boresight'
  RECORDINGS = "#{FOLDER}/recordings"
  OUTPUT = "#{FOLDER}/output"
  EXIT = "#{FOLDER}/exit"
  CONTACTS_REST_CYCLES = 50
  EVENT = /\A\S+ \d+ cycle=\d+ [A-Z]+ (?<name>[A-Z_]+) subject=(?<subject>\d+)/

  attr_reader :machine

  def initialize(machine, robot:, slowness:)
    @machine = machine
    @box = "boresight-box --robot #{robot} --box #{BOX} --slow #{slowness}"
    @command = "boresight --robot #{robot} --box #{BOX} --recordings #{RECORDINGS}"
    @commands = 0
  end

  def start
    machine.run!("rm -rf #{FOLDER}; mkdir #{FOLDER}")
    start_box
    launch
    self
  end

  # Again, on the box that there is.
  def launch
    @commands = 0
    machine.run!("rm -f #{OUTPUT} #{EXIT}; { #{@command} >#{OUTPUT} 2>&1 </dev/null; echo $? >#{EXIT}; } &")
    wait_until('it is up') { output.include?('Stop:') || (ended? && raise(Machine::Failed, output)) }
  end

  def output
    machine.run("cat #{OUTPUT}").first
  end

  def ended?
    machine.run("test -s #{EXIT}").last.zero?
  end

  # Its exit code, once everything is written.
  def wait_for_end
    wait_until('it has ended') { ended? }
    Integer(machine.run!("cat #{EXIT}"), 10)
  end

  def status
    JSON.parse(machine.run!('wget -qO- http://127.0.0.1:8080/api/v1/status'))
  end

  def simctl(*words)
    machine.run!("boresight-simctl --box #{BOX} #{words.join(' ')}")
  end

  # Its contacts bounce.
  def release_pedal
    simctl('pedal', 'release')
    since = wait_until('the pedal is released') { status.then { |now| now['cycle'] if now['pedal'] == 'released' } }
    wait_until('its contacts are at rest') { status['cycle'] >= since + CONTACTS_REST_CYCLES }
  end

  # As a client of OpenIGTLink that stays.
  def command(workphase)
    peer = "#{FOLDER}/peer"
    machine.run!("rm -f #{peer}; mkfifo #{peer}; nc 127.0.0.1 18936 <#{peer} >/dev/null & exec 3>#{peer}") if @commands.zero?
    @commands += 1
    message = WorkphasePeer.message(format('CMD_%04d', @commands), workphase)
    machine.run!("echo #{[message].pack('m0')} | base64 -d >&3")
  end

  def recordings
    RECORDINGS
  end

  # Names of the events so far, the first one first; of what axis or card.
  def events
    machine.run("cat #{recordings}/events-*.log").first.lines.filter_map do |line|
      event = line.match(EVENT)
      [event[:name], event[:subject].to_i] if event
    end
  end

  def count(name)
    events.count { |event, _| event == name }
  end

  # Cards whose drive is on, as the box sees it.
  def driven
    simctl('show').lines.map(&:split).select { |words| words.first.to_s.match?(/\A\d+\z/) && !words.include?('off') }
  end

  def kill_control
    machine.run!('kill -9 $(pidof boresight-control)')
  end

  # The files on this computer.
  def fetch_recordings(folder)
    machine.run!("ls #{recordings}/blackbox-*").lines(chomp: true).map do |name|
      File.join(folder, File.basename(name)).tap { |file| File.binwrite(file, machine.read(name)) }
    end
  end

  def start_box
    log = "#{FOLDER}/box"
    machine.run!("#{@box} >#{log} 2>&1 </dev/null &")
    wait_until('the box is ready') { machine.run("cat #{log}").first.include?('ready') }
  end

  def stop_box
    machine.run!('kill $(pidof boresight-box); while pidof boresight-box; do sleep 1; done')
  end

  def wait_until(reason, &)
    machine.wait_until(reason, &)
  rescue Machine::TimedOut => e
    raise Machine::TimedOut, "#{e.message}\nevents: #{events.last(20)}\n#{output}"
  end
end
