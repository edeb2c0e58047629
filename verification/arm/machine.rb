# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'fileutils'
require 'open3'
require 'socket'
require 'tmpdir'

# A computer with Cortex-A9 and Debian's real-time kernel, in QEMU. It has what the kernel finds on a SABRE Lite: GPIO,
# watchdog, serial line; and our programs for it.
#
#   machine = Machine.start         two cores, the second one is kept for control
#   machine = Machine.start(paced: true)   one core; its time passes with its instructions
#   machine = Machine.start(packages: [file])   Debian's dpkg is there, too, and these below /packages
#   machine.run('uname -a')         => ["Linux ...", 0]
#   machine.set_line(0, 1)          what is soldered to the GPIO
#   machine.line(8)                 what it sets
#   machine.stop
class Machine
  ROOT = File.expand_path('../..', __dir__)
  DEBIAN = File.join(ROOT, '.tools/armhf/root')
  INSTALLER = File.join(ROOT, '.tools/armhf/machine')
  INSTALLED_IN = %w[etc/init.d var/lib/dpkg/info var/lib/dpkg/updates].freeze
  # Where they are there, and of which here.
  PROGRAMS = { 'boresight' => %w[arm/bin/boresight* arm/verification/arm/cards-on-spi],
               'sbrio' => %w[boards/arm-sbrio/bin/boresight*] }.freeze
  # In the order in which they can be loaded.
  MODULES = %w[gpio-mxc imx2_wdt fuse cuse].freeze
  # Nothing may take longer, however busy the host is.
  TIMEOUT_SECONDS = 300
  POLL_SECONDS = 0.05
  ASK_AGAIN_SECONDS = 0.5
  ARGUMENTS = 'console=ttymxc1,115200 quiet rdinit=/init panic=-1'
  CORES = ['-accel', 'tcg,thread=multi', '-smp', '2', '-append', "#{ARGUMENTS} isolcpus=1"].freeze
  # So many ns each, as a power of two. However busy the host is, the machine is late for nothing: a pause of the host is
  # none of its time. QEMU can do so with several cores only by running them in turns, and lets one of them starve.
  PACED = ['-accel', 'tcg,thread=single', '-smp', '1', '-append', ARGUMENTS, '-icount', 'shift=3,sleep=off'].freeze
  # GPIO 5 of the SABRE Lite has free lines: /dev/gpiochip4. Its first register holds what its outputs are set to.
  GPIO = '/machine/soc/gpio5'
  GPIO_OUTPUTS = 0x020ac000
  CORE_TIMER = 'arm,cortex-a9-twd-timer'

  class TimedOut < StandardError; end
  class Failed < StandardError; end

  class << self
    def start(...)
      new(...).tap(&:boot)
    end

    def running
      @running ||= []
    end
  end

  attr_reader :console

  def initialize(paced: false, packages: [])
    @paced = paced
    @packages = packages
    @folder = Dir.mktmpdir('boresight-arm')
    @console = +''
    @number = 0
  end

  # Up to its first command.
  def boot
    pack
    describe
    @pid = Process.spawn(*qemu, in: File::NULL, out: "#{@folder}/qemu.log", err: %i[child out])
    Machine.running << self
    @serial = connect('serial')
    @qtest = connect('qtest')
    wait_until('its shell answers') { start_shell? }
    run!('true')
  rescue StandardError
    stop
    raise
  end

  # Output of a command, and its exit code.
  def run(command)
    mark = "=#{@number += 1}="
    @serial.write("{ #{command}\n} </dev/null 2>&1; code=$?; echo; echo #{mark}$code\n")
    said = await(/^#{mark}(\d+)\r?\n/)
    [said.pre_match.delete("\r").delete_suffix("\n"), said[1].to_i]
  end

  # The same, which must succeed.
  def run!(command)
    text, code = run(command)
    code.zero? ? text : raise(Failed, "#{command}: #{code} #{text}")
  end

  def read(file)
    run!("base64 #{file}").unpack1('m')
  end

  def set_line(line, level)
    ask_qtest("set_irq_in #{GPIO} unnamed-gpio-in #{line} #{level}")
  end

  def line(line)
    Integer(ask_qtest("readl #{GPIO_OUTPUTS}"))[line]
  end

  # As if the host had no time for it.
  def pause(seconds)
    Process.kill('STOP', @pid)
    sleep seconds
  ensure
    Process.kill('CONT', @pid)
  end

  def stop
    [@serial, @qtest].compact.each(&:close)
    Process.kill('KILL', @pid) && Process.wait(@pid) if @pid
    @pid = nil
    FileUtils.rm_rf(@folder)
    Machine.running.delete(self)
  end

  def wait_until(reason)
    deadline = now + TIMEOUT_SECONDS
    until (result = yield)
      raise TimedOut, "waited #{TIMEOUT_SECONDS} s in vain until #{reason}; the console said:\n#{@console}" if now > deadline

      sleep POLL_SECONDS
    end
    result
  end

  private

  def now
    Process.clock_gettime(Process::CLOCK_MONOTONIC)
  end

  # The first memory disk: busybox, modules, programs, the first program.
  def pack
    tree = "#{@folder}/tree"
    FileUtils.mkdir_p(%W[#{tree}/bin #{tree}/modules #{tree}/dev])
    FileUtils.cp("#{DEBIAN}/bin/busybox", "#{tree}/bin")
    MODULES.each_with_index { |name, place| FileUtils.cp(find("**/#{name}.ko"), "#{tree}/modules/#{place}-#{name}.ko") }
    FileUtils.install("#{__dir__}/init", "#{tree}/init", mode: 0o755)
    pack_packages(tree) if @packages.any?
    PROGRAMS.each { |folder, patterns| pack_programs("#{tree}/#{folder}", Dir[*patterns, base: "#{ROOT}/build"]) }
    shell('sh', '-c', "cd #{tree} && find . | cpio --quiet -o -H newc -R 0:0 >#{@folder}/disk")
  end

  # The timer of a core has 100 MHz in QEMU, and the kernel is given 396: a process would sleep four times as long.
  # With one core it is named as none, so that the kernel takes the timer beside the core; several need their own.
  def describe
    devices = File.binread(find('usr/lib/linux-image-*/imx6q-sabrelite.dtb'))
    devices.sub!(CORE_TIMER) { |name| '-' * name.size } if @paced
    File.binwrite("#{@folder}/devices", devices)
  end

  # Tools with which they are installed, and the folders.
  def pack_packages(tree)
    FileUtils.cp_r("#{INSTALLER}/.", tree)
    FileUtils.mkdir_p(INSTALLED_IN.map { |folder| "#{tree}/#{folder}" } << "#{tree}/packages")
    FileUtils.touch("#{tree}/var/lib/dpkg/status")
    FileUtils.cp(@packages, "#{tree}/packages")
  end

  # One that is there already is linked: the disk must be read by an emulated processor.
  def pack_programs(folder, files)
    FileUtils.mkdir_p(folder)
    files.each do |file|
      packed = "#{folder}/#{File.basename(file)}"
      same = "#{File.dirname(folder)}/boresight/#{File.basename(file)}"
      shell('arm-linux-gnueabihf-strip', '-o', packed, "#{ROOT}/build/#{file}")
      FileUtils.ln(same, packed, force: true) if same != packed && File.exist?(same) && FileUtils.identical?(same, packed)
    end
  end

  def ask_qtest(question)
    @qtest.write("#{question}\n")
    @qtest.gets.to_s[/\AOK ?(.*)/, 1] || raise(Failed, "qtest does not obey #{question}")
  end

  def shell(*words)
    text, status = Open3.capture2e(*words)
    raise Failed, "#{words.first}: #{text}" unless status.success?
  end

  def find(pattern)
    Dir["#{DEBIAN}/#{pattern}"].first || raise(Failed, "#{pattern} is not in #{DEBIAN}")
  end

  def qemu
    %W[qemu-system-arm -M sabrelite -m 512 -display none -monitor none -no-reboot
       -serial null -serial unix:#{@folder}/serial,server=on,wait=off
       -qtest unix:#{@folder}/qtest,server=on,wait=off -qtest-log /dev/null
       -kernel #{find('boot/vmlinuz-*')} -dtb #{@folder}/devices
       -initrd #{@folder}/disk] + (@paced ? PACED : CORES)
  end

  def connect(name)
    wait_until("QEMU offers its #{name}") do
      UNIXSocket.new("#{@folder}/#{name}")
    rescue SystemCallError
      raise Failed, "QEMU has ended: #{File.read("#{@folder}/qemu.log")}" if Process.wait(@pid, Process::WNOHANG)
    end
  end

  # A command that is sent before the shell is there may be lost: it is repeated as long as nothing comes back.
  def start_shell?
    @serial.write("echo HE''RE\n")
    @serial.wait_readable(ASK_AGAIN_SECONDS)
    listen
    @console.include?('HERE')
  end

  def listen
    @console << @serial.read_nonblock(65_536) while @serial.wait_readable(0)
  rescue IO::WaitReadable
    nil
  rescue SystemCallError, EOFError
    raise Failed, "the machine has ended: #{File.read("#{@folder}/qemu.log")}\n#{@console}"
  end

  # Waits for what the pattern says, and takes it and what is before it off the console.
  def await(pattern)
    wait_until(pattern.source) do
      listen
      said = @console.match(pattern)
      said.tap { @console = +said.post_match } if said
    end
  end
end
