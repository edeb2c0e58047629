# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'minitest/autorun'
require 'open3'

# Rule under test: the sources have the form that .clang-format and .rubocop.yml say. `make format` brings them to it.
class TestFormat < Minitest::Test
  ROOT = File.expand_path('../..', __dir__)
  LINES = 20

  def test_SWR_TOOL_040_sources_in_c_have_their_form
    assert_formed('clang-format', '--dry-run', '--Werror', *tracked('*.c', '*.h', '*.cpp'))
  end

  def test_SWR_TOOL_040_sources_in_ruby_have_their_form
    assert_formed('rubocop', '--format', 'emacs', *tracked('*.rb'))
  end

  private

  def tracked(*patterns)
    Dir.chdir(ROOT) { IO.popen(['git', 'ls-files', '-z', *patterns], &:read).split("\0").select { |file| File.exist?(file) } }
  end

  def assert_formed(*command)
    said, status = Open3.capture2e(*command, chdir: ROOT)
    assert status.success?, "run `make format`:\n#{said.lines.first(LINES).join}"
  end
end
