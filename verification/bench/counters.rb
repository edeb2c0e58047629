# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'io/wait'
require 'tmpdir'
require_relative 'support'

# Both counters give, per sample number, the instructions of one controller_step() by stage; a stage counts with all
# it calls, :all is the whole function.
STAGES = %i[observe obey move drive show].freeze

# x86-64: one dump of callgrind per call.
class CallgrindCounter
  PROGRAM = File.join(ROOT, 'build/gcc/bin/bench-step')
  STAGE = /^cfn=controller_(#{STAGES.join('|')})\ncalls=\d+ .*\n\S+ (\d+)$/

  def count(samples, numbers)
    Dir.mktmpdir('bench') do |directory|
      run(samples, numbers, directory)
      numbers.each_with_index.to_h { |number, i| [number, parse(File.read(File.join(directory, "out.#{i + 1}")))] }
    end
  end

  private

  def run(samples, numbers, directory)
    output, status = Open3.capture2e(
      'valgrind', '--tool=callgrind', "--callgrind-out-file=#{directory}/out", '--compress-strings=no',
      '--compress-pos=no', '--toggle-collect=controller_step', '--zero-before=controller_step',
      '--dump-after=controller_step', PROGRAM, samples, *numbers.map(&:to_s)
    )
    raise BenchFailed, "callgrind: #{output.lines.last(5).join}" unless status.success?
  end

  def parse(dump)
    stages = dump.scan(STAGE).to_h { |stage, cost| [stage.to_sym, cost.to_i] }
    raise BenchFailed, 'callgrind did not see every stage of controller_step' unless stages.length == STAGES.length

    stages.merge(all: dump[/^summary: (\d+)/, 1].to_i)
  end
end

# Cortex-A9: the emulator names every block of code when it translates it, with its instructions, and again whenever it
# executes it. A block ends where a call ends; so the stage is known by the blocks where one begins and by those of
# controller_step(), to which it returns.
class ArmCounter
  PROGRAM = File.join(ROOT, 'build/arm/bin/bench-step')

  def count(samples, numbers)
    @places = places
    @sizes = Hash.new(0)
    @counts = []
    @stage = nil
    trace(samples, numbers)
    raise BenchFailed, "#{@counts.length} calls traced, not #{numbers.length}" unless @counts.length == numbers.length

    numbers.zip(@counts.map { |counts| finish(counts) }).to_h
  end

  private

  # Hexadecimal address => :step, :outside, or the stage that begins there.
  def places
    symbols = read_symbols
    found = {}
    cover(found, symbols.fetch('measure'), :outside)
    cover(found, symbols.fetch('controller_step'), :step)
    STAGES.each { |stage| found[hexadecimal(symbols.fetch("controller_#{stage}").first)] = stage }
    found
  end

  def read_symbols
    text, status = Open3.capture2e('arm-linux-gnueabihf-nm', '-S', PROGRAM)
    raise BenchFailed, text unless status.success?

    text.scan(/^(\h{8}) (\h{8}) [Tt] (\S+)$/).to_h { |start, size, name| [name, [start.to_i(16) & ~1, size.to_i(16)]] }
  end

  def cover(found, symbol, place)
    start, size = symbol
    (start...(start + size)).step(2) { |address| found[hexadecimal(address)] = place }
    found[:entry] = hexadecimal(start) if place == :step
  end

  def hexadecimal(address)
    format('%08x', address)
  end

  def trace(samples, numbers)
    Dir.mktmpdir('bench') do |directory|
      pipe = File.join(directory, 'trace')
      File.mkfifo(pipe)
      pid = Process.spawn('qemu-arm', '-cpu', 'cortex-a9', '-d', 'exec,nochain,in_asm', '-D', pipe,
                          PROGRAM, samples, *numbers.map(&:to_s))
      read(pipe, Process.detach(pid))
    end
  end

  # "IN: SYMBOL", then "0xADDRESS:  CODE  INSTRUCTION" for each, then "Trace 0: HOST [FLAGS/ADDRESS/...] SYMBOL", which
  # stands there alone when the block is executed again.
  def read(pipe, emulator)
    # Opened without waiting for the emulator, which may fail to start.
    File.open(pipe, File::RDONLY | File::NONBLOCK) do |input|
      input.wait_readable(5)
      input.each_line do |line|
        if line.start_with?('0x')
          translate(line[2, 8])
        elsif line.start_with?('IN:')
          @block = nil
        elsif line.start_with?('Trace')
          take(line[line.index('[') + 10, 8])
        end
      end
    end
    raise BenchFailed, 'bench-step failed on the emulated Cortex-A9' unless emulator.value.success?
  end

  # A block may be translated anew.
  def translate(address)
    unless @block
      @block = address
      @sizes[address] = 0
    end
    @sizes[@block] += 1
  end

  def take(address)
    place = @places[address]
    enter(place, address) if place
    @counts.last[@stage] += @sizes[address] if @stage
  end

  def enter(place, address)
    @counts << Hash.new(0) if place == :step && address == @places[:entry] && @stage.nil?
    @stage = place == :outside ? nil : place
  end

  def finish(counts)
    STAGES.to_h { |stage| [stage, counts[stage]] }.merge(all: counts.values.sum)
  end
end
