# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the table of a board says what its file says, and a wrong file is refused with line, field and reason.

require 'minitest/autorun'
require_relative '../../compile/boards'

class TestBoards < Minitest::Test
  ROOT = File.expand_path('../../..', __dir__)
  LIMITS = "#define LIMIT_MOST_WATTS (9U) /**< SWR-ANY-001, W. */\n"
  GOOD = <<~YAML
    options:
      - {name: watts, takes: number, least: 1, most: most_watts, default: 2, says: of its light}
      - {name: lamp, takes: name, default: "{instance}-lamp", says: one that shines}
      - {name: dim, says: less}
    companions:
      - {program: boresight-lamp, arguments: [--as, "{lamp}", "{dim}"], ready: on, unless: lamp}
      - {program: boresight-fan}
    box: "{lamp}"
    name: "{lamp}"
    slowness: "{watts}"
    simulated: true
    cycle: {wire_hz: 5000000, wires: 10, word_ns: 300, instructions_per_us: 333, publish_us: 30}
    cycle_lane_mb: 70
    says:
      - {title: Lamp, text: "say \\"{lamp}\\""}
  YAML

  def test_SWR_TOOL_015_the_table_says_what_the_file_says
    source = board(GOOD).source
    ['.name = "watts", .takes = BOARD_TAKES_NUMBER, .says = "of its light", .otherwise = "2", .least = 1U, .most = LIMIT_MOST_WATTS}',
     '.name = "lamp", .takes = BOARD_TAKES_NAME, .says = "one that shines", .otherwise = "{instance}-lamp"}',
     '.program = "lamp", .arguments = {"--as", "{lamp}", "{dim}"}, .ready = "on", .unless = "lamp"}',
     '{.program = "fan"}', '.box = "{lamp}",', '.name = "{lamp}",', '.slowness = "{watts}",', '.is_simulated = true,',
     '.cycle = {.wire_hz = 5000000U, .wires = 10U, .word_ns = 300U, .instructions_per_us = 333U, .publish_us = 30U, ' \
     '.dialect = CARD_DIALECT_OWN},', '.cycle_lane_mb = 70U,',
     '{"Lamp", "say \\"{lamp}\\""}'].each { |text| assert_includes source, text }
  end

  def test_SWR_TOOL_015_what_only_a_companion_takes_is_useless_with_another_one
    assert_includes board(GOOD).source, '.name = "dim", .takes = BOARD_TAKES_NOTHING, .says = "less", .useless_with = "lamp"}'
  end

  def test_SWR_CHECK_009_the_budget_knows_what_the_cards_speak
    assert_includes board("#{GOOD}cards: aim32\n").source, '.dialect = CARD_DIALECT_AIM32},'
    error = assert_raises(Robot::Refused) { board("#{GOOD}cards: aim33\n") }
    assert_equal 'bsp/any/board.yml:16: cards: is aim33; expected own or aim32', error.message
    header = File.read(File.join(ROOT, 'core/card/card_dialect.h'))
    assert_equal Board::DIALECTS, header.scan(/CARD_DIALECT_(\w+) = /).flatten.map(&:downcase)
  end

  # The data that the board gives control about itself is in its sources.
  def test_SWR_CHECK_009_the_board_says_the_same_of_its_cards
    files = Dir[File.join(ROOT, 'bsp/*/board.yml')]
    foreign = files.select { |file| File.read(file).match?(/^cards: aim32$/) }
    telling = files.select { |file| File.read(File.join(File.dirname(file), "bsp_#{File.basename(File.dirname(file))}.c")).include?('CARD_DIALECT_AIM32') }
    refute_empty foreign
    assert_equal foreign, telling
  end

  def test_SWR_TOOL_015_a_board_needs_nothing_but_what_control_opens
    source = board("box: slot-one\n").source
    assert_equal 3, source.scan(/^        \{0\},$/).size
    ['.box = "slot-one",', '.name = "{instance}",', '.slowness = "1",', '.is_simulated = false,', '.cycle = {0},',
     '.cycle_lane_mb = LIMIT_CYCLE_LANE_MB,'].each { |text| assert_includes source, text }
  end

  WRONG = {
    'box: "{lamp}"' => ['box: "{fan}"', '8: box: speaks of {fan}; expected instance, robot, programs, recordings, watts, lamp, dim'],
    'name: "{lamp}"' => ['name: "{dim}"', '9: name: speaks of {dim}; expected instance, robot, watts, lamp'],
    'slowness: "{watts}"' => ['slowness: "{watts"', '10: slowness: is {watts, with a brace too many'],
    'simulated: true' => ['simulated: perhaps', '11: simulated: is perhaps; expected true or false'],
    "simulated: true\n" => ["simulated: true\nloads_library: libx.so\n", '12: loads_library: is libx.so; expected true or false'],
    'most: most_watts' => ['most: most_volts', '2: options[0].most: is most_volts, which is no limit of the requirements'],
    ', default: 2' => ['', '2: options[0]: has no default'],
    'takes: number' => ['takes: text', '2: options[0]: has bounds if it takes a number, and only then'],
    '{name: dim,' => ['{name: dim, default: 1,', '4: options[2]: takes nothing, and no default or bound'],
    'name: dim' => ['name: robot', '4: options[2].name: is robot, which there is already'],
    'boresight-fan' => ['fan', '7: companions[1].program: is fan; expected boresight-...'],
    'unless: lamp' => ['unless: fan', '6: companions[0].unless: is fan; expected watts or lamp or dim'],
    'cycle_lane_mb: 70' => ['cycle_lane_mb: 0', '13: cycle_lane_mb: is 0; expected 20 to 1000'],
    'wires: 10' => ['wires: 0', '12: cycle.wires: is 0; expected 1 to 2147483648'],
    ', publish_us: 30' => ['', '12: cycle.publish_us: is missing'],
    'title: Lamp' => ['title: Illumination', '15: says[0].title: is Illumination; expected at most 11 letters'],
    '{instance}-lamp' => ['{watts}-lamp', '3: options[1].default: speaks of {watts}; expected instance, robot, programs, recordings'],
    'ready: on' => ['colour: red', '6: companions[0].colour: is unknown; expected program, arguments, ready, unless']
  }.freeze

  def test_SWR_TOOL_015_a_wrong_file_is_refused
    WRONG.each do |good, (bad, reason)|
      assert_includes GOOD, good
      error = assert_raises(Robot::Refused) { board(GOOD.sub(good, bad)) }
      assert_equal "bsp/any/board.yml:#{reason}", error.message
    end
  end

  def test_SWR_TOOL_015_no_more_than_the_table_holds
    header = File.read(File.join(ROOT, 'app/supervisor/board.h'))
    { OPTIONS: Board::OPTIONS, COMPANIONS: Board::COMPANIONS, ARGUMENTS: Board::ARGUMENTS, SAYINGS: Board::SAYINGS }
      .each { |name, most| assert_match(/#define BOARD_#{name} #{most}U/, header) }
    flags = Array.new(Board::OPTIONS + 1) { |i| "  - {name: flag#{i}}\n" }.join
    error = assert_raises(Robot::Refused) { board("box: any\noptions:\n#{flags}") }
    assert_match(/:11: options\[8\]: is too much; at most 8 are possible/, error.message)
  end

  private

  def board(text)
    Board.new('bsp/any/board.yml', text, LIMITS)
  end
end
