#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Packs the programs that were built into build/package, a package for each board and each kind of computer, with the sums of
# all. `make package` builds them before.
#
#   ruby tools/package.rb

require 'digest'
require 'fileutils'
require 'open3'
require 'psych'
require 'tmpdir'
require_relative 'package/archive'
require_relative 'package/soup'

# One package.
class Package
  # Kind of computer: its name there, the programs of the simulated and of another board, the tool that strips them.
  Kind = Struct.new(:ending, :architecture, :programs, :of_board, :strip, :is_static, keyword_init: true)
  KINDS = [
    Kind.new(ending: 'deb', architecture: 'amd64', programs: 'build/gcc/bin', of_board: 'build/boards/%s/bin', strip: 'strip'),
    Kind.new(ending: 'deb', architecture: 'armhf', programs: 'build/arm/bin', of_board: 'build/boards/arm-%s/bin',
             strip: 'arm-linux-gnueabihf-strip', is_static: true),
    Kind.new(ending: 'ipk', architecture: 'core2-64', programs: 'build/static/bin', of_board: 'build/boards/static-%s/bin',
             strip: 'strip', is_static: true),
    Kind.new(ending: 'ipk', architecture: 'cortexa9-vfpv3', programs: 'build/arm/bin', of_board: 'build/boards/arm-%s/bin',
             strip: 'arm-linux-gnueabihf-strip', is_static: true)
  ].freeze
  SIMULATED = 'sim'
  LICENCE = "# SPDX-License-Identifier: Apache-2.0\n"
  PARTS = 'tools/package'
  SHARED = { 'LICENSE' => 'LICENSE', 'CHANGELOG.md' => 'CHANGELOG.md', 'docs/commissioning.md' => 'commissioning.md',
             'docs/user-manual.md' => 'user-manual.md', 'docs/soup.md' => 'soup.md',
             'docs/card-protocol.md' => 'card-protocol.md' }.freeze
  # Documents on the wires of each board that the commissioning asks to be read.
  OF_BOARDS = 'docs/board-*.md'
  # On the path of a shell.
  COMMANDS = %w[boresight boresight-passwd boresight-replay boresight-simctl].freeze
  CONFIGURATION = %w[/etc/boresight/boresight.conf /etc/init.d/boresight].freeze
  # Time of the commit, and its version.
  State = Struct.new(:epoch, :version)

  class << self
    def state
      epoch = git('log', '-1', '--format=%ct').to_i
      changed = git('status', '--porcelain', '--untracked-files=no').empty? ? '' : '+changed'
      released = File.read('CHANGELOG.md').scan(/^## \[(.+?)\]/).flatten
      time = Time.at(epoch).utc.strftime('%Y%m%d%H%M%S')
      after = "#{released[1] || 0}+git#{time}.#{git('rev-parse', '--short=12', 'HEAD')}#{changed}"
      State.new(epoch, released.first == 'Unreleased' ? after : released.first + changed)
    end

    def boards
      Dir['bsp/*/board.yml'].map { |file| File.basename(File.dirname(file)) }.sort
    end

    # A static program loads no library while it runs.
    def possible?(board, kind)
      !kind.is_static || !Psych.safe_load_file("bsp/#{board}/board.yml")['loads_library']
    end

    # @satisfies SWR-PACK-004
    def write_all(folder, state)
      FileUtils.mkdir_p(folder)
      FileUtils.rm_f(Dir["#{folder}/*"])
      files = boards.product(KINDS).filter_map { |board, kind| new(kind, board, state).write(folder) if possible?(board, kind) }
      File.write("#{folder}/SHA256SUMS", files.map { |file| "#{Digest::SHA256.file(file)}  #{File.basename(file)}\n" }.join)
      files
    end

    private

    def git(*words)
      text, status = Open3.capture2e('git', *words)
      raise PackageArchive::Refused, "git #{words.first}: #{text.lines.last}" unless status.success?

      text.strip
    end
  end

  def initialize(kind, board, state)
    @kind = kind
    @board = board
    @state = state
    @soup = Soup.new(File.read(Soup::FILE))
  end

  # Returns the file.
  def write(folder)
    Dir.mktmpdir do |work|
      @archive = PackageArchive.new("#{work}/package", @state.epoch)
      add_release
      add_rest
      add_control
      "#{folder}/#{name}_#{@state.version}_#{@kind.architecture}.#{@kind.ending}".tap { |file| @archive.write(file) }
    end
  end

  private

  def simulated?
    @board == SIMULATED
  end

  def name
    simulated? ? 'boresight' : "boresight-#{@board}"
  end

  def release
    simulated? ? @state.version : "#{@state.version}-#{@board}"
  end

  def programs
    folder = simulated? ? @kind.programs : format(@kind.of_board, @board)
    Dir["#{folder}/boresight*"].sort.tap do |files|
      raise PackageArchive::Refused, "there is nothing in #{folder}; run make package" if files.empty?
    end
  end

  def add_release
    programs.each do |file|
      place = "/opt/boresight/package/bin/#{File.basename(file)}"
      @archive.add(place, File.binread(file), mode: PackageArchive::PROGRAM)
      @archive.strip(place, @kind.strip)
    end
    pages = Dir[OF_BOARDS].sort.to_h { |file| [file, File.basename(file)] }
    SHARED.merge(pages).each { |file, as| @archive.add("/opt/boresight/package/share/#{as}", File.read(file)) }
    @archive.add('/opt/boresight/package/share/boresight.cdx.json',
                 @soup.bill(@board, @state.version, Time.at(@state.epoch)))
  end

  # Files that are there once, whichever release is the current one.
  #
  # @satisfies SWR-PACK-009
  # @satisfies SWR-PACK-012
  def add_rest
    commands = programs.map { |file| File.basename(file) } & COMMANDS
    commands.each { |command| @archive.link("/usr/bin/#{command}", "/opt/boresight/current/bin/#{command}") }
    @archive.add('/usr/sbin/boresight-rollback', script('boresight-rollback'), mode: PackageArchive::PROGRAM)
    @archive.add('/etc/boresight/boresight.conf', part('boresight.conf'))
    @archive.add('/etc/init.d/boresight', script('boresight.init', part('boresight.init.head')), mode: PackageArchive::PROGRAM)
    @archive.add('/lib/systemd/system/boresight.service', part('boresight.service')) if @kind.ending == 'deb'
    @archive.add("/usr/share/doc/#{name}/copyright", File.read('LICENSE'))
    @archive.add_folder('/var/lib/boresight', 0o750)
  end

  # Scripts that dpkg and opkg call, and the files that are the engineer's.
  #
  # @satisfies SWR-PACK-007
  # @satisfies SWR-PACK-008
  # @satisfies SWR-PACK-013
  # @satisfies SWR-PACK-010
  # @satisfies SWR-ARM-010
  # @satisfies SWR-ARM-011
  def add_control
    %w[preinst postinst prerm postrm].each do |each|
      @archive.control(each, script(each), mode: PackageArchive::PROGRAM)
    end
    @archive.control('conffiles', CONFIGURATION.map { |file| "#{file}\n" }.join)
    @archive.control('control', fields.compact.map { |key, value| "#{key}: #{value}\n" }.join)
  end

  # No two boards on one computer.
  def fields
    others = (self.class.boards - [@board]).map { |board| board == SIMULATED ? 'boresight' : "boresight-#{board}" }.join(', ')
    { 'Package' => name, 'Version' => @state.version, 'Architecture' => @kind.architecture,
      'Maintainer' => 'Boresight maintainers <root@localhost>', 'Installed-Size' => @archive.kilobytes,
      'Depends' => (needed unless @kind.is_static), 'Conflicts' => others, 'Replaces' => others,
      'Section' => 'misc', 'Priority' => 'optional',
      'Description' => "Control core of an MRI-compatible needle robot, #{simulated? ? 'simulated box' : "board #{@board}"}" }
  end

  # The C library is named by its version, since programs need what it has had from then on.
  def needed
    items = @soup.items(@board).select(&:library)
    items.map { |item| item.title == 'glibc' ? "#{item.library} (>= #{item.versions.first[/\A[\d.]+/]})" : item.library }.join(', ')
  end

  def part(file)
    File.read("#{PARTS}/#{file}")
  end

  def script(name, head = '')
    parts = ['releases.sh', "#{name}.sh"].map { |file| part(file).delete_prefix(LICENCE) }
    "#!/bin/sh\n#{LICENCE}#{head}set -eu\n\n#{parts.join("\n")}".gsub('@RELEASE@', release)
  end
end

if $PROGRAM_NAME == __FILE__
  Dir.chdir(File.expand_path('..', __dir__))
  begin
    puts(Package.write_all('build/package', Package.state).map { |file| "packed #{file}" })
  rescue PackageArchive::Refused => e
    abort "package: #{e.message.strip}"
  end
end
