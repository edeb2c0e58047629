# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'fileutils'
require 'open3'
require 'tmpdir'

# A Debian in which nothing is installed but what this one has below /usr, of which the tree has a layer of its own, and whose
# dpkg knows only the libraries of the programs. Nothing of this computer changes: processes, mounts and shared memory are
# the test's own.
class BareTree
  OWN = %w[unshare --mount --pid --fork --kill-child --mount-proc].freeze
  # Options of a user who is not root.
  AS_ROOT = %w[--user --map-root-user].freeze
  INSIDE = 'BORESIGHT_APART'
  FOLDERS = %w[usr layer work proc dev tmp run etc/init.d var/lib/dpkg/info var/lib/dpkg/updates].freeze
  PATH = '/usr/sbin:/usr/bin:/sbin:/bin'

  # Begins this program anew where it may mount. To be called before anything else.
  def self.enter
    if ENV[INSIDE]
      mount('-t', 'tmpfs', 'tmpfs', '/dev/shm')
    else
      exec({ INSIDE => '1' }, *OWN, *(AS_ROOT unless Process.uid.zero?), *File.read('/proc/self/cmdline').split("\0"))
    end
  end

  def self.mount(*words)
    text, status = Open3.capture2e('mount', *words)
    raise "mount #{words.join(' ')}: #{text}" unless status.success?
  end

  def initialize(libraries)
    @root = Dir.mktmpdir('bare-tree')
    mount('-t', 'tmpfs', 'tmpfs', @root)
    FileUtils.mkdir_p(FOLDERS.map { |folder| "#{@root}/#{folder}" })
    mount('-t', 'overlay', 'overlay', '-o', "lowerdir=/usr,upperdir=#{@root}/layer,workdir=#{@root}/work", "#{@root}/usr")
    %w[bin sbin lib lib64].each { |name| File.symlink("usr/#{name}", "#{@root}/#{name}") }
    %w[proc dev tmp].each { |name| mount('--rbind', "/#{name}", "#{@root}/#{name}") }
    FileUtils.cp(%w[/etc/passwd /etc/group], "#{@root}/etc")
    File.write("#{@root}/var/lib/dpkg/status", Open3.capture2('dpkg-query', '-s', *libraries).first)
  end

  # Words in front of a command that shall run in the tree.
  def prefix
    ['env', "PATH=#{PATH}", 'LC_ALL=C', 'chroot', @root]
  end

  # Runs a command there; returns what it says and its exit code.
  def run(*command)
    text, status = Open3.capture2e(*prefix, *command)
    [text, status.exitstatus]
  end

  def path(name)
    "#{@root}#{name}"
  end

  def remove
    Open3.capture2e('umount', '--recursive', '--lazy', @root)
    FileUtils.rmdir(@root)
  end

  private

  def mount(...)
    self.class.mount(...)
  end
end
