# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: whatever could fail unseen in the core is found in its object code, and the core is free of it.

require 'fileutils'
require 'minitest/autorun'
require 'tmpdir'
require_relative '../purity'

class TestPurity < Minitest::Test
  ROOT = File.expand_path('../..', __dir__)

  def test_SWR_CORE_001_the_core_is_pure
    purity = Purity.new(ROOT)
    assert_operator purity.files.size, :>, 20
    assert_empty purity.problems
  end

  def test_SWR_CORE_001_accepts_copying_constants_and_calls_inside_the_core
    assert_empty problems(<<~C)
      #include <string.h>
      static const int table[2] = {1, 2}; /* 1.5 float */
      int inner(int a);
      int inner(int a) { int copy[2]; memcpy(copy, table, sizeof copy); return copy[a]; }
      int outer(int a);
      int outer(int a) { return inner(a); }
    C
  end

  def test_SWR_CORE_001_finds_the_heap_and_other_calls
    assert_equal ['core/a/a.c: calls malloc, which is not of the core'],
                 problems("#include <stdlib.h>\nvoid *f(void);\nvoid *f(void) { return malloc(3); }\n")
  end

  def test_SWR_CORE_001_finds_objects_that_can_be_changed
    assert_equal ['core/a/a.c: count is an object that can be changed'],
                 problems("int f(void);\nstatic int count;\nint f(void) { count++; return count; }\n")
    assert_equal ['core/a/a.c: start is an object that can be changed'], problems("int start = 3;\n")
  end

  def test_SWR_CORE_001_finds_floating_point
    assert_includes problems("float f(float a);\nfloat f(float a) { return a * 2; }\n").first, 'core/a/a.c: '
    assert_equal ['core/a/a.c:1: floating point'], problems("enum { A = (int)1.5 };\n")
  end

  def test_SWR_CORE_001_finds_recursion
    direct = "__attribute__((noinline)) int f(int *a);\nint f(int *a) { return *a ? f(a) + *a : 1; }\n"
    assert_equal ['f: recursion'], problems(direct)
    around = "int f(int *a);\nint g(int *a);\nint f(int *a) { return *a ? g(a) + *a : 1; }\n" \
             "__attribute__((noinline)) int g(int *a) { return f(a) + 1; }\n"
    assert_match(/recursion/, problems(around).first)
  end

  private

  def problems(source)
    Dir.mktmpdir do |root|
      FileUtils.mkdir_p(File.join(root, 'core/a'))
      File.write(File.join(root, 'core/a/a.c'), source)
      return Purity.new(root).problems
    end
  end
end
