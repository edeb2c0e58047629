# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: from the same commit comes the same package, wherever and whenever it is made, and it says what is in it.

require 'digest'
require 'fileutils'
require 'json'
require 'minitest/autorun'
require 'open3'
require 'tmpdir'
require_relative '../package'

class TestPackage < Minitest::Test
  ROOT = File.expand_path('../..', __dir__)
  STATE = Package::State.new(1_700_000_000, '1.2.3')
  KIND = Package::KINDS.first
  PROGRAM = '/bin/true'
  PARTS = %w[tools/package docs bsp LICENSE CHANGELOG.md].freeze

  # Packs in a folder of its own, whose files are made at another time each, with another umask.
  def packed(mask, order)
    umask = File.umask(mask)
    Dir.mktmpdir do |folder|
      bring(PARTS, folder) { |from, to| FileUtils.cp_r(from, to) }
      FileUtils.mkdir_p("#{folder}/#{KIND.programs}")
      order.each { |name| FileUtils.cp(PROGRAM, "#{folder}/#{KIND.programs}/#{name}") }
      Dir.chdir(folder) { yield Package.new(KIND, 'sim', STATE).write('.') }
    end
  ensure
    File.umask(umask)
  end

  # Parts of the project into a folder.
  def bring(parts, folder)
    parts.each do |part|
      FileUtils.mkdir_p(File.dirname("#{folder}/#{part}"))
      yield "#{ROOT}/#{part}", "#{folder}/#{part}"
    end
  end

  def content(part, file)
    text, status = Open3.capture2e('sh', '-c', "ar p #{file} #{part}.tar.gz | tar -tvz --full-time --utc --numeric-owner")
    assert_predicate status, :success?, text
    text
  end

  # One key of a board's file says it, to the tool that packs and to make, which builds the programs before.
  def test_SWR_PACK_004_of_a_board_that_loads_a_library_there_is_no_static_package
    assert_equal [true, false, true, true], (Dir.chdir(ROOT) { possible('nifpga') + possible('sbrio') })
    Dir.mktmpdir do |folder|
      { 'eager' => "box: x\nloads_library: true\n", 'calm' => "box: x\n", 'sure' => "box: x\nloads_library: false\n" }.each do |board, text|
        FileUtils.mkdir_p("#{folder}/bsp/#{board}")
        File.write("#{folder}/bsp/#{board}/board.yml", text)
      end
      Dir.chdir(folder) { assert_equal [true, false, true, true, true, true], %w[eager calm sure].flat_map { |board| possible(board) } }
    end
  end

  def test_SWR_PACK_004_make_builds_static_programs_of_the_boards_that_are_packed_so
    text = Open3.capture2e({ 'MAKEFLAGS' => nil }, 'make', '-s', '-C', ROOT, '--eval', 'reported: ; @echo $(STATIC_BOARDS)', 'reported').first
    static = Package::KINDS.find(&:is_static)
    boards = Dir.chdir(ROOT) { (Package.boards - [Package::SIMULATED]).select { |board| Package.possible?(board, static) } }
    assert_equal boards, text.lines.last.split
  end

  # Programs that need a C library, and static ones.
  def possible(board)
    [KIND, Package::KINDS.find(&:is_static)].map { |kind| Package.possible?(board, kind) }
  end

  def test_SWR_PACK_005_the_same_files_make_the_same_package
    sums = [[0o022, %w[boresight boresight-http]], [0o077, %w[boresight-http boresight]]].map do |mask, order|
      packed(mask, order) { |file| Digest::SHA256.file(file).hexdigest }
    end
    assert_equal sums.first, sums.last
  end

  def test_SWR_PACK_005_all_belongs_to_root_and_has_the_time_of_the_commit
    packed(0o027, %w[boresight]) do |file|
      lines = %w[control data].flat_map { |part| content(part, file).lines }
      assert_operator lines.size, :>, 20
      lines.each { |line| assert_match(%r{\A[dl-][rwx-]{9} 0/0 +\d+ 2023-11-14 22:13:20 }, line) }
      assert_match(%r{^-rwxr-xr-x .* \./opt/boresight/package/bin/boresight$}, lines.join)
      assert_match(%r{^drwxr-x--- .* \./var/lib/boresight/$}, lines.join)
    end
  end

  # A source outside of any user's folder leaves no trace of one.
  def test_SWR_PACK_005_programs_do_not_reveal_where_they_were_compiled
    source = 'app/common/clock.c'
    sums = Array.new(2) do
      Dir.mktmpdir do |folder|
        flags, status = Open3.capture2('make', '-s', '--no-print-directory', '-C', ROOT, 'flags-of-programs')
        assert_predicate status, :success?
        bring(%w[app core build/gen], folder) { |from, to| File.symlink(from, to) }
        text, done = Open3.capture2e('gcc', *flags.gsub(ROOT, folder).split, '-D_GNU_SOURCE', '-Iapp', '-Icore', '-Ibuild/gen',
                                     '-c', source, '-o', 'it.o', chdir: folder)
        assert_predicate done, :success?, text
        refute_includes File.binread("#{folder}/it.o"), folder
        Digest::SHA256.file("#{folder}/it.o").hexdigest
      end
    end
    assert_equal sums.first, sums.last
  end

  def test_SWR_PACK_006_a_package_says_what_is_linked_into_its_programs
    packed(0o022, %w[boresight]) do |file|
      text, = Open3.capture2('sh', '-c', "ar p #{file} data.tar.gz | tar -xzO ./opt/boresight/package/share/boresight.cdx.json")
      bill = JSON.parse(text)
      assert_equal %w[CycloneDX 1.5], bill.values_at('bomFormat', 'specVersion')
      assert_equal %w[boresight 1.2.3], bill.dig('metadata', 'component').values_at('name', 'version')
      assert_equal %w[OpenSSL\ libcrypto cJSON civetweb glibc libxcrypt react react-dom scheduler zstd].sort,
                   bill['components'].map { |part| part['name'] }.sort
      bill['components'].each { |part| refute_includes part.values_at('version', 'licenses', 'purl').map(&:to_s), '' }
      react = bill['components'].find { |part| part['name'] == 'react-dom' }
      assert_equal ['19.3.1', 'pkg:npm/react-dom@19.3.1'], react.values_at('version', 'purl')
    end
  end

  def test_SWR_PACK_006_what_only_a_board_links_is_reported_of_that_board
    soup = Soup.new(File.read("#{ROOT}/docs/soup.md"))
    refute_includes soup.items('sim').map(&:title), 'libgpiod'
    assert_includes soup.items('sbrio').map(&:library), 'libgpiod2'
  end
end
