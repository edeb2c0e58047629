#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Fetches what the programs for Cortex-A9 need of Debian's armhf (tools/armhf/packages.txt) to .tools/armhf, by an apt of
# its own: nothing on this computer changes, no root is needed. What is there already stays.
#
#   ruby tools/armhf.rb

require 'fileutils'
require 'open3'
require_relative 'armhf/sources'

# One fetching of everything.
class Armhf
  class Refused < StandardError; end

  PACKAGES = 'tools/armhf/packages.txt'
  FOLDER = '.tools/armhf'
  # Says what was fetched, once all of it is there.
  FETCHED = "#{FOLDER}/packages.txt"
  LOG = '.tools/armhf.log'

  def self.fetched?
    File.exist?(FETCHED) && FileUtils.identical?(FETCHED, PACKAGES)
  end

  def initialize
    @apt = File.expand_path("#{FOLDER}/apt")
    @wanted = File.readlines(PACKAGES).grep_v(/\A(#|\s*\z)/).map(&:split).group_by(&:first)
  end

  # @satisfies SWR-ARM-001
  def fetch
    FileUtils.rm_rf([FOLDER, LOG])
    FileUtils.mkdir_p(%W[#{@apt}/sources #{@apt}/lists/partial #{@apt}/archives/partial])
    configure
    # An index that cannot be had is no matter as long as the packages can.
    run(@apt, 'apt-get', 'update', may_fail: true)
    unpack(@wanted.values_at('library', 'program').flatten(1).map(&:last))
    @wanted.fetch('kernel').each { |_, name, *files| unpack_part(kernel(name), files, 'root') }
    @wanted.fetch('machine').each { |_, name, *files| unpack_part(name, files, 'machine') }
    @wanted.fetch('source').each { |_, name| unpack_source(name) }
    FileUtils.rm_rf(@apt)
    FileUtils.cp(PACKAGES, FETCHED)
  end

  private

  def configure
    release = File.read('/etc/os-release')[/^VERSION_CODENAME=(\w+)/, 1] || raise(Refused, 'this is no Debian')
    Dir['/etc/apt/sources.list', '/etc/apt/sources.list.d/*.list', '/etc/apt/sources.list.d/*.sources'].each do |file|
      part = file.end_with?('.sources') ? :stanzas : :lines
      File.write("#{@apt}/sources/#{File.basename(file).sub('sources.list', 'own.list')}",
                 AptSources.public_send(part, File.read(file), release))
    end
    File.write("#{@apt}/status", '')
    File.write("#{@apt}/apt.conf", <<~CONF)
      APT::Architecture "armhf";
      APT::Architectures { "armhf"; };
      APT::Sandbox::User "root";
      Acquire::Languages "none";
      Dir::State "#{@apt}";
      Dir::State::status "#{@apt}/status";
      Dir::Cache "#{@apt}";
      Dir::Etc::sourcelist "/dev/null";
      Dir::Etc::sourceparts "#{@apt}/sources";
    CONF
  end

  def unpack(names)
    run("#{@apt}/archives", 'apt-get', 'download', *names)
    Dir["#{@apt}/archives/*.deb"].each { |deb| run('.', 'dpkg-deb', '-x', deb, "#{FOLDER}/root") }
  end

  def kernel(name)
    run('.', 'apt-cache', 'depends', name)[/Depends: (linux-image-\d\S+)/, 1] || raise(Refused, "#{name} stands for no kernel")
  end

  def unpack_part(name, files, folder)
    FileUtils.mkdir_p("#{FOLDER}/#{folder}")
    run("#{@apt}/archives", 'apt-get', 'download', name)
    archive = Dir["#{@apt}/archives/#{name}_*.deb"].first
    wanted = files.map { |file| "'#{file}'" }.join(' ')
    run('.', 'sh', '-c', "dpkg-deb --fsys-tarfile #{archive} | tar -x -C #{FOLDER}/#{folder} --wildcards #{wanted}")
  end

  # With Debian's patches. apt has checked what it downloaded.
  def unpack_source(name)
    folder = "#{@apt}/archives/#{name}"
    FileUtils.mkdir_p([folder, "#{FOLDER}/source"])
    run(folder, 'apt-get', 'source', '--download-only', '--only-source', name)
    run('.', 'dpkg-source', '--no-check', '--no-copy', '-x', Dir["#{folder}/*.dsc"].first, "#{FOLDER}/source/#{name}")
  end

  def run(folder, *command, may_fail: false)
    output, status = Open3.capture2e({ 'APT_CONFIG' => "#{@apt}/apt.conf", 'LC_ALL' => 'C' }, *command, chdir: folder)
    File.write(LOG, "$ #{command.join(' ')}\n#{output}", mode: 'a')
    return output if status.success? || may_fail

    raise Refused, "#{command.first(2).join(' ')} failed: #{output.lines.grep(/^E:/).first || output.lines.last}"
  end
end

if $PROGRAM_NAME == __FILE__
  Dir.chdir(File.expand_path('..', __dir__))
  begin
    Armhf.new.fetch unless Armhf.fetched?
  rescue Armhf::Refused => e
    abort "armhf: #{e.message.strip} (log: #{Armhf::LOG}); check the network and the package sources, then repeat."
  end
end
