# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the robot of a page (build/site/robot.wasm) is the robot. It imports nothing; what both demonstrations
# have recorded on x86-64 it computes again, bit for bit; with its simulated control box it lives through a scene as native
# code does, of each robot; and without a robot it does nothing. The server of a page (build/site/served.wasm) says what
# the handlers of boresight-http say, and lets through what they let through. The page (build/site/page) needs nothing but its
# file; app/console/e2e/site.e2e.ts runs once, and each test on it here is the verdict of its part for one requirement. The page
# on which recordings are opened shows what boresight-replay writes, or the reason that it says.
# With BORESIGHT_SCREENSHOT=FILE it leaves a picture of the page.

require 'digest'
require 'minitest/autorun'
require 'json'
require 'open3'
require 'tmpdir'
require 'zlib'
require_relative '../demo/targets'
require_relative '../system/support/browser_run'

class TestSite < Minitest::Test
  include BrowserVerdicts

  ROOT = File.expand_path('../..', __dir__)
  MODULE = "#{ROOT}/build/site/robot.wasm"
  SERVED = "#{ROOT}/build/site/served.wasm"
  PAGE = "#{ROOT}/build/site/page/index.html"
  PAGE_BYTES = 300_000
  RECORDED = "#{ROOT}/build/site/recorded.wasm"
  RECORDED_PAGE = "#{ROOT}/build/site/page/replay.html"
  RECORDED_PAGE_BYTES = 300_000
  # Size of a recording, cut short in a block: the replay of all of it would last.
  RECORDED_BYTES = 100_000
  DAMAGED_AT = 50_000
  HEADER_VERSION = 8
  HEADER_ROBOT = 80
  HEADER_LAYOUT = 120
  HEADER_HASHED = 224
  REPLAY = "#{ROOT}/build/bin/boresight-replay"
  NEAR_MM = JSON.parse(File.read("#{ROOT}/build/gen/limits/limits.json")).find { |one| one['name'] == 'demo_error_nm' }['value'] / 1e6
  NATIVE = "#{ROOT}/build/gcc/bin/closed-loop-scene"
  NATIVE_SERVED = "#{ROOT}/build/gcc/bin/served-ask"
  ROBOTS = Dir.glob('*/robot.yml', base: "#{ROOT}/core/robot").map { |path| File.dirname(path) }.sort
  IMPORTS = 'console.log(WebAssembly.Module.imports(new WebAssembly.Module(fs.readFileSync(process.argv[1]))).length)'

  # Renewals of the pedal: a moment, and more than a start-up takes.
  SHORT = 10
  UNTIL_HOMED = 120
  CYCLES = 20_000
  SEED = 7
  # The NeuroRobot homes under a pedal that is released in between, jogs, and is broken then.
  SCENE = <<~LINES
    100 command 1 0 1 1 1 0
    200 order pedal press
    3000 order pedal pulse
    3500 order pedal release
    4000 order pedal press
    15000 order pedal release
    15100 command 2 0 1 1 6 0
    15200 command 3 0 1 29 0 -200
    15400 order pedal press
    16500 order scanner on
    16900 order scanner off
    17000 order switch 2 chatter
    17400 order push 10
    17500 order encoder 1 half
    17700 order motor 5 runs
    18000 order card 3 corrupt
    19000 order estop pull
    19500 order show
    19600 order nonsense
  LINES

  FORCE_CYCLES = 32_000
  # A hand, membranes, and load cells that fail.
  FORCE_SCENE = <<~LINES
    100 order hand stiffness 2000
    110 order hand speed 2000
    120 order push 100
    2000 order force hand noisy
    3000 order force needle drift
    5000 order force needle normal
    9000 order hand press
    15000 order show
    15100 order tissue show
    21000 order push -50
    25000 order tissue whole
    26000 order hand go -1500
    30000 order show
  LINES

  NEEDLE_CYCLES = 28_000
  # A needle that bends, turns behind its base and is drawn back, with a target and noisy images.
  NEEDLE_SCENE = <<~LINES
    50 order target usual
    60 order needle curvature 8000
    100 order push 100
    9000 order motor rotation runs
    12000 order needle show
    20100 order needle show
    20200 order push -60
    27999 order needle show
  LINES

  # Results of one run of the page.
  def self.results
    @results ||= Dir.mktmpdir do |folder|
      figure = "#{folder}/figure"
      recordings = recorded_files(folder)
      environment = { 'BORESIGHT_PAGE' => "file://#{PAGE}", 'BORESIGHT_FIGURES' => figure,
                      'BORESIGHT_RECORDING' => recordings.fetch('neuro'), 'BORESIGHT_DAMAGED' => recordings.fetch('damaged') }
      verdicts = BrowserRun.results('site.e2e.ts', environment)
      puts "SWR-SITE-010: it moves #{File.read(figure)} ms after it was opened" if File.exist?(figure)
      verdicts
    end
  end

  # The folder with the recordings of its run.
  def self.demonstration(robot)
    "#{ROOT}/build/demo/#{robot}"
  end

  # The first recording of that run.
  def self.beginning(robot)
    Dir["#{demonstration(robot)}/*.bsr"].min
  end

  # Files by what they are: a part of each demonstration's recording, and what is refused.
  def self.recorded_files(folder)
    parts = %w[neuro prostate].to_h { |robot| [robot, File.binread(beginning(robot), RECORDED_BYTES)] }
    own = parts.fetch('neuro')
    others = { 'damaged' => changed(own, DAMAGED_AT), 'foreign' => 'a' * 1000, 'short' => 'a', 'empty' => '',
               'version' => sealed(changed(own, HEADER_VERSION)), 'robot' => sealed(changed(own, HEADER_ROBOT)),
               'layout' => sealed(changed(own, HEADER_LAYOUT)) }
    parts.merge(others).to_h do |name, bytes|
      file = "#{folder}/#{name}.bsr"
      File.binwrite(file, bytes)
      [name, file]
    end
  end

  def self.changed(bytes, place)
    bytes.dup.tap { |copy| copy.setbyte(place, copy.getbyte(place) ^ 1) }
  end

  # With the right hash of the header.
  def self.sealed(bytes)
    bytes.dup.tap { |copy| copy[HEADER_HASHED, 32] = Digest::SHA256.digest(copy[0, HEADER_HASHED]) }
  end

  def node(*words, **options)
    Open3.capture2e('node', *words, **options)
  end

  def recordings
    found = %w[neuro prostate].to_h { |robot| [robot, self.class.demonstration(robot)] }
    assert found.keys.all? { |robot| self.class.beginning(robot) }, 'make both demonstrations first: make demo; make demo ROBOT=prostate'
    found
  end

  def broken(name, id)
    "#{name}: RuntimeError: Contract site/#{id} is broken, report this.\n"
  end

  # Registration and targets as a page sends them, with whole matrices.
  def table(robot)
    targets = Targets.new("#{ROOT}/core/robot/#{robot}/targets.yml")
    { registration: whole(targets.registration),
      targets: targets.each_target.map { |one| { pose: whole(Geometry.rows(one.rotation, one.point)), entry: one.entry } } }
  end

  def whole(rows)
    [*rows, 0, 0, 0, 1]
  end

  # The points that the robot in the page's file has come to.
  def reached(robot)
    said, status = Open3.capture2e('node', '--no-warnings', "#{__dir__}/table.mjs", PAGE, robot, stdin_data: JSON.generate(table(robot)))
    assert status.success?, said
    course = JSON.parse(said, symbolize_names: true)
    puts "SWR-SITE-021: #{robot}: #{course[:reached].size} targets in #{course[:seconds]} s of its time"
    course[:reached]
  end

  def assert_near(expected, point)
    assert_operator Geometry.distance(expected, point), :<=, NEAR_MM
  end

  # The course of the scene of serve.mjs, its calls and its answers.
  def serve(robot, renewals)
    Dir.mktmpdir do |folder|
      files = ["#{folder}/calls", "#{folder}/answers"]
      said, status = node("#{__dir__}/serve.mjs", SERVED, robot, renewals.to_s, *files)
      assert status.success?, said
      [JSON.parse(said), *files.map { |file| File.binread(file) }]
    end
  end

  def test_SWR_SITE_001_the_modules_import_nothing
    [MODULE, SERVED, RECORDED].each do |file|
      said, = node('-e', IMPORTS, file)
      assert_equal "0\n", said, file
    end
  end

  def test_SWR_SITE_002_what_the_demonstrations_recorded_is_computed_again_bit_for_bit
    runs = recordings.transform_values { |folder| Thread.new { node("#{__dir__}/replay.mjs", MODULE, folder) } }
    runs.each do |robot, run|
      said, status = run.value
      assert status.success?, "#{robot}: #{said}"
      assert_operator Integer(said), :>, 10_000
      puts "SWR-SITE-002: #{robot}: #{said.to_i} cycles equal"
    end
  end

  def test_SWR_SITE_002_a_state_that_is_not_as_recorded_is_reported_with_cycle_and_place
    said, status = node("#{__dir__}/replay.mjs", MODULE, recordings.fetch('neuro'), '4096')
    refute status.success?
    assert_match(/\ACycle 0 differs first in its .*: it is \d+ \(0x\h+\), recorded \d+ /, said)
  end

  # Where the second block of a recording begins and ends.
  def second_block(bytes)
    2.times.reduce([0, 256]) do |(_, at), _|
      size = bytes[at + 20, 4].unpack1('V')
      [at, at + 64 + (size.fdiv(1024).ceil * 4) + size]
    end
  end

  def replayed_alone(bytes)
    Dir.mktmpdir do |folder|
      File.binwrite("#{folder}/a.bsr", bytes)
      said, status = node("#{__dir__}/replay.mjs", MODULE, folder)
      refute status.success?
      said
    end
  end

  def test_SWR_SITE_002_a_run_with_a_gap_or_without_its_end_is_not_called_equal
    recordings
    bytes = File.binread(self.class.beginning('neuro'))
    from, to = second_block(bytes)
    first, after = [from, to].map { |at| bytes[at + 8, 4].unpack1('V') }
    assert_equal "cycles #{first} to #{after - 1} are missing\n", replayed_alone(bytes[0...from] + bytes[to..])
    bytes[-64, 4] = [0x4E455342].pack('V')
    assert_match(/\Athe run has no end: the last cycle is \d+\n\z/, replayed_alone(bytes))
  end

  # Where the outputs have their answers.
  def layout
    Open3.capture2e(NATIVE).first
  end

  def test_SWR_SITE_003_controller_and_box_live_through_a_scene_as_in_native_code
    lived = ROBOTS.to_h do |robot|
      native, = Open3.capture2e(NATIVE, robot, SEED.to_s, CYCLES.to_s, stdin_data: SCENE)
      said, = node("#{__dir__}/scene.mjs", MODULE, layout, robot, SEED.to_s, CYCLES.to_s, stdin_data: SCENE)
      assert_match(/^#{CYCLES} hash \d+$/, native, robot)
      assert_equal native.lines, said.lines, robot
      [robot, said]
    end
    # The scene is one in which something happens: homed and jogged.
    assert_match(/^\d+ answer 1 2 0$/, lived.fetch('neuro'))
    assert_match(/^\d+ answer 3 2 0$/, lived.fetch('neuro'))
  end

  def test_SWR_BOX_524_hand_tissue_and_load_cells_are_in_a_page_as_in_native_code
    native, = Open3.capture2e(NATIVE, 'prostate', SEED.to_s, FORCE_CYCLES.to_s, stdin_data: FORCE_SCENE)
    said, = node("#{__dir__}/scene.mjs", MODULE, layout, 'prostate', SEED.to_s, FORCE_CYCLES.to_s, stdin_data: FORCE_SCENE)
    assert_match(/2 ruptured$/, native)
    assert_match(/^#{FORCE_CYCLES} hash \d+$/, native)
    assert_equal native.lines, said.lines
  end

  def test_SWR_BOX_773_a_needle_bends_in_a_page_as_in_native_code
    native, = Open3.capture2e(NATIVE, 'prostate', SEED.to_s, NEEDLE_CYCLES.to_s, stdin_data: NEEDLE_SCENE)
    said, = node("#{__dir__}/scene.mjs", MODULE, layout, 'prostate', SEED.to_s, NEEDLE_CYCLES.to_s, stdin_data: NEEDLE_SCENE)
    assert_equal 3, native.scan(/^image [1-9]/).size, native
    assert_match(/^base turned by [1-9]\d+\.\d+ deg, [1-9]\d+\.\d+ deg ahead of the tip$/, native)
    assert_equal native.lines, said.lines
  end

  def test_SWR_SITE_004_what_is_asked_for_without_a_robot_stops_with_its_contract
    said, = node("#{__dir__}/contracts.mjs", MODULE, 'robot')
    expected = { order: 300, step: 301, block: 302, size: 303 }
    assert_equal expected.map { |name, id| broken(name, id) }, said.lines.grep(/\A(?:#{expected.keys.join('|')}):/)
  end

  def test_SWR_SITE_020_what_is_watched_without_a_robot_stops_with_its_contract
    said, = node("#{__dir__}/contracts.mjs", MODULE, 'robot')
    expected = { happened: 320, look: 320, compareBegin: 320, compare: 321 }
    assert_equal expected.map { |name, id| broken(name, id) }, said.lines.grep(/\A(?:#{expected.keys.join('|')}):/)
  end

  def test_SWR_SITE_006_the_server_of_a_page_answers_as_the_same_handlers_in_native_code
    ROBOTS.each do |robot|
      _, calls, answers = serve(robot, SHORT)
      native, = Open3.capture2e(NATIVE_SERVED, stdin_data: calls, binmode: true)
      assert_operator answers.bytesize, :>, 100_000, robot
      assert answers == native, "#{robot}: the answers differ" # A difference would be printed whole.
      puts "SWR-SITE-006: #{robot}: #{answers.bytesize} bytes of answers equal"
    end
  end

  def test_SWR_SITE_007_a_page_commands_the_robot_in_it_by_login_authority_and_pedal
    course, = serve('neuro', UNTIL_HOMED)
    assert_equal({ 'before_the_first_cycle' => 503, 'without_login' => 401, 'wrong_login' => 401, 'login' => 200,
                   'events' => 200, 'without_authority' => 423, 'authority' => 200, 'start_up' => 202,
                   'homed_without_pedal' => false, 'pedal' => 200, 'homed' => true,
                   'heard' => ['act 4 done', 'hello', 'log', 'state'], 'stop' => 200, 'stopped' => 'STOP' }, course)
  end

  def test_SWR_SITE_008_what_is_asked_of_the_server_without_a_robot_stops_with_its_contract
    said, = node("#{__dir__}/contracts.mjs", SERVED, 'served')
    expected = { step: 310, ask: 311, order: 313, command: 314, size: 312 }
    assert_equal expected.map { |name, id| "#{name}: RuntimeError: Contract served/#{id} is broken, report this.\n" }.join, said
  end

  def test_SWR_SITE_010_the_page_has_logged_in_and_the_axes_home_under_the_pedal
    assert_parts 'SWR-SITE-010'
  end

  def test_SWR_SITE_011_the_axes_stand_when_the_pedal_is_released_and_a_stop_is_heard
    assert_parts 'SWR-SITE-011'
  end

  def test_SWR_SITE_012_another_robot_is_a_link_away
    assert_parts 'SWR-SITE-012'
  end

  def test_SWR_SITE_013_the_page_says_what_it_is_so_that_everybody_can_read_it
    assert_parts 'SWR-SITE-013'
  end

  def test_SWR_SITE_014_time_in_the_page_stands_still_and_goes_on_by_one_cycle
    assert_parts 'SWR-SITE-014'
  end

  LINK = 'robot=neuro&seed=7&inputs=100:WORKPHASE,workphase=START_UP;200:pedal,press;1500:pedal,release'

  def test_SWR_SITE_027_a_link_is_played_in_a_page_as_in_the_module_without_a_server
    said, status = node("#{__dir__}/played.mjs", MODULE, SERVED, LINK, '2000')
    assert status.success?, said
    assert_match(/\A2000 cycles$.*^event PEDAL_RELEASED /m, said)
  end

  def test_SWR_SITE_027_another_input_would_be_seen
    said, status = node("#{__dir__}/played.mjs", MODULE, SERVED, LINK, '2000', LINK.sub('1500', '1501'))
    refute status.success?
    assert_match(/\ACycle 1500 /, said)
  end

  # Acts of the page, and their outcome when a link of them is played.
  def course(*words)
    (@@courses ||= {})[words] ||= begin
      said, status = node('--no-warnings', "#{__dir__}/course.mjs", SERVED, *words)
      assert status.success?, said
      JSON.parse(said)
    end
  end

  def test_SWR_SITE_029_what_was_done_in_a_page_has_the_same_outputs_elsewhere
    %w[neuro prostate].each do |robot|
      differences, inputs = course(robot).values_at('differences', 'inputs')
      assert_equal [300], differences.values, robot
      assert_match(/\A\d+: 8\z/, differences.keys.first, robot) # Notes: pedal, card, stop, pedal, and four requests.
      assert_includes inputs, 'card 3 silent'
      assert(inputs.any? { |input| input.match?(/\AWORKPHASE id=\d+ source=HTTP peer=4000000007 workphase=START_UP\z/) })
    end
  end

  def test_SWR_SITE_029_an_input_that_is_missing_would_be_seen
    assert_operator course('neuro', '1')['differences'].size, :>, 10
  end

  def test_SWR_SITE_033_what_would_be_if_is_said_of_the_robot_in_a_page
    with_estop, anyhow = course('neuro').fetch('answers')
    assert_match(/\ACycle \d+ \(\d+\.\d{3} s\): state workphase is EMERGENCY, was STOP\.\z/, with_estop.first)
    assert_empty anyhow
  end

  def test_SWR_SITE_032_time_goes_back_in_a_page_and_a_question_is_answered_there
    assert_parts 'SWR-SITE-032'
  end

  def test_SWR_SITE_034_what_is_held_opens_when_nobody_renews_it
    assert_equal %w[pressed released], course('neuro').values_at('held', 'left')
  end

  def test_SWR_SITE_028_a_link_is_played_when_it_is_opened_and_a_bad_one_refused_in_words
    assert_parts 'SWR-SITE-028'
  end

  def test_SWR_CON_611_a_hand_presses_in_the_page_and_no_doubtful_force_is_drawn
    assert_parts 'SWR-CON-611'
  end

  def test_SWR_SITE_022_a_pedal_that_is_released_in_motion_is_read
    assert_parts 'SWR-SITE-022'
  end

  def test_SWR_SITE_023_an_e_stop_in_motion_is_read
    assert_parts 'SWR-SITE-023'
  end

  def test_SWR_SITE_024_a_card_that_is_lost_in_motion_is_read
    assert_parts 'SWR-SITE-024'
  end

  def test_SWR_SITE_015_the_page_is_one_file_that_asks_for_nothing
    assert_equal %w[index.html replay.html], Dir.children(File.dirname(PAGE)).sort
    size = Zlib.gzip(File.binread(PAGE), level: 9).bytesize
    assert_operator size, :<=, PAGE_BYTES
    puts "SWR-SITE-015: the page has #{size} bytes when compressed"
    assert_parts 'SWR-SITE-015'
  end

  # Output of the module for a file, and of the replay; the latter without its notes on builds.
  def read_twice(file)
    Dir.chdir(File.dirname(file)) do
      name = File.basename(file)
      here, status = node('--no-warnings', "#{__dir__}/recorded.mjs", RECORDED, name, binmode: true)
      page, said, = Open3.capture3(REPLAY, '--html', '-', name, binmode: true)
      [here, status.success?, page[%r{<script id="recording" type="application/json">(.*?)</script>}mn, 1], said]
    end
  end

  def test_SWR_SITE_035_the_page_shows_what_the_replay_writes_of_each_demonstration
    Dir.mktmpdir do |folder|
      self.class.recorded_files(folder).slice('neuro', 'prostate').each do |robot, file|
        here, is_shown, page, = read_twice(file)
        assert is_shown, here
        assert here == page, "#{robot}: the pages differ" # A difference would be printed whole.
        assert_operator JSON.parse(here)['recording']['replayed'], :>, 1000
        puts "SWR-SITE-035: #{robot}: #{here.bytesize} bytes of a page equal"
      end
    end
    assert_parts 'SWR-SITE-035'
  end

  def test_SWR_SITE_036_what_is_no_recording_of_this_build_is_refused_in_the_words_of_the_replay
    Dir.mktmpdir do |folder|
      self.class.recorded_files(folder).except('neuro', 'prostate').each do |name, file|
        here, is_shown, page, said = read_twice(file)
        assert_equal [false, nil, said], [is_shown, page, here], name
        refute_empty said
      end
    end
    assert_parts 'SWR-SITE-036'
  end

  def test_SWR_SITE_036_what_goes_on_without_a_file_stops_with_its_contract
    said, = node('--no-warnings', "#{__dir__}/recorded.mjs", RECORDED)
    assert_equal "Cycle 0 breaks contract recorded/330.\n", said
  end

  def test_SWR_SITE_038_the_page_for_recordings_is_one_file_that_asks_for_nothing
    size = Zlib.gzip(File.binread(RECORDED_PAGE), level: 9).bytesize
    assert_operator size, :<=, RECORDED_PAGE_BYTES
    puts "SWR-SITE-038: the page for recordings has #{size} bytes when compressed"
    assert_parts 'SWR-SITE-038'
  end

  def test_SWR_SITE_016_a_robot_that_is_put_back_goes_on_as_it_did_and_otherwise_if_asked_otherwise
    said, = node('--no-warnings', "#{__dir__}/served_robot.mjs", SERVED, 'neuro')
    assert_equal({ 'role' => 'ENGINEER', 'again' => true, 'other' => false, 'reported' => true }, JSON.parse(said))
  end

  def test_SWR_SITE_021_table_1_of_the_thesis_is_reached_where_the_demonstration_has_come
    native = JSON.parse(File.read("#{ROOT}/build/demo/neuro/targets.json"), symbolize_names: true)
    points = reached('neuro')
    assert_equal native.size, points.size
    native.zip(points) { |row, point| row.values_at(:target, :reached).each { |expected| assert_near(expected, point) } }
  end
end
