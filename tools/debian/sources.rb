#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Fetches Debian's sources (tools/debian/sources.txt), with Debian's patches, to .tools/sources. Sources there already
# stay.
#
#   ruby tools/debian/sources.rb

require_relative 'own_apt'

FOLDER = '.tools/sources'
LOG = '.tools/sources.log'

OwnApt.fetch('tools/debian/sources.txt', FOLDER, LOG) do |names|
  apt = OwnApt.new(FOLDER, LOG, architecture: 'amd64', types: ['deb-src'])
  names.flatten.each do |name|
    download = "#{apt.archives}/#{name}"
    FileUtils.mkdir_p(download)
    apt.run(download, 'apt-get', 'source', '--download-only', '--only-source', name)
    # apt has checked what it downloaded.
    apt.run('.', 'dpkg-source', '--no-check', '--no-copy', '-x', Dir["#{download}/*.dsc"].first, "#{FOLDER}/#{name}")
  end
  apt.remove
end
