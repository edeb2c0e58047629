# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: a page with a session of at least an operator stands for the person at the simulated box; nobody else comes
# there by HTTP, and what a page holds opens without it.

require_relative '../support/page_test'

class TestHttpBox < Minitest::Test
  include PageTest

  PATH = '/api/v1/box'
  SLIDE = 2 # Its slot.
  FREE_TEXTS = [{ pedal: 'press' }, { pedal: 'hold 7' }, { pedal: "hold\nshow" }, { order: 'pedal press' }, { card_fault: 'silent', slot: 10 },
                { card_fault: 'silent', slot: '3' }, { push_mm: 201 }, { pedal: ['hold'] }, { estop: 'reset', pedal: 'hold' }, {}].freeze

  def self.boresight
    @boresight ||= Boresight.start(arguments: ['--robot', 'bench2', '--accounts', accounts])
  end

  def teardown
    [%w[pedal release], %w[button release], %w[estop reset], %w[scanner off]].each { |words| boresight.simctl(*words) }
    super
  end

  def ask(one, method, order = nil, headers = {})
    one.request(method, PATH, order && JSON.generate(order), { SessionClient::PAGE => one.page.to_s }.merge(headers))
  end

  # State after an order, or the name of its refusal.
  def give(one, order)
    response = assert_described(PATH, 'POST', ask(one, 'post', order))
    JSON.parse(response.body).then { |body| response.code == '200' ? body : body.fetch('code') }
  end

  def box
    fetch_json(PATH)
  end

  def await_pedal(is_pressed)
    wait_until("the pedal is #{is_pressed ? 'pressed' : 'released'}") { box['is_pedal_pressed'] == is_pressed }
  end

  # A page that holds the pedal.
  def presser(name = 'anna')
    client(name).tap { |one| press(one) }
  end

  # Said again where the machine pauses for longer than the box waits.
  def press(one)
    wait_until('the pedal is pressed') { give(one, { pedal: 'hold' })['pedal_holder'] == one.page && box['is_pedal_pressed'] }
  end

  # Result of the block while the page held the pedal all the time; the same.
  def while_held(one)
    found = nil
    wait_until('the box has not let go meanwhile') do
      press(one)
      found = yield
      box['pedal_holder'] == one.page
    end
    found
  end

  def assert_refused_there(code, word, one, headers = {})
    { 'post' => { estop: 'pull' }, 'put' => nil, 'delete' => nil }.each do |method, order|
      assert_refused code, word, ask(one, method, order, headers)
    end
  end

  def test_SWR_HTTP_038_nobody_without_a_session_of_an_operator_comes_there
    anna = client('anna')
    assert_refused_there '401', 'NO_SESSION', client
    assert_refused_there '403', 'TOKEN_REFUSED', anna, SessionClient::TOKEN => 'another'
    assert_refused_there '403', 'ROLE_REFUSED', client('olga')
    assert_refused_there '400', 'PAGE_MISSING', anna, SessionClient::PAGE => nil
    assert_refused_there '403', 'ORIGIN_REFUSED', anna, 'Origin' => 'http://elsewhere.example'
    refute box['is_estop_pulled']
  end

  def test_SWR_HTTP_038_only_words_of_the_tables_come_there
    anna = client('anna')
    seen = -> { box.reject { |name, _| name.start_with?('is_lamp_') } } # Control sets these.
    before = seen.call
    FREE_TEXTS.each { |order| assert_includes %w[BAD_BODY OUT_OF_RANGE], give(anna, order), order }
    assert_equal before, seen.call
  end

  def test_SWR_HTTP_038_an_order_is_obeyed_logged_and_its_effect_reported
    anna = client('anna')
    assert give(anna, { scanner: 'on' })['is_scanner_active']
    assert give(anna, { estop: 'pull' })['is_estop_pulled']
    seen = give(anna, { slot: SLIDE, motor_fault: 'half' })
    assert_equal %w[slide half], seen['slots'][SLIDE].values_at('axis', 'motor_fault')
    assert_equal 'BOX_REFUSED', give(anna, { slot: SLIDE, plug: 'none' })
    [{ scanner: 'off' }, { estop: 'reset' }, { slot: SLIDE, motor_fault: 'normal' }].each { |order| assert_kind_of Hash, give(anna, order) }
    assert_described PATH, 'GET', get(PATH)
    said = "anna: ordered of the simulated box: motor #{SLIDE} half."
    wait_until('it stands in the log') { boresight.log.any? { |entry| entry['text'] == said } }
  end

  def lit
    box.filter_map { |name, is_lit| name[/\Ais_lamp_(.*)/, 1] if is_lit == true }.compact
  end

  def test_SWR_HTTP_038_the_lamps_of_the_box_are_reported
    assert give(client('anna'), { estop: 'pull' })['is_estop_pulled']
    wait_until('the e-stop is shown') { lit == %w[alive fault] }
  end

  def test_SWR_HTTP_057_beginning_and_end_of_a_hold_are_logged_once
    anna = client('anna')
    before = boresight.log.last.fetch('number')
    %w[hold hold drop drop drop].each { |word| assert_kind_of Hash, give(anna, { button: word }) }
    assert_kind_of Hash, give(anna, { gate: 'off' })
    said = -> { boresight.log(before + 1).map { |entry| entry['text'] }.grep(/\Aanna: ordered of the simulated box: /) }
    wait_until('what came last stands in the log') { said.call.any?(/gate off/) }
    assert_equal(%w[hold drop], said.call.filter_map { |text| text[/button (\w+)/, 1] })
  end

  def test_SWR_HTTP_039_what_a_page_holds_no_other_page_gets_or_opens
    anna = client('anna')
    egon = client('egon')
    found = while_held(anna) do
      [give(egon, { pedal: 'hold' }), give(egon, { pedal: 'drop' })['is_pedal_pressed'],
       assert_described(PATH, 'DELETE', ask(egon, 'delete')).code, box['is_pedal_pressed']]
    end
    assert_equal ['BOX_HELD', true, '200', true], found
    egon.page = anna.page
    assert_refused '403', 'PAGE_REFUSED', ask(egon, 'delete')
    ask(anna, 'delete')
    await_pedal false
  end

  def test_SWR_HTTP_039_a_held_pedal_is_kept_and_keeps_no_session_awake
    anna = presser
    left = -> { JSON.parse(anna.request('get', SessionClient::PATH).body).fetch('idle_s') }
    wait_until('some of it has passed while it was kept') do
      press(anna)
      whole = left.call
      wait_until('it is lost or some has passed') { !keeps?(anna) || left.call < whole }
      keeps?(anna)
    end
  end

  def keeps?(one)
    JSON.parse(assert_described(PATH, 'PUT', ask(one, 'put')).body)['pedal_holder'] == one.page
  end

  def test_SWR_BOX_020_a_killed_server_leaves_no_pedal_pressed
    presser
    Process.kill('STOP', boresight.pid) # Otherwise another server would come, and let go.
    boresight.kill('http', 'KILL')
    wait_until('the pedal is released') { boresight.simctl('show').include?('pedal a open, pedal b open') }
  ensure
    Process.kill('CONT', boresight.pid)
    wait_until('another server answers') { boresight.patiently { box['pedal_holder'].zero? } }
  end

  def test_SWR_BOX_020_a_page_that_says_nothing_or_has_logged_out_holds_nothing
    presser
    await_pedal false
    anna = presser
    anna.log_out
    assert_refused '401', 'NO_SESSION', ask(anna, 'put')
    await_pedal false
  end

  def test_SWR_BOX_022_a_box_that_stands_is_reported_and_does_nothing_later
    anna = client('anna')
    boresight.while_stopped('box') { assert_equal 'BOX_SILENT', give(anna, { scanner: 'on' }) }
    wait_until('it goes on') { give(anna, { gate: 'off' }).is_a?(Hash) }
    refute box['is_scanner_active']
  end

  def test_SWR_CON_040_the_drawer_works_in_a_browser
    environment = { 'BORESIGHT_URL' => "http://#{host}/", 'BORESIGHT_LOGIN' => "anna #{Accounts::PASSWORDS.fetch('anna').last}" }
    said, status = Open3.capture2e(environment, 'npx', 'vitest', 'run', '--config', 'vitest.e2e.config.ts', 'box.e2e.ts',
                                   chdir: File.expand_path('../../../app/console', __dir__))
    assert status.success?, said
  end
end
