# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# The rule under test: what our OpenIGTLink codec writes, the standard's own library reads the same, and the reverse.

require 'minitest/autorun'
require 'open3'
require_relative '../support/boresight'

class TestCodec < Minitest::Test
  def test_SWR_IGTL_005_the_standards_own_library_reads_what_we_write_and_writes_what_we_read
    output, status = Open3.capture2e(Boresight.program('codec-oracle'))
    assert status.success?, output
    assert_match(/\d+/, output)
  end

  def test_SWR_IGTL_046_what_we_accept_of_damaged_messages_the_standards_own_library_reads_the_same
    output, status = Open3.capture2e(Boresight.program('decode-differ'))
    assert status.success?, output
    %w[TRANSFORM STRING STATUS POINT TRAJ STT_TDATA GET_TRANS].each { |type| assert_match(/ #{type} \d{4,}/, output) }
  end
end
