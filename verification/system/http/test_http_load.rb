# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: a crowd at the HTTP server costs no cycle, no event, no stop and no move, and a bounded memory. How much
# later anything comes is shown by `make bench`, and judged nowhere.

require_relative '../support/session_client'
require_relative '../support/system_test'
require_relative '../../bench/crowd'

# Course of a system in a crowd: it homed, moved to a target, and was stopped on the way to another one.
class CrowdedRun
  attr_reader :off_nm, :early_events, :stop_codes, :counts, :server_kb, :seen, :event_numbers, :replayed

  def initialize(accounts, counts)
    @robot = Boresight.start(arguments: ['--robot', TargetMove::ROBOT, '--accounts', accounts])
    @seen = Crowd.around(@robot.http_port, **counts) { act(TargetMove.new(@robot)) }
    look
  ensure
    @robot&.kill_all
  end

  private

  # The first stop ends a motion and comes by the port for stops, the second one by the console's.
  def act(target_move)
    target_move.prepare
    @early_events = @robot.status['counts']['events']
    target_move.move
    @off_nm = target_move.off_nm
    target_move.begin_move
    @stop_codes = [@robot.post_stop(@robot.stop_port).code]
    @robot.wait_until('nothing is driven') { !@robot.moving? }
    @stop_codes << @robot.post_stop.code
  end

  def look
    @counts = @robot.status['counts']
    @server_kb = Integer(File.read("/proc/#{@robot.pid_of('http')}/status")[/^VmHWM:\s+(\d+) kB$/, 1])
    Process.kill('TERM', @robot.pid)
    @robot.wait_for_end
    @event_numbers = @robot.event_lines.map { |line| Integer(line.split[1]) }
    @replayed = @robot.recording_files.map { |file| Open3.capture2e(Boresight.program('boresight-replay'), file) }
  end
end

