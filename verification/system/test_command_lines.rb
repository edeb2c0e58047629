# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: every program answers the same questions about itself in the same way, and refuses what it does not know.

require 'minitest/autorun'
require 'open3'
require_relative 'support/boresight'

class TestCommandLines < Minitest::Test
  PROGRAMS = Dir.glob(Boresight.program('boresight*')).sort.freeze
  EACH = %w[boresight boresight-box boresight-client boresight-control boresight-http boresight-igtl boresight-passwd
            boresight-recorder boresight-replay boresight-simctl].freeze

  def test_SWR_RUN_001_each_program_says_what_it_does_and_takes
    assert_equal EACH, PROGRAMS.map { |program| File.basename(program) }
    PROGRAMS.each do |program|
      text = answer(program, '--help')
      assert_match(/\A[A-Z].*\.\n\nusage: #{File.basename(program)} /, text)
      assert_match(/^  -h, --help  +say this\n  --version  +say which version and build this is$/, text)
      assert_empty text.lines.reject { |line| line.chomp.size <= 80 }, program
      assert_equal text, answer(program, '-h')
    end
  end

  def test_SWR_RUN_001_each_program_says_its_version_and_build
    version = File.read(File.expand_path('../../CHANGELOG.md', __dir__))[/^## \[(.+)\]/, 1].downcase
    builds = PROGRAMS.map do |program|
      answer(program, '--version')[/\A#{File.basename(program)} #{version} \(build ([0-9a-f]{12}\+?|unknown\+?)\)\n\z/, 1]
    end
    assert_equal [builds.first], builds.uniq
    refute_nil builds.first
  end

  def test_SWR_RUN_002_each_program_refuses_what_is_no_option
    PROGRAMS.each do |program|
      name = File.basename(program)
      output, errors, status = Open3.capture3(program, '--nonsense', stdin_data: '')
      assert_equal ['', "#{name}: \"--nonsense\" is no option. See #{name} --help.\n", 2], [output, errors, status.exitstatus]
    end
  end

  private

  # On the standard output, and as asked.
  def answer(program, question)
    output, errors, status = Open3.capture3(program, question, stdin_data: '')
    assert_equal ['', 0], [errors, status.exitstatus], program
    output
  end
end
