# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the log and the recordings come over HTTP as they are, what is asked of them is found, no name leads to
# another file, and reading them keeps no client from working and nothing from stopping.

require 'csv'
require 'time'
require_relative '../support/page_test'

class TestHttpArchive < Minitest::Test
  include PageTest

  MEMORY = 1024 # events
  CORRUPT_SLOT = 5
  BIG = 'events-900000-20260921T141320Z.log'
  BIG_BYTES = 8_000_000
  DOWNLOADS = 2 # downloads

  # There are more events than memory has.
  module WithEvents
    def boresight
      @boresight ||= super.tap { |one| happen(one) }
    end

    # A damaged frame is an event.
    def happen(one)
      one.simctl('card', CORRUPT_SLOT.to_s, 'corrupt')
      one.wait_until('memory is too small') { get_log(one)['next'] > 2 * MEMORY }
      one.simctl('card', CORRUPT_SLOT.to_s, 'normal')
      one.wait_until('nothing more happens') { get_log(one)['next'] == get_log(one)['next'] && settled?(one) }
    end

    def get_log(one)
      JSON.parse(Net::HTTP.get(URI("http://127.0.0.1:#{one.http_port}/api/v1/log?limit=1")))
    end

    # All events stand in the file.
    def settled?(one)
      one.event_lines.last.to_s.split[1].to_i + 1 == get_log(one)['next']
    end
  end
  extend WithEvents

  def log(query = '')
    fetch_json("/api/v1/log#{query}")
  end

  def numbers(query)
    log(query)['entries'].map { |entry| entry['number'] }
  end

  def assert_get_described(path)
    assert_described path.split('?').first, 'GET', get(path)
  end

  def recordings
    fetch_json('/api/v1/recordings')['recordings']
  end

  # A line of the log's file as the event that HTTP reports; the subject's words stand in no line.
  def event_of(line)
    words = line.split(' ', 10)
    keyed = words[2..].grep(/=/).to_h { |word| word.split('=', 2) }
    { 'utc' => words[0], 'number' => words[1].to_i, 'cycle' => keyed['cycle'].to_i, 'severity' => words[3],
      'name' => words[4], 'value' => keyed['value'].to_i, 'cause' => keyed['cause'], 'peer' => keyed['peer'].to_i,
      'text' => words[9] }
  end

  def test_SWR_HTTP_041_without_a_question_the_newest_200_are_reported
    answer = log
    assert_equal 200, answer['entries'].size
    assert_equal answer['next'] - 1, answer['entries'].last['number']
    assert_equal 3, log('?limit=3')['entries'].size
    assert_get_described '/api/v1/log?limit=3'
  end

  def test_SWR_HTTP_041_what_memory_has_no_more_comes_from_the_log_with_the_same_words
    answer = log('?after=0')
    assert_equal (1..200).to_a, answer['entries'].map { |entry| entry['number'] }
    assert_equal [201, 0], answer.values_at('next', 'lost')
    lines = boresight.event_lines.drop(1).first(200).map { |line| event_of(line) }
    assert_equal lines, answer['entries'].map { |entry| entry.except('subject') }
    assert(answer['entries'].any? { |entry| entry['subject'].include?('(yaw)') })
  end

  def test_SWR_HTTP_041_page_by_page_all_of_them_come_once
    last = log['next'] - 1
    found = [0]
    found.concat(numbers("?after=#{found.last}&limit=199")) while found.last < last
    assert_equal (0..found.last).to_a, found
  end

  def test_SWR_HTTP_041_all_parameters_must_fit
    lost = log('?text=card_lost')['entries']
    assert_equal(['CARD_LOST'], lost.map { |entry| entry['name'] })
    assert_equal lost, log('?level=CRITICAL&text=CARD%205')['entries']
    assert_empty log('?level=CRITICAL&text=no%20such%20thing')['entries']
    severities = log('?level=WARNING')['entries'].map { |entry| entry['severity'] }.uniq
    refute_includes severities, 'INFORMATION'
  end

  def test_SWR_HTTP_041_times_are_utc_and_inclusive
    first = log('?after=0&limit=1')['entries'].first
    same = log("?from=#{first['utc']}&to=#{Time.parse(first['utc']).utc.iso8601(6)}")['entries']
    assert_includes same, first
    assert_equal [first['utc'][0, 23]], same.map { |entry| entry['utc'][0, 23] }.uniq
    assert_empty log('?from=2100-01-01T00:00:00Z')['entries']
    assert_empty log('?to=1999-12-31T23:59:59.5Z')['entries']
  end

  def test_SWR_HTTP_041_the_time_of_an_event_is_that_of_the_machine
    assert_in_delta Time.now.to_f, Time.parse(log('?limit=1')['entries'].last['utc']).to_f, Boresight::TIMEOUT_SECONDS
  end

  def test_SWR_HTTP_041_what_cannot_be_read_is_refused_by_its_name
    { 'limit=0' => 'limit', 'limit=201' => 'limit', 'level=BAD' => 'level', 'from=now' => 'from', 'to=2026-02-30T00:00:00Z' => 'to',
      'from=2026-01-01T00:00:00%2B01:00' => 'from', "text=#{'a' * 65}" => 'text', 'text=%00' => 'text',
      'cycle=1' => 'cycle' }.each do |query, parameter|
      response = get("/api/v1/log?#{query}")
      assert_equal %W[400 BAD_QUERY #{parameter}], [response.code, *JSON.parse(response.body).values_at('code', 'parameter')]
      assert_equal '400', get("/api/v1/log.csv?#{query}").code unless query == 'limit=201'
    end
  end

  def test_SWR_HTTP_042_the_table_says_what_the_log_says
    response = get('/api/v1/log.csv?after=0&limit=200')
    assert_equal 'text/csv', response['Content-Type'].split(';').first
    assert_equal 'attachment; filename="events.csv"', response['Content-Disposition']
    rows = CSV.parse(response.body, headers: true).map(&:to_h)
    reported = log('?after=0')['entries'].map { |entry| entry.transform_values(&:to_s) }
    assert_equal(reported, rows.map { |row| row.transform_values(&:to_s) })
    assert_equal 200, get('/api/v1/log.csv?limit=10000').code.to_i
    assert_operator CSV.parse(get('/api/v1/log.csv').body, headers: true).size, :>, 2 * MEMORY
  end

  def test_SWR_HTTP_043_a_log_comes_as_it_is
    assert_get_described '/api/v1/logs'
    present = fetch_json('/api/v1/logs')['logs'].find { |one| one['is_present'] }
    path = boresight.log_files.find { |file| File.basename(file) == present['name'] }
    response = get("/api/v1/logs/#{present['name']}")
    assert_equal File.binread(path, response.body.bytesize), response.body
    lines = response.body.byteslice(0, present['bytes']).lines # Bytes of the list; there may be more by now.
    assert lines.last.end_with?("\n")
    assert_equal [lines.first.split.first, lines.last.split.first], present.values_at('first', 'last')
    assert_match(/\Aevents-\d{6}-\d{8}T\d{6}Z\.log\z/, present['name'])
  end

  def test_SWR_HTTP_044_the_present_recording_is_replayed_up_to_what_is_finished
    assert_get_described '/api/v1/recordings'
    wait_until('a second is recorded') { recordings.first['bytes'] > 10_000 }
    present = recordings.find { |one| one['is_present'] }
    assert_equal 'neuro', present['robot']
    bytes = get("/api/v1/recordings/#{present['name']}").body
    assert_operator bytes.bytesize, :>=, present['bytes']
    text, exit_code = replay_bytes(bytes)
    assert_equal 3, exit_code, text
    assert_match(/^\d+ of at least \d+ cycles replayed, their outputs equal/, text)
    assert File.binread(File.join(boresight.recordings, present['name'])).start_with?(bytes)
  end

  def test_SWR_HTTP_044_a_finished_recording_is_replayed_bit_by_bit
    boresight.kill('recorder', 'TERM')
    wait_until('another one is begun') { recordings.size > 1 && recordings.first['is_present'] }
    finished = recordings.last
    refute finished['is_present']
    bytes = get("/api/v1/recordings/#{finished['name']}").body
    assert_equal File.binread(File.join(boresight.recordings, finished['name'])), bytes
    text, exit_code = replay_bytes(bytes)
    assert_equal 0, exit_code, text
    assert_match(/^\d+ of at least \d+ cycles replayed, their outputs equal/, text)
  end

  def replay_bytes(bytes)
    Dir.mktmpdir do |folder|
      path = File.join(folder, 'downloaded.bsr')
      File.binwrite(path, bytes)
      text, status = Open3.capture2e(Boresight.program('boresight-replay'), path)
      [text, status.exitstatus]
    end
  end

  # A log that is there and belongs to no run.
  def with_big_log
    path = File.join(boresight.recordings, BIG)
    File.open(path, 'w') { |file| file.write('x' * BIG_BYTES) }
    yield
  ensure
    FileUtils.rm_f(path)
  end

  # One that asks for the big log and reads none of it.
  def lazy_download
    lazy = Socket.new(:INET, :STREAM)
    lazy.setsockopt(:SOCKET, :RCVBUF, 4096)
    lazy.connect(Addrinfo.tcp('127.0.0.1', port))
    lazy.write("GET /api/v1/logs/#{BIG} HTTP/1.1\r\nHost: #{host}\r\n\r\n")
    assert lazy.gets.start_with?('HTTP/1.1 200')
    lazy
  end

  def test_SWR_HTTP_045_readers_that_do_not_read_keep_two_places_and_nothing_else
    with_big_log do
      lazy = Array.new(DOWNLOADS) { lazy_download }
      refused = get("/api/v1/logs/#{BIG}")
      assert_equal %w[503 ARCHIVE_BUSY], [refused.code, code(refused)]
      assert_equal '200', boresight.post_stop.code
      assert_equal '200', get('/api/v1/recordings').code
      wait_until('the recorder is there') { boresight.status['processes']['recorder'] }
    ensure
      lazy&.each(&:close)
    end
  end

  def test_SWR_HTTP_046_who_does_not_read_is_cut_off_and_gives_its_place_to_others
    with_big_log do
      lazy = Array.new(DOWNLOADS) { lazy_download }
      wait_until('both are cut off') { lazy.all? { |one| dropped?(one) } }
      wait_until('the place is free') { get("/api/v1/logs/#{BIG}").body.bytesize == BIG_BYTES }
    ensure
      lazy&.each(&:close)
    end
  end

  def test_SWR_HTTP_045_a_flood_of_lists_is_answered_or_refused_by_name
    answers = Array.new(40) { Thread.new { get('/api/v1/recordings') } }.map(&:value)
    assert_empty answers.map(&:code).uniq - %w[200 503]
    assert_includes answers.map(&:code), '200'
    assert_empty answers.select { |one| one.code == '503' }.map { |one| code(one) }.uniq - ['ARCHIVE_BUSY']
    assert_equal '200', get('/api/v1/recordings').code
  end

  # Good names for what is no file of its own.
  def with_traps
    names = Array.new(4) { |i| "events-80000#{i}-20260921T141320Z.log" }
    paths = names.map { |name| File.join(boresight.recordings, name) }
    File.symlink('/etc/passwd', paths[0])
    File.symlink(boresight.log_files.first, paths[1])
    File.mkfifo(paths[2])
    Dir.mkdir(paths[3])
    yield names
  ensure
    paths&.each { |path| FileUtils.rm_rf(path) }
  end

  def test_SWR_HTTP_047_links_pipes_and_folders_are_not_there
    with_traps do |names|
      names.each { |name| assert_equal '404', get("/api/v1/logs/#{name}").code }
      assert_empty fetch_json('/api/v1/logs')['logs'].map { |one| one['name'] } & names
    end
  end

  def test_SWR_HTTP_047_no_path_leads_out_of_the_lists
    name = File.basename(boresight.log_files.first)
    positions = Dir.children(boresight.recordings).find { |one| one.start_with?('positions-') }
    ['../../../etc/passwd', '..', '.', '', '%2e%2e', '%2e%2e%2f%2e%2e%2fetc%2fpasswd', '..%2fx', '..\\x', "#{name}%00", "#{name}%00.log",
     "#{name}/", "./#{name}", "//#{name}", "%65#{name[1..]}", name.upcase, "#{name}~", positions, '*', '~', 'C:', "a" * 65, 'a' * 5000,
     File.join(boresight.recordings, name)].each do |path|
      %w[logs recordings].each do |list|
        answer = send_raw("GET /api/v1/#{list}/#{path} HTTP/1.1\r\nHost: #{host}\r\n\r\n")
        assert_match(/\AHTTP\S+ (404|400|414|431) /, answer[0, 40], "#{list}/#{path}")
      end
    end
    assert_equal '404', get("/api/v1/recordings/#{name}").code
    assert_equal 'NOT_THERE', code(get('/api/v1/logs/events-000001.log'))
    assert_match(/\AHTTP\S+ 400 /, send_raw("GET /api/v1/logs/#{name}\0 HTTP/1.1\r\nHost: #{host}\r\n\r\n")[0, 40])
  end

  def test_SWR_HTTP_048_a_file_says_its_length_its_name_and_its_tag
    with_big_log do
      whole = get("/api/v1/logs/#{BIG}")
      assert_equal [BIG_BYTES.to_s, "attachment; filename=\"#{BIG}\"", 'nosniff', 'private, no-cache'],
                   whole.to_hash.values_at('content-length', 'content-disposition', 'x-content-type-options', 'cache-control').flatten
      head = request(Net::HTTP::Head.new("/api/v1/logs/#{BIG}"))
      assert_equal ['200', whole['ETag'], BIG_BYTES.to_s, nil], [head.code, head['ETag'], head['Content-Length'], head.body]
      known = get("/api/v1/logs/#{BIG}", 'If-None-Match' => whole['ETag'])
      assert_equal ['304', nil], [known.code, known.body]
      File.write(File.join(boresight.recordings, BIG), 'other')
      assert_equal %w[200 other], get("/api/v1/logs/#{BIG}", 'If-None-Match' => whole['ETag']).then { |one| [one.code, one.body] }
    end
  end

  def set_level(who, body)
    who.request('put', '/api/v1/log/level', JSON.generate(body))
  end

  def test_SWR_HTTP_049_an_engineer_sets_the_level_and_the_log_says_by_whom
    egon = client('egon')
    assert_equal '200', set_level(egon, { level: 'WARNING' }).code
    assert_equal ['WARNING', 'egon', nil], level_reported(egon).values_at('level', 'by', 'reason')
    said = 'LOG_LEVEL value=1 From here on events from WARNING on are written, set by egon.'
    wait_until('the log says so') { boresight.event_lines.any? { |line| line.end_with?(said) } }
    assert_equal '200', set_level(egon, { level: 'INFORMATION' }).code
    wait_until('the log says so') { boresight.event_lines.any? { |line| line.include?('LOG_LEVEL value=0') } }
  end

  def level_reported(who)
    JSON.parse(assert_described('/api/v1/log/level', 'GET', who.request('get', '/api/v1/log/level')).body)
  end

  def test_SWR_HTTP_049_it_is_reported_why_somebody_may_not_set_it
    assert_nil level_reported(client('egon'))['reason']
    assert_equal 'The role of this account does not allow it.', level_reported(client('anna'))['reason']
    assert_equal 'Log in first; there is no session, or it has ended.', level_reported(client)['reason']
  end

  def test_SWR_HTTP_049_nobody_else_sets_it
    %w[olga anna].each { |name| assert_equal %w[403 ROLE_REFUSED], set_level(client(name), { level: 'CRITICAL' }).then { |one| [one.code, code(one)] } }
    assert_equal %w[401 NO_SESSION], set_level(client, { level: 'CRITICAL' }).then { |one| [one.code, code(one)] }
    egon = client('egon')
    [{ level: 'SILENT' }, { level: 3 }, {}, { level: 'CRITICAL', more: 1 }].each do |body|
      assert_includes %w[400 422], set_level(egon, body).code
    end
    refute_equal 'CRITICAL', fetch_json('/api/v1/log/level')['level']
  end
end
