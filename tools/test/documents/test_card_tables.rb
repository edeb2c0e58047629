# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: the page for a card's vendor has every word, bit and frame of the sources, its checksums hold by another
# program than ours, and every duty is one that the reference is tested for.

require 'minitest/autorun'
require_relative '../../documents/card_tables'
require_relative '../../trace/requirements'

class TestCardTables < Minitest::Test
  ROOT = File.expand_path('../../..', __dir__)
  PAGE = File.read(File.join(ROOT, 'docs/card-protocol.md'), encoding: 'UTF-8')
  REFERENCE = File.read(File.join(ROOT, 'verification/unit/sim/test_sim_card.c'), encoding: 'UTF-8')
  LIMITS = { 'longest' => Struct.new(:value).new('70') }.freeze
  # Words of the codec itself.
  CODEC = File.read(File.join(ROOT, 'core/card/card_frame.c'), encoding: 'UTF-8')

  def block(name)
    PAGE[/<!-- table:#{name} -->\n(.*?)<!-- end -->/m, 1]
  end

  def rows(name)
    cells(block(name))
  end

  def cells(table)
    table.strip.lines.drop(2).map { |line| line.strip.split('|').map(&:strip).drop(1) }
  end

  def test_SWR_CARD_008_a_field_may_take_several_lines_and_names_limits
    lines = " * 31..16 one: what it is,\n * in two; 0 to {longest}.\n * 15..0 two: the rest; 0."
    found = CardTables.new(ROOT, LIMITS).send(:fields, lines)
    assert_equal [['31..16', 'one', 'what it is, in two', '0 to 70'], ['15..0', 'two', 'the rest', '0']], found
  end

  # A word that is written down twice, overlaps another field, or is left out would mislead a manufacturer.
  def test_SWR_CARD_008_no_two_fields_of_a_word_overlap
    %w[card_command_words card_report_words].each do |name|
      rows(name).group_by(&:first).each do |word, fields|
        bits = fields.flat_map { |_, range| range.split('..').map(&:to_i).then { |high, low| [*(low || high)..high] } }
        assert_equal bits.uniq, bits, "word #{word} of #{name}"
      end
    end
  end

  def test_SWR_CARD_008_every_word_that_the_codec_names_is_on_the_page
    header = File.read(File.join(ROOT, 'core/card/card_words.h')).scan(/#define CARD_(\w+?)_(\w+) (\d+)U/)
    header.each do |direction, name, word|
      tables = direction == 'BOTH' ? %w[command report] : [direction.downcase]
      tables.each { |table| assert_includes rows("card_#{table}_words").map(&:first), word, name }
    end
    names = header.map { |direction, name| "CARD_#{direction}_#{name}" }
    assert_empty CODEC.scan(/\bCARD_(?:COMMAND|REPORT)_\w+/).uniq - names
  end

  def crc32c(bytes)
    bytes.reduce(0xFFFFFFFF) do |crc, byte|
      8.times.reduce(crc ^ byte) { |rest, _| rest.odd? ? (rest >> 1) ^ 0x82F63B78 : rest >> 1 }
    end ^ 0xFFFFFFFF
  end

  # By name: the words of a frame, and the sentence above it.
  def frames
    block('card_vectors').scan(/^`(\w+)`: (.*?)\n\n```text\n(.*?)```/m).map do |name, says, text|
      [name, says, text.split.map(&:hex)]
    end
  end

  def test_SWR_CARD_009_checksums_of_the_frames_hold_by_a_program_of_another_language
    assert_equal 0xE3069283, crc32c('123456789'.bytes)
    frames.each do |name, says, words|
      assert_equal 64, words.size, name
      damaged = says.include?('BAD_CRC') && !says.include?('no field')
      sum = 0xFFFFFFFF - (words[0..61].sum & 0xFFFFFFFF)
      assert_equal !damaged, words[62, 2] == [sum, crc32c(words[0..62].pack('N*').bytes)], name
    end
  end

  def test_SWR_CARD_009_the_page_has_every_frame_and_every_turn
    source = File.read(File.join(ROOT, CardTables::VECTORS), encoding: 'UTF-8')
    assert_equal source.scan(/^    \{"(\w+)",$/).flatten, frames.map(&:first)
    assert_equal source[/card_conversation.*/m].scan(/^    \{/).size, rows('card_conversation').size
    assert(rows('card_conversation').all? { |row| row.size == 9 })
  end

  def duties
    cells(PAGE[/^\| No\. \| Duty (?:.+\n)+/])
  end

  def test_SWR_CARD_010_every_test_of_the_reference_is_a_duty_and_the_other_way_round
    named = duties.flat_map { |row| row[3].scan(/\w*test_\w+/) }
    assert_equal REFERENCE.scan(/^void (test_\w+)/).flatten.sort, named.sort
  end

  def test_SWR_CARD_010_every_duty_serves_a_hazard_that_there_is
    hazards = Trace::Requirements.load('requirements', ROOT).of_kind('HAZ').map(&:id)
    duties.each do |number, _, served|
      refute_empty served.split(', '), number
      assert_empty served.split(', ') - hazards, number
    end
    assert_equal (1..duties.size).map(&:to_s), duties.map(&:first)
  end
end
