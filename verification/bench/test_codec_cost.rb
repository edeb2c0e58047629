# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: our OpenIGTLink codec needs at most a share of the instructions of the standard's own library, where
# that keeps its objects from message to message. Instructions, not time: they are the same on every run of one build.

require 'minitest/autorun'
require_relative 'codec'

class TestCodecCost < Minitest::Test
  LIMITS = JSON.parse(File.read(File.join(ROOT, 'build/gen/limits/limits.json')))
               .to_h { |limit| [limit['name'], limit['value']] }

  def self.instructions
    @instructions ||= Codec.new.instructions
  end

  def test_SWR_IGTL_022_packing_a_transform_is_cheaper_than_in_the_library
    assert_operator Codec.percent(self.class.instructions, 'pack'), :<=, LIMITS.fetch('igtl_pack_percent')
  end

  def test_SWR_IGTL_022_unpacking_a_transform_is_cheaper_than_in_the_library
    assert_operator Codec.percent(self.class.instructions, 'unpack'), :<=, LIMITS.fetch('igtl_unpack_percent')
  end
end
