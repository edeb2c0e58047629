# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'fileutils'
require 'open3'
require_relative 'apt_sources'

# An apt of our own, which asks where this computer has its packages from: nothing on this computer changes, no root is
# needed.
class OwnApt
  class Refused < StandardError; end

  # Fetches the packages of a list, unless all of them are there: the list stands in the folder then.
  # @satisfies SWR-ARM-001
  def self.fetch(list, folder, log)
    Dir.chdir(File.expand_path('../..', __dir__))
    fetched = File.join(folder, File.basename(list))
    return if File.exist?(fetched) && FileUtils.identical?(fetched, list)

    FileUtils.rm_rf([folder, log])
    yield File.readlines(list, chomp: true).grep_v(/\A(#|\s*\z)/).map(&:split)
    FileUtils.cp(list, fetched)
  rescue Refused => e
    abort "#{File.basename(list, '.txt')}: #{e.message.strip} (log: #{log}); check the network and the package sources, then repeat."
  end

  attr_reader :archives

  # suite: another release than that of this computer.
  def initialize(folder, log, architecture:, types:, suite: nil)
    @home = File.expand_path("#{folder}/apt")
    @archives = "#{@home}/archives"
    @log = log
    FileUtils.mkdir_p(%W[#{@home}/sources #{@home}/lists/partial #{@archives}/partial])
    write_sources(types, suite)
    write_configuration(architecture)
    # An index that cannot be had is no matter as long as the packages can.
    run(@home, 'apt-get', 'update', may_fail: true)
  end

  def run(folder, *command, may_fail: false)
    puts command.join(' ')
    $stdout.flush
    output, status = Open3.capture2e({ 'APT_CONFIG' => "#{@home}/apt.conf", 'LC_ALL' => 'C' }, *command, chdir: folder)
    File.write(@log, "$ #{command.join(' ')}\n#{output}", mode: 'a')
    return output if status.success? || may_fail

    raise Refused, "#{command.first(2).join(' ')} failed: #{output.lines.grep(/^E:/).first || output.lines.last}"
  end

  def remove
    FileUtils.rm_rf(@home)
  end

  private

  def write_sources(types, suite)
    release = File.read('/etc/os-release')[/^VERSION_CODENAME=(\w+)/, 1] || raise(Refused, 'this is no Debian')
    Dir['/etc/apt/sources.list', '/etc/apt/sources.list.d/*.list', '/etc/apt/sources.list.d/*.sources'].each do |file|
      part = file.end_with?('.sources') ? :stanzas : :lines
      File.write("#{@home}/sources/#{File.basename(file).sub('sources.list', 'own.list')}",
                 AptSources.public_send(part, File.read(file), release, types, suite || release))
    end
  end

  def write_configuration(architecture)
    File.write("#{@home}/status", '')
    File.write("#{@home}/apt.conf", <<~CONF)
      APT::Architecture "#{architecture}";
      APT::Architectures { "#{architecture}"; };
      APT::Sandbox::User "root";
      Acquire::Languages "none";
      Dir::State "#{@home}";
      Dir::State::status "#{@home}/status";
      Dir::Cache "#{@home}";
      Dir::Etc::sourcelist "/dev/null";
      Dir::Etc::sourceparts "#{@home}/sources";
    CONF
  end
end
