# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: hand and tissue of the simulated box are felt by the sensor card, through all programs.

require_relative '../support/page_test'

class TestHttpForce < Minitest::Test
  include PageTest

  SENSOR = 'sensor'
  AT_REST = [1970, 1780].freeze # Of hand and needle.
  NOISE = 12
  NEWTON = 113 # Counts.

  def self.boresight
    @boresight ||= Boresight.start(arguments: ['--robot', 'prostate', '--accounts', accounts, *Boresight::FAST]).tap(&:home_fast)
  end

  def teardown
    boresight.simctl('hand', 'release')
    super
  end

  # Readings of hand and needle.
  def forces
    fetch_json('/api/v1/status').fetch('cards').find { |card| card['type'] == SENSOR }.fetch('converters')[1..2]
  end

  def jog(anna, millimetres)
    order = { position: millimetres, unit: 'mm' }
    assert_answer '202', 'accepted', anna.act('motors/insertion/jog', order)
    id = anna.id
    boresight.simctl('pedal', 'press')
    wait_until("the needle is at #{millimetres} mm") do
      anna.keep
      JSON.parse(anna.act('motors/insertion/jog', order, id:).body)['state'] == 'done'
    end
  ensure
    boresight.simctl('pedal', 'release')
  end

  def ruptured
    boresight.simctl('show')[/(\d) ruptured/, 1].to_i
  end

  def test_SWR_BOX_532_the_needle_feels_membranes_on_its_way_in
    anna = holder
    under_pedal(anna, 'needle/retract')
    boresight.simctl('tissue', 'whole') # Another test may have gone through it.
    assert_answer '200', 'done', anna.act('workphase', { workphase: 'MANUAL' })
    jog(anna, 25)
    forces.zip(AT_REST) { |reading, rest| assert_in_delta rest, reading, NOISE }
    jog(anna, 32)
    assert_operator forces.last, :>, AT_REST.last + (0.6 * NEWTON)
    assert_equal 0, ruptured
    jog(anna, 40)
    assert_equal 1, ruptured
    assert_operator forces.last, :<, AT_REST.last + (0.6 * NEWTON)
    assert_in_delta AT_REST.first, forces.first, NOISE
  end

  def needle
    fetch_json('/api/v1/box').fetch('needle')
  end

  def test_SWR_BOX_779_the_true_needle_bends_while_it_is_driven_in
    anna = holder
    under_pedal(anna, 'needle/retract')
    boresight.simctl('target', 'usual')
    assert_answer '200', 'done', anna.act('workphase', { workphase: 'MANUAL' })
    jog(anna, 25)
    wait_until('the tip is shown at 25 mm') { (needle['way'].last['depth_mm'] - 25).abs < 0.1 }
    assert_in_delta 0, needle['way'].last['y_mm'], 1e-9
    jog(anna, 70)
    wait_until('the tip is shown 3.3 mm off its line') { (needle['way'].last['y_mm'] + 3.271).abs < 0.02 }
    needle['target'].values_at('x_mm', 'y_mm', 'depth_mm').zip([2.4, -1.8, 102]) { |seen, expected| assert_in_delta expected, seen, 0.01 }
    assert_operator needle['image']['number'], :>, 0
    assert_includes boresight.simctl('needle', 'show'), 'off the line at 69.8'
    boresight.simctl('tissue', 'none')
    assert_nil needle
  ensure
    boresight.simctl('tissue', 'usual')
  end

  def ask(one, method, order = nil)
    one.request(method, '/api/v1/box', order && JSON.generate(order), { SessionClient::PAGE => one.page.to_s })
  end

  def await_hand(newtons)
    wait_until("the hand presses with #{newtons} N") { (forces.first - AT_REST.first - (newtons * NEWTON)).abs < NOISE }
  end

  def test_SWR_HTTP_039_a_page_holds_the_handle_with_its_grip_until_it_is_silent
    anna = client('anna')
    assert_equal 5000, JSON.parse(ask(anna, 'post', { grip_mn: 5000 }).body)['grip_mn']
    assert_equal anna.page, JSON.parse(ask(anna, 'post', { hand: 'hold' }).body)['hand_holder']
    wait_until('the handle is pressed, while the page says so') do
      ask(anna, 'post', { hand: 'hold' })
      (forces.first - AT_REST.first - (5 * NEWTON)).abs < NOISE
    end
    await_hand(0)
    refute fetch_json('/api/v1/box')['is_hand_pressed']
  end

  IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1].freeze

  def enter(anna, *workphases)
    workphases.each { |workphase| anna.act('workphase', { workphase: }) }
  end

  # The block is called again and again until it is done.
  def under_pedal(anna, path)
    assert_includes %w[200 202], anna.act(path).code, anna.last.body
    id = anna.id
    boresight.simctl('pedal', 'press')
    wait_until("#{path} is done") do
      anna.keep
      yield if block_given?
      JSON.parse(anna.act(path, id:).body)['state'] == 'done'
    end
  ensure
    boresight.simctl('pedal', 'release')
  end

  def axis(name)
    fetch_json('/api/v1/motors').fetch('axes').find { |one| one['name'] == name }
  end

  def next_step
    fetch_json('/api/v1/status').fetch('next_step').fetch('name')
  end

  # Aligned with a target, of which the entry point is straight above it; the sensor is zeroed.
  def prepare(anna, entry_z, target_z)
    under_pedal(anna, 'needle/retract')
    wait_until('the sensor is zeroed') { anna.act('force/zero').code == '200' }
    wait_until('its force is believed') { fetch_json('/api/v1/status').fetch('forces').all? { |force| force['doubts'].empty? } }
    enter(anna, 'PLANNING', 'CALIBRATION')
    anna.act('targeting/registration', { matrix: IDENTITY })
    enter(anna, 'PLANNING', 'TARGETING')
    anna.act('targeting/entry', { point_mm: [5, -10, entry_z] })
    assert_answer '200', 'done', anna.act('targeting/target', { point_mm: [5, -10, target_z] })
    under_pedal(anna, 'align')
  end

  # Does with the handle what the next step says.
  def push
    case next_step
    when 'PUSH'
      @rests_before = !axis('insertion')['is_driven'] if @rests_before.nil?
      boresight.simctl('grip', '1000')
      boresight.simctl('hand', 'press')
    when 'LET_GO'
      boresight.simctl('hand', 'release')
    end
  end

  def test_SWR_COOP_001_a_hand_brings_the_needle_to_its_target_by_http
    anna = holder
    prepare(anna, 22, 52)
    enter(anna, 'MOVE_TO_TARGET')
    under_pedal(anna, 'needle/cooperate') { push }
    assert @rests_before, 'nothing moves before the push'
    assert_in_delta axis('insertion')['target'], axis('insertion')['position'], 0.01
  end

  def expect(anna, *depths)
    anna.act('targeting/membranes', { depths_mm: depths })
  end

  def membranes
    fetch_json('/api/v1/targeting').fetch('membranes')
  end

  def states
    membranes.fetch('expected').map { |membrane| membrane['state'] }
  end

  # Until the needle is so many mm below the entry point.
  def insert_to(anna, depth)
    enter(anna, 'MOVE_TO_TARGET')
    assert_answer '202', 'accepted', anna.act('needle/cooperate')
    boresight.simctl('pedal', 'press')
    wait_until("the needle is #{depth} mm deep") do
      anna.keep
      push
      membranes.fetch('depth_mm') > depth
    end
    enter(anna, 'STOP')
  ensure
    boresight.simctl('pedal', 'release')
  end

  # Entry point, target and expected membranes of 20 mm: the first one of the tissue is there, none is at 35 and at 45 mm.
  def test_SWR_PUNCT_618_membranes_are_expected_found_and_missed_by_http
    anna = holder
    prepare(anna, 32, 92)
    boresight.simctl('tissue', 'whole') # With the needle out.
    assert_answer '409', 'MEMBRANE_DEPTH', expect(anna, 20, 60.5)
    assert_answer '409', 'MEMBRANE_ORDER', expect(anna, 35, 20)
    assert_answer '200', 'done', expect(anna, 20, 35, 45)
    assert_described '/api/v1/targeting/membranes', 'POST', anna.last
    assert_equal %w[AHEAD AHEAD AHEAD], states
    assert_equal [3, 'OFF', nil], membranes.values_at('left', 'sight', 'depth_mm')
    insert_to(anna, 57)
    wait_until('the insertion has ended') { membranes['sight'] == 'OFF' }
    assert_equal %w[FOUND MISSED MISSED], states
    assert_in_delta 20.5, membranes['expected'].first['found_mm'], 1.5
    assert_equal [0, 1], membranes.values_at('left', 'unexpected')
    assert_described '/api/v1/targeting', 'GET', client('anna').request('get', '/api/v1/targeting')
    assert_replayed
  end

  def steer(anna, method, curvature_per_km, direction_deg)
    anna.act('targeting/steering', { method:, curvature_per_km:, direction_deg: })
  end

  def steering
    fetch_json('/api/v1/targeting').then do |targeting|
      [targeting['steering_method']['name'], *targeting.values_at('steering_curvature_per_km', 'steering_direction_deg')]
    end
  end

  def test_SWR_STEER_012_a_needle_is_steered_to_its_target_by_http
    anna = holder
    prepare(anna, 22, 52)
    assert_answer '409', 'STEERING_CURVATURE', steer(anna, 'BIDIRECTIONAL', 5000, 0)
    assert_answer '200', 'done', steer(anna, 'BIDIRECTIONAL', 1200, -90)
    assert_described '/api/v1/targeting/steering', 'POST', anna.last
    assert_equal ['BIDIRECTIONAL', 1200, -90], steering
    enter(anna, 'MOVE_TO_TARGET')
    turned = []
    under_pedal(anna, 'needle/insert') { turned << axis('rotation')['position'] }
    assert_operator turned.min, :<, -200
    assert_operator turned.max, :>, 20
    assert_in_delta 52, fetch_json('/api/v1/targeting')['scanner_treatment'][11], 0.05
    assert_replayed
  end

  def assert_replayed
    text, = Open3.capture2e(Boresight.program('boresight-replay'), boresight.recording_files.last)
    assert_match(/^\d{3,} of .* cycles replayed, their outputs equal/, text)
  end
end
