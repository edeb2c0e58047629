# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'tmpdir'
require_relative 'arm_system'
require_relative '../../tools/package'

# Boresight as the package for Debian's armhf installs it in the emulated machine, started by its service.
class InstalledSystem < ArmSystem
  OLD = '1.0'
  NEW = '1.1'
  KIND = Package::KINDS.find { |kind| [kind.ending, kind.architecture] == %w[deb armhf] }
  # busybox has a dpkg of its own.
  DPKG = '/usr/bin/dpkg'
  CONFIGURATION = '/etc/boresight/boresight.conf'
  SERVICE = '/etc/init.d/boresight'

  # The files of both releases, as `make package` writes them.
  def self.packages
    @packages ||= Dir.mktmpdir.then do |folder|
      Minitest.after_run { FileUtils.rm_rf(folder) }
      Dir.chdir(Machine::ROOT) do
        [OLD, NEW].map { |version| Package.new(KIND, Package::SIMULATED, Package::State.new(0, version)).write(folder) }
      end
    end
  end

  # The lines that an engineer adds.
  def configure(robot)
    machine.run!("printf 'robot #{robot}\\nbox #{BOX}\\n' >>#{CONFIGURATION}")
  end

  def launch
    machine.run!("#{SERVICE} start")
    wait_until('it answers') { answers? }
  end

  def recordings
    '/var/lib/boresight'
  end

  def output
    service('status').first
  end

  # Output, and the exit code.
  def dpkg(*words)
    machine.run("#{DPKG} #{words.join(' ')}")
  end

  def install(version)
    dpkg('--install', "/packages/boresight_#{version}_#{KIND.architecture}.#{KIND.ending}")
  end

  def rollback
    machine.run('/usr/sbin/boresight-rollback')
  end

  def check
    machine.run('/usr/bin/boresight --check')
  end

  def service(act)
    machine.run("#{SERVICE} #{act}").then { |text, code| [text.strip, code] }
  end

  # Nothing goes on meanwhile, however long it takes.
  def while_held
    pids = machine.run!('pidof boresight-control boresight-box')
    machine.run!("kill -STOP #{pids}")
    yield
  ensure
    machine.run("kill -CONT #{pids}")
  end

  def leads(link)
    File.basename(machine.run!("readlink /opt/boresight/#{link}").strip)
  end

  private

  def answers?
    status
  rescue Machine::Failed
    false
  end
end
