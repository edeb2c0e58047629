# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'digest'
require 'fileutils'
require 'open3'

# A package of Debian or of opkg, which are alike: three archives in one. The same bytes from the same files, for any user who makes
# it, when and where.
class PackageArchive
  class Refused < StandardError; end

  PROGRAM = 0o755
  FILE = 0o644

  # `folder` is made anew; everything in the package has the time `epoch`.
  def initialize(folder, epoch)
    @folder = folder
    @epoch = epoch
    FileUtils.rm_rf(folder)
    FileUtils.mkdir_p(["#{folder}/data", "#{folder}/control"])
  end

  def add(path, text, mode: FILE)
    place = place_of(path)
    File.binwrite(place, text)
    File.chmod(mode, place)
  end

  def add_folder(path, mode)
    FileUtils.mkdir_p("#{@folder}/data#{path}")
    @own_modes = { "#{@folder}/data#{path}" => mode }.merge(@own_modes.to_h)
  end

  def link(path, to)
    File.symlink(to, place_of(path))
  end

  def strip(path, tool)
    run(tool, place_of(path))
  end

  # File in the folder of maintainers' scripts.
  def control(name, text, mode: FILE)
    File.binwrite("#{@folder}/control/#{name}", text)
    File.chmod(mode, "#{@folder}/control/#{name}")
  end

  def kilobytes
    files.sum { |file| (File.size("#{@folder}/data/#{file}") + 1023) / 1024 }
  end

  # @satisfies SWR-PACK-005
  def write(file)
    control('md5sums', files.map { |path| "#{Digest::MD5.file("#{@folder}/data/#{path}")}  #{path}\n" }.join)
    File.binwrite("#{@folder}/debian-binary", "2.0\n")
    %w[control data].each { |part| pack(part) }
    FileUtils.rm_f(file)
    run('ar', 'rcD', File.expand_path(file), 'debian-binary', 'control.tar.gz', 'data.tar.gz', chdir: @folder)
    FileUtils.rm_rf(@folder)
  end

  private

  def place_of(path)
    "#{@folder}/data#{path}".tap { |place| FileUtils.mkdir_p(File.dirname(place)) }
  end

  def files
    base = "#{@folder}/data"
    Dir.glob('**/*', base: base).select { |path| File.file?("#{base}/#{path}") && !File.symlink?("#{base}/#{path}") }.sort
  end

  # Each user has a umask of his own.
  def pack(part)
    base = "#{@folder}/#{part}"
    Dir.glob("#{base}/**/").each { |folder| File.chmod(@own_modes.to_h.fetch(folder.chomp('/'), PROGRAM), folder) }
    run('tar', '-c', '-f', "#{base}.tar", '--format=gnu', '--sort=name', '--owner=0', '--group=0', '--numeric-owner',
        "--mtime=@#{@epoch}", '-C', base, '.')
    run('gzip', '-9', '-n', "#{base}.tar")
  end

  def run(*command, **options)
    text, status = Open3.capture2e({ 'LC_ALL' => 'C' }, *command, **options)
    raise Refused, "#{command.first} failed: #{text.lines.last}" unless status.success?
  end
end
