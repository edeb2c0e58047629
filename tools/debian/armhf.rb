#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Fetches what the programs for Cortex-A9 need of Debian's armhf (tools/debian/armhf.txt) to .tools/armhf. Files there
# already stay.
#
#   ruby tools/debian/armhf.rb

require_relative 'own_apt'

# One fetching of everything.
class Armhf
  FOLDER = '.tools/armhf'
  LOG = '.tools/armhf.log'

  def initialize(lines)
    @wanted = lines.group_by(&:first)
  end

  def fetch
    @apt = OwnApt.new(FOLDER, LOG, architecture: 'armhf', types: ['deb'])
    unpack(@wanted.values_at('library', 'program').flatten(1).map(&:last))
    @wanted.fetch('kernel').each { |_, name, *files| unpack_part(kernel(name), files, 'root') }
    @wanted.fetch('machine').each { |_, name, *files| unpack_part(name, files, 'machine') }
    @apt.remove
  end

  private

  def unpack(names)
    @apt.run(@apt.archives, 'apt-get', 'download', *names)
    Dir["#{@apt.archives}/*.deb"].each { |deb| @apt.run('.', 'dpkg-deb', '-x', deb, "#{FOLDER}/root") }
  end

  def kernel(name)
    @apt.run('.', 'apt-cache', 'depends', name)[/Depends: (linux-image-\d\S+)/, 1] ||
      raise(OwnApt::Refused, "#{name} stands for no kernel")
  end

  def unpack_part(name, files, folder)
    FileUtils.mkdir_p("#{FOLDER}/#{folder}")
    @apt.run(@apt.archives, 'apt-get', 'download', name)
    archive = Dir["#{@apt.archives}/#{name}_*.deb"].first
    wanted = files.map { |file| "'#{file}'" }.join(' ')
    @apt.run('.', 'sh', '-c', "dpkg-deb --fsys-tarfile #{archive} | tar -x -C #{FOLDER}/#{folder} --wildcards #{wanted}")
  end
end

OwnApt.fetch('tools/debian/armhf.txt', Armhf::FOLDER, Armhf::LOG) { |lines| Armhf.new(lines).fetch }
