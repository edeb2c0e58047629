#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Fetches the prover of `make proof` (tools/debian/prover.txt) to .tools/prover. What is there already stays.
#
#   ruby tools/debian/prover.rb

require 'digest'
require_relative 'own_apt'

# One fetching of everything.
class Prover
  FOLDER = '.tools/prover'
  LOG = '.tools/prover.log'

  def initialize(lines)
    @wanted = lines.group_by(&:first)
  end

  def fetch
    suite = @wanted.fetch('suite').first.last
    @apt = OwnApt.new(FOLDER, LOG, architecture: 'amd64', types: ['deb'], suite: suite)
    FileUtils.mkdir_p("#{FOLDER}/root")
    @wanted.fetch('package').each { |_, name, version, digest, *files| unpack(download(name, version, digest), files) }
    @apt.remove
  end

  # Its file, once that is the one that is meant.
  #
  # @satisfies SWR-TOOL-200
  def self.checked(file, digest)
    there = Digest::SHA256.file(file).hexdigest
    raise OwnApt::Refused, "#{File.basename(file)} has the SHA-256 #{there}, not #{digest}" unless there == digest

    file
  end

  private

  def download(name, version, digest)
    @apt.run(@apt.archives, 'apt-get', 'download', "#{name}=#{version}")
    Prover.checked(Dir["#{@apt.archives}/#{name}_*.deb"].first, digest)
  end

  def unpack(archive, files)
    wanted = files.map { |file| "'#{file}'" }.join(' ')
    @apt.run('.', 'sh', '-c', "dpkg-deb --fsys-tarfile #{archive} | tar -x -C #{FOLDER}/root --wildcards #{wanted}")
  end
end

if $PROGRAM_NAME == __FILE__
  OwnApt.fetch('tools/debian/prover.txt', Prover::FOLDER, Prover::LOG) { |lines| Prover.new(lines).fetch }
end
