# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: what the header says of a value is what operator and network are told.

require 'minitest/autorun'
require 'open3'
require 'tmpdir'

class TestNames < Minitest::Test
  TOOL = File.expand_path('../names.rb', __dir__)

  HEADER = <<~C
    /** Why something was refused. */
    typedef enum {
        COLOUR_OK = 0,        /**< Done. */
        COLOUR_NOT_RED = 1,   /**< It is not "red", but
                                   another colour. */
        COLOUR_LAST = -7      /**< The last. */
    } colour_t;

    typedef enum { QUIET_A = 0, QUIET_B = 1 } quiet_t;
  C

  def test_SWR_CMD_004_compiled_names_and_sentences_are_those_of_the_header
    with_output('colour.h' => HEADER) do |folder|
      File.write(File.join(folder, 'main.c'), <<~C)
        #include "names.h"
        #include <stdio.h>
        int main(void)
        {
            for (int value = -1; value < 3; value++) {
                (void)printf("%s|%s\\n", colour_name(value), colour_text(value));
            }
            (void)printf("%s|%s\\n", colour_name(-7), colour_text(-7));
            return 0;
        }
      C
      program = File.join(folder, 'main')
      compile = ['gcc', '-std=c99', '-pedantic', '-Wall', '-Wextra', '-Werror', '-Wconversion', '-Wmissing-prototypes',
                 "-I#{folder}", '-o', program, File.join(folder, 'main.c'), File.join(folder, 'names.c')]
      output, status = Open3.capture2e(*compile)
      assert status.success?, output
      assert_equal <<~TEXT, `#{program}`
        UNKNOWN|Unknown.
        OK|Done.
        NOT_RED|It is not "red", but another colour.
        UNKNOWN|Unknown.
        LAST|The last.
      TEXT
    end
  end

  def test_SWR_CMD_004_console_gets_the_same_table
    with_output('colour.h' => HEADER) do |folder|
      table = File.read(File.join(folder, 'names.ts'))
      assert_includes table, 'export const colour = {'
      assert_includes table, '1: { name: "NOT_RED", text: "It is not \"red\", but another colour." },'
      assert_includes table, '[-7]: { name: "LAST", text: "The last." },'
    end
  end

  def test_SWR_CMD_004_an_enumeration_without_sentences_is_left_out
    with_output('colour.h' => HEADER) do |folder|
      refute_includes File.read(File.join(folder, 'names.h')), 'quiet'
    end
  end

  def test_SWR_CMD_004_refuses_a_sentence_without_a_value
    message = refuse(HEADER.sub('COLOUR_NOT_RED = 1', 'COLOUR_NOT_RED'))
    assert_includes message, 'colour.h:4: COLOUR_NOT_RED has no explicit value'
  end

  def test_SWR_CMD_004_refuses_a_value_used_twice
    assert_includes refuse(HEADER.sub('= -7', '= 1')), 'colour.h:6: COLOUR_LAST has the value of COLOUR_NOT_RED'
  end

  def test_SWR_CMD_004_refuses_a_marked_enumeration_without_a_sentence
    marked = HEADER.sub('refused. */', 'refused. @names */').sub('/**< Done. */', '')
    assert_includes refuse(marked), 'colour.h:3: COLOUR_OK has no sentence'
  end

  def test_SWR_CMD_004_refuses_the_same_name_in_two_headers
    in_folder('a.h' => HEADER, 'b.h' => HEADER) do |folder, headers|
      output, status = Open3.capture2e('ruby', TOOL, folder, *headers)
      refute status.success?
      assert_includes output, 'the enumeration colour_t is defined 2 times'
    end
  end

  def test_SWR_CMD_004_order_of_headers_does_not_matter
    other = HEADER.gsub('COLOUR', 'SHAPE').gsub('colour', 'shape')
    outputs = %i[itself reverse].map do |order|
      in_folder('a.h' => HEADER, 'b.h' => other) do |folder, headers|
        assert system('ruby', TOOL, folder, *headers.public_send(order))
        %w[names.h names.c names.ts].map { |name| File.read(File.join(folder, name)) }
      end
    end
    assert_equal outputs.first, outputs.last
  end

  private

  def with_output(files)
    in_folder(files) do |folder, headers|
      output, status = Open3.capture2e('ruby', TOOL, folder, *headers)
      assert status.success?, output
      yield folder
    end
  end

  def refuse(text)
    in_folder('colour.h' => text) do |folder, headers|
      output, status = Open3.capture2e('ruby', TOOL, folder, *headers)
      refute status.success?
      output
    end
  end

  def in_folder(files)
    Dir.mktmpdir do |folder|
      files.each { |name, text| File.write(File.join(folder, name), text) }
      yield folder, files.keys.map { |name| File.join(folder, name) }
    end
  end
end
