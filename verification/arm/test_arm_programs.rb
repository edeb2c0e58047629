# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: every program is there for Cortex-A9 as well, needs nothing beside itself, and is hardened as those for
# x86-64 are.

require 'minitest/autorun'
require 'open3'
require 'tmpdir'
require_relative '../../tools/hardened'
require_relative '../../tools/package'

class TestArmPrograms < Minitest::Test
  ROOT = File.expand_path('../..', __dir__)
  ARM = File.join(ROOT, 'build/arm/bin')
  # The client of the tests is none of them.
  PROGRAMS = Dir["#{ROOT}/build/gcc/bin/boresight*"].map { |file| File.basename(file) }.sort.freeze
  # Real ones that can be static.
  STATIC = Package::KINDS.find(&:is_static)
  BOARDS = (Package.boards - [Package::SIMULATED]).select { |board| Package.possible?(board, STATIC) }.freeze
  FIVE_GB = 5 << 30
  SOURCE = <<~C
    #include <stdio.h>
    #ifdef BOTH
    __asm__(".section .both,\\"awx\\"\\n.long 0\\n.previous");
    #endif
    int main(int count, char **words)
    {
        char text[8];

        (void)sprintf(text, "%s", words[count - 1]);
        (void)puts(text);
        return 0;
    }
  C

  def self.made
    @made ||= Open3.capture2e('make', '--no-print-directory', '-C', ROOT, 'arm-programs')
  end

  def setup
    text, status = self.class.made
    assert_predicate status, :success?, text
  end

  def test_SWR_ARM_002_every_program_is_one_static_file_that_says_its_version
    assert_operator PROGRAMS.size, :>, 8
    PROGRAMS.each do |name|
      head, = Open3.capture2e('readelf', '-h', '-l', '-d', "#{ARM}/#{name}")
      assert_match(/Machine: +ARM$/, head)
      refute_match(/INTERP|NEEDED/, head)
      assert_equal said('--version', by: ["#{ROOT}/build/bin/#{name}"]), said('--version', by: arm(name))
    end
  end

  def test_SWR_ARM_002_SWR_ARM_003_those_of_every_board_are_static_and_hardened
    BOARDS.each do |board|
      ours = Dir["#{ROOT}/build/boards/arm-#{board}/bin/boresight*"]
      assert_includes ours.map { |file| File.basename(file) }, 'boresight-control'
      ours.each { |file| refute_match(/INTERP|NEEDED/, Open3.capture2e('readelf', '-l', '-d', file).first) }
      assert_empty Hardened.complaints(ours + Dir["#{ROOT}/build/boards/#{board}/bin/boresight*"])
    end
  end

  def test_SWR_ARM_003_every_program_is_hardened
    assert_empty Hardened.complaints(PROGRAMS.flat_map { |name| %W[#{ARM}/#{name} #{ROOT}/build/gcc/bin/#{name}] })
  end

  # Each missing protection is reported by itself.
  def test_SWR_ARM_003_what_is_not_hardened_is_found
    whole = %w[-O2 -g -fstack-protector-strong -D_FORTIFY_SOURCE=2 -fPIE -pie -Wl,-z,relro,-z,now]
    { [] => nil, %w[-fno-stack-protector] => /guard of the stack/, %w[-U_FORTIFY_SOURCE] => /FORTIFY/,
      %w[-no-pie] => /neither static nor/, %w[-Wl,-z,lazy] => /neither static nor/, %w[-Wl,-z,norelro] => /RELRO/,
      %w[-Wl,-z,execstack] => /its stack can run/, %w[-DBOTH] => /can be written where it runs/ }
      .each do |change, complaint|
      Dir.mktmpdir do |folder|
        text, status = Open3.capture2e('gcc', *whole, *change, '-xc', '-', '-o', "#{folder}/program", stdin_data: SOURCE)
        assert_predicate status, :success?, text
        found = Hardened.complaints(["#{folder}/program"])
        complaint ? assert_match(complaint, found.join("\n")) : assert_empty(found)
      end
    end
  end

  def test_SWR_ARM_004_a_recording_beyond_the_address_space_is_refused
    Dir.mktmpdir do |folder|
      file = "#{folder}/large.brec"
      File.open(file, 'w') { |large| large.truncate(FIVE_GB) }
      text, status = Open3.capture2e(*arm('boresight-replay'), file)
      assert_equal 2, status.exitstatus
      assert_equal "#{file} is larger than this computer can read; use a larger one.\n", text
    end
  end

  private

  def arm(name)
    ['qemu-arm', '-cpu', 'cortex-a9', "#{ARM}/#{name}"]
  end

  def said(*options, by:)
    text, status = Open3.capture2e(*by, *options)
    assert_predicate status, :success?, text
    text
  end
end
