# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: each symbol that the C library of a box does not have is named, and a program without one passes.

require 'minitest/autorun'
require 'open3'
require 'rbconfig'
require 'tmpdir'
require_relative '../debian/glibc'

class TestGlibc < Minitest::Test
  TOOL = File.expand_path('../debian/glibc.rb', __dir__)
  HEAD = "control:     file format elf32-littlearm\n\nDYNAMIC SYMBOL TABLE:\n"
  OLD = "00000000      DF *UND*  00000000 (GLIBC_2.4)  dlopen\n"
  NEW = "00000000      DF *UND*  00000000 (GLIBC_2.34) __libc_start_main\n"
  DECLARED = 'int puts(const char *); long getrandom(void *, unsigned long, unsigned);'
  OWN = "00010000 g    DF .text  00000010 (GLIBC_2.34) ours\n"
  WEAK = "00000000  w   D  *UND*  00000000              __gmon_start__\n"

  def test_SWR_NI_016_a_symbol_that_is_newer_is_named_with_its_version
    assert_equal ['__libc_start_main@GLIBC_2.34'], Glibc.new(HEAD + OLD + NEW + OWN + WEAK).newer_than('2.24')
  end

  def test_SWR_NI_016_versions_are_numbers
    assert_empty Glibc.new(HEAD + OLD + WEAK).newer_than('2.24')
    assert_empty Glibc.new(HEAD + NEW).newer_than('2.34')
    assert_equal ['dlopen@GLIBC_2.4'], Glibc.new(HEAD + OLD).newer_than('2.3.4')
  end

  def test_SWR_NI_016_what_is_linked_here_is_judged_by_its_symbols
    assert_equal ['', 0], judge('puts("x")')
    text, status = judge('getrandom(0, 0, 0)')
    assert_match(/getrandom@GLIBC_2.25 is newer than 2.24/, text)
    assert_equal 1, status
  end

  private

  def judge(call)
    Dir.mktmpdir do |folder|
      source = File.join(folder, 'one.c')
      library = File.join(folder, 'one.so')
      File.write(source, "#{DECLARED}\nlong one(void) { return #{call}; }\n")
      assert system('gcc', '-shared', '-fPIC', '-nostartfiles', source, '-o', library)
      text, status = Open3.capture2e(RbConfig.ruby, TOOL, library, '2.24')
      return [text, status.exitstatus]
    end
  end
end
