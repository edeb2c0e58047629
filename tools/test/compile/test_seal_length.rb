# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: a seal of the core covers whole words, or the core does not compile.

require 'minitest/autorun'
require 'open3'

class TestSealLength < Minitest::Test
  CORE = File.expand_path('../../../core', __dir__)

  %w[gcc clang].each do |compiler|
    define_method("test_SWR_MEMORY_510_#{compiler}_refuses_a_length_of_other_than_whole_words") do
      assert compiles?(compiler, 8)
      [5, 6, 7].each { |bytes| refute compiles?(compiler, bytes) }
    end
  end

  # Lengths of the modes come from a table, whose compiler says the same.
  def test_SWR_MEMORY_510_every_length_that_a_seal_covers_is_checked
    calls = Dir.glob("#{CORE}/**/*.c").flat_map { |file| calls_in(File.read(file)) }
    table = File.read(File.expand_path('../../interface/mode_calls.rb', __dir__))
    refute_empty calls
    assert_empty calls.grep_v(/WHOLE_WORDS\(|range->bytes\)/)
    assert_includes table, '.bytes = (uint32_t)WHOLE_WORDS(sizeof('
  end

  private

  def compiles?(compiler, bytes)
    code = "#include \"base/seal.h\"\nuint32_t sum(const uint8_t *at);\n" \
           "uint32_t sum(const uint8_t *at)\n{\n    return seal_of(SEAL_START, at, WHOLE_WORDS(#{bytes}U));\n}\n"
    _, status = Open3.capture2e(compiler, '-std=c99', '-pedantic', '-Wall', '-Wextra', '-Werror', '-I', CORE, '-fsyntax-only', '-x', 'c', '-',
                                stdin_data: code)
    status.success?
  end

  # Each with its whole statement.
  def calls_in(text)
    text.scan(/\bseal_of\((?:[^;{]|\n)*;/)
  end
end