class TestHttpLoad < SystemTest
  LIMITS = JSON.parse(File.read(File.expand_path('../../../build/gen/limits/limits.json', __dir__)))
               .to_h { |limit| limit.values_at('name', 'value') }
  CROWDS = { 'streams that are read' => { consoles: 8 },
             'streams that nobody reads' => { consoles: 2, lazy: 40 },
             'requests without a pause' => { consoles: 2, comers: 16 },
             'half requests' => { consoles: 2, halves: 100 },
             'guessed passwords' => { consoles: 2, guessers: 8 },
             'all of them' => { consoles: 2, lazy: 40, comers: 16, halves: 100, guessers: 8 } }.freeze
  WORKERS = 64 # HTTP_CONNECTIONS_WORKERS
  PLACES = 512 # STOP_PORT_CLIENTS
  SERVED = { comers: 'answered', halves: 'refused', guessers: 'refused', lazy: 'dropped' }.freeze

  def self.runs
    @runs ||= CROWDS.transform_values { |counts| CrowdedRun.new(Accounts.make_for_a_while, counts) }
  end

  def each_run(&)
    self.class.runs.each(&)
  end

  def test_SWR_LOAD_001_no_cycle_and_no_event_is_lost
    each_run do |crowd, run|
      assert_equal [0, 0], run.counts.values_at('cycles_lost', 'events_lost'), crowd
      assert_equal (0...run.counts['events']).to_a, run.event_numbers.first(run.counts['events']), crowd
      assert_equal 1, run.replayed.size, crowd
      text, status = run.replayed.first
      assert_equal [0, false], [status.exitstatus, text.match?(/follow no checkpoint|lost/)], "#{crowd}: #{text}"
    end
  end

  def test_SWR_LOAD_002_the_move_ends_truly_at_its_target
    each_run { |crowd, run| assert_operator run.off_nm, :<=, LIMITS.fetch('crowd_error_nm'), crowd }
  end

  def test_SWR_LOAD_003_every_stop_is_answered_and_the_motion_ends
    each_run { |crowd, run| assert_equal %w[200 200], run.stop_codes, crowd }
  end

  def test_SWR_LOAD_003_stops_are_answered_while_half_requests_come_again_and_again_to_their_port
    stop_port = boresight.stop_port
    codes = nil
    seen = Crowd.around(stop_port, halves: 600) { codes = Array.new(20) { boresight.post_stop(stop_port).code } }
    assert_equal({ '200' => 20 }, codes.tally)
    assert_operator seen.dig('halves', 'refused'), :>, 300
  end

  def test_SWR_LOAD_004_the_servers_memory_is_bounded
    each_run { |crowd, run| assert_operator run.server_kb, :<=, LIMITS.fetch('http_memory_kb'), crowd }
    puts "SWR-LOAD-004: #{self.class.runs.values.map(&:server_kb).max} kB at most"
  end

  def test_SWR_LOAD_005_who_reads_hears_every_event
    each_run do |crowd, run|
      assert_equal [CROWDS.dig(crowd, :consoles), 0, 0], run.seen['consoles'].values, crowd
      assert_equal 0, run.seen['missed'], crowd
      assert_operator run.seen['events'], :>=, CROWDS.dig(crowd, :consoles) * run.early_events, crowd
    end
  end

  # Niceness of each thread of a program, 0 to 19; with the number of threads.
  def niceness_of(name)
    Dir.glob("/proc/#{boresight.pid_of(name)}/task/*/stat").map { |path| Integer(File.read(path).split(') ').last.split[16]) }.tally
  end

  def test_SWR_LOAD_007_the_workers_stand_back_and_nobody_else
    server = niceness_of('http')
    assert_equal [1, true], [server[0], server[10].to_i > 64], server.to_s
    assert_equal [[0], [0]], [niceness_of('recorder').keys, niceness_of('igtl').keys]
  end

  # They come while no worker serves them: the kernel keeps them.
  def test_SWR_LOAD_006_who_comes_waits_for_a_worker_in_turn
    boresight.while_stopped('http') do
      waiting = Array.new(LIMITS.fetch('waiting_clients')) do
        Socket.tcp('127.0.0.1', boresight.http_port, connect_timeout: Boresight::TIMEOUT_SECONDS)
      end
      assert(waiting.all? { |socket| socket.remote_address.ip_port == boresight.http_port })
      waiting.each(&:close)
    end
    assert_equal '200', boresight.post_stop.code
  end

  HALF = "GET /api/v1/status HTTP/1.1\r\nHost: "

  # They come while no worker serves them, a whole request last; a quarter of them holds every worker until its time is over.
  # A dismissed client is informed; a pause of the machine may let the time of some run out.
  def test_SWR_LOAD_008_half_requests_give_way_the_oldest_first
    half, whole = boresight.while_stopped('http') do
      [Array.new(WORKERS * 4) { send_to_console(HALF) },
       send_to_console("#{HALF}127.0.0.1:#{boresight.http_port}\r\nConnection: close\r\n\r\n")]
    end
    assert_match(/\AHTTP\S* 200 /, whole.read)
    assert_operator half.first(WORKERS * 3).count { |socket| gave_way?(socket) }, :>, WORKERS * 2
  ensure
    [*half, whole].each(&:close)
  end

  def test_SWR_LOAD_008_who_holds_back_the_body_gives_way_too
    head = "POST /api/v1/session HTTP/1.1\r\nHost: 127.0.0.1:#{boresight.http_port}\r\n" \
           "Content-Type: application/json\r\nContent-Length: 2\r\n\r\n{"
    half = boresight.while_stopped('http') { Array.new(WORKERS * 4) { send_to_console(head) } }
    assert_operator half.first(WORKERS * 3).count { |socket| gave_way?(socket) }, :>, WORKERS * 2
  ensure
    half&.each(&:close)
  end

  STOP_HEAD = "POST /api/v1/stop HTTP/1.1\r\nContent-Length: 2\r\nHost: "

  # The others come after it and are all dismissed before it asks.
  def test_SWR_LOAD_010_a_client_that_pauses_before_it_asks_is_answered
    paused = Array.new(4) { send_to_console('') }
    half = Array.new(WORKERS * 4) { send_to_console(HALF) }
    half.each { |socket| gave_way?(socket) }
    answers = paused.map do |socket|
      socket.write("#{STOP_HEAD}127.0.0.1:#{boresight.http_port}\r\n\r\n{}")
      socket.read
    end
    answers.each { |answer| assert_match(/\AHTTP\S* 200 /, answer) }
  ensure
    [*paused, *half].each(&:close)
  end

  # Many at once, also with the body apart or held back, beside whatever else comes.
  def test_SWR_LOAD_010_of_ten_thousand_stops_in_a_crowd_none_is_without_an_answer
    [boresight.http_port, boresight.stop_port].each do |port|
      stops = {}
      Crowd.around(boresight.http_port, consoles: 2, lazy: 40, comers: 16, halves: 300) do
        stops = Crowd.until_answered(port, 5_000, halves: 100, stoppers: 8)
      end
      assert_equal [true, 0, 0], [stops['answered'] >= 5_000, *stops.values_at('refused', 'dropped')], stops.to_s
      puts "SWR-LOAD-010: #{stops['answered']} stops, each answered"
    end
  end

  # More than there are places for.
  def test_SWR_LOAD_010_half_stops_give_way_the_oldest_first
    [boresight.http_port, boresight.stop_port].each do |port|
      half = Array.new(PLACES + 4) { send_to(port, 'POST /api/v1/stop') }
      assert gave_way?(half.first)
      half.last.write(" HTTP/1.1\r\nContent-Length: 0\r\nHost: 127.0.0.1:#{port}\r\n\r\n")
      assert_match(/\AHTTP\S* 200 /, half.last.read)
    ensure
      half.each(&:close)
    end
  end

  def send_to_console(bytes)
    send_to(boresight.http_port, bytes)
  end

  def send_to(port, bytes)
    TCPSocket.new('127.0.0.1', port).tap { |socket| socket.write(bytes) }
  end

  def gave_way?(socket)
    socket.read.include?('"code":"GAVE_WAY"')
  rescue Errno::ECONNRESET
    false
  end

  # Otherwise the others would show nothing.
  def test_SWR_LOAD_003_each_crowd_was_there
    CROWDS.each do |crowd, counts|
      (counts.keys & SERVED.keys).each do |kind|
        assert_operator self.class.runs[crowd].seen.dig(kind.to_s, SERVED[kind]), :>, 0, "#{crowd}: #{kind}"
      end
    end
  end
end
