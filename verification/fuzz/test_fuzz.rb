# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: whatever bytes come and whatever peers say, the sentences of codec_fuzz.c, request_fuzz.c and oracle.c hold. So many
# inputs, whatever time they take; `make fuzz` looks further.

require 'minitest/autorun'
require 'open3'
require 'tmpdir'

class TestFuzz < Minitest::Test
  FOLDER = File.expand_path('../../build/fuzz', __dir__)
  LAST_LINES = 60
  STREAMS = 400_000
  SCENES = 14_000

  def play(target, runs, longest)
    Dir.mktmpdir do |found|
      said, status = Open3.capture2e("#{FOLDER}/bin/#{target}", "-runs=#{runs}", '-seed=1', "-max_len=#{longest}",
                                     "-artifact_prefix=#{found}/", "#{FOLDER}/seeds/#{target}")
      assert status.success?, said.scrub.lines.last(LAST_LINES).join
      assert_match(/^Done #{runs} runs/, said.scrub)
    end
  end

  def test_SWR_IGTL_046_any_bytes_are_read_inside_their_bounds_and_however_they_are_cut_the_same
    play('codec', STREAMS, 6000)
  end

  def test_SWR_IGTL_023_any_file_of_ports_is_understood_or_refused_with_a_reason
    play('ports', 500_000, 2048)
  end

  def test_SWR_HTTP_011_any_body_and_query_is_read_within_its_bounds_or_refused_at_its_place
    play('request', 300_000, 4096)
  end

  def test_SWR_IGTL_047_what_must_hold_of_peers_and_commands_holds_whatever_they_say
    play('dialect', SCENES, 512)
  end
end
