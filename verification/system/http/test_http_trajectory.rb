# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: a trajectory is sent as a table of text by a page that has authority, row by row by a connection that has it,
# or read from a file at the start; it is refused with the line that is wrong, shown, run under the pedal and emptied.

require 'open3'
require 'tempfile'

require_relative '../support/igtl_client'
require_relative '../support/page_test'

class TestHttpTrajectory < Minitest::Test
  include PageTest
  extend PageTest::Homed

  PATH = '/api/v1/trajectory'
  # From where homing leaves the yaw by 20 degrees and back.
  TABLE = "time s,yaw deg\n0,0\n1.5,-10\n3,-20\n6,0\n"

  def teardown
    boresight.simctl('pedal', 'release')
    super
  end

  # In MANUAL.
  def holder(name = 'anna')
    super.tap { |one| assert_answer '200', 'done', one.act('workphase', { workphase: 'MANUAL' }) }
  end

  def put(client, table, type = 'text/csv')
    client.request('post', PATH, table, 'Content-Type' => type, 'X-Boresight-Page' => client.page.to_s)
  end

  def held
    fetch_json(PATH)
  end

  def assert_refused(http, code, line, response)
    reported = JSON.parse(response.body)
    assert_equal [http, code, line], [response.code, reported['code'], reported['pointer']], response.body
    assert_described PATH, 'POST', response
  end

  def test_SWR_TRAJ_015_a_table_is_held_run_and_emptied
    anna = holder
    reported = JSON.parse(assert_described(PATH, 'POST', put(anna, TABLE)).body)
    assert_equal [4, 'HTTP'], reported.values_at('rows', 'source')
    assert_equal reported, held
    assert_answer '409', 'TRAJECTORY_SUM', anna.act('trajectory/run', { checksum: reported['checksum'] ^ 1 })
    assert_answer '202', 'accepted', anna.act('trajectory/run', { checksum: reported['checksum'] })
    boresight.simctl('pedal', 'press')
    wait_until('it is done') do
      anna.keep && JSON.parse(anna.act('trajectory/run', { checksum: reported['checksum'] }, id: anna.id).body)['state'] == 'done'
    end
    assert_equal [4, 3, 6.0], held.values_at('rows', 'row', 'time_s')
    emptied = anna.request('delete', PATH, nil, 'X-Boresight-Page' => anna.page.to_s)
    assert_equal [0, nil], JSON.parse(assert_described(PATH, 'DELETE', emptied).body).values_at('rows', 'source')
  end

  def test_SWR_TRAJ_015_what_is_refused_is_named_with_its_line_and_nothing_is_held
    anna = holder
    put(anna, TABLE)
    assert_refused '409', 'AXIS_LIMIT', 'line 3', put(anna, "time s,yaw deg\n0,-80\n9,-89\n")
    assert_equal 0, held['rows']
    assert_refused '409', 'TRAJECTORY_ORDER', 'line 4', put(anna, "time s,yaw deg\n0,0\n1,-1\n1,-2\n")
    assert_refused '409', 'TRAJECTORY_SPEED', 'line 3', put(anna, "time s,yaw deg\n0,0\n0.1,-20\n")
    assert_refused '400', 'BAD_BODY', 'line 1', put(anna, "time s,nose deg\n0,0\n")
    assert_refused '400', 'BAD_BODY', 'line 3', put(anna, "time s,yaw deg\n0,0\n1,x\n")
    assert_answer '409', 'TRAJECTORY_EMPTY', anna.act('trajectory/run', { checksum: 1 })
  end

  # They come while no worker serves them, and more of them than there are workers.
  HALVES = 256

  def half_table(client)
    TCPSocket.new('127.0.0.1', port).tap do |socket|
      socket.write("POST #{PATH} HTTP/1.1\r\nHost: #{host}\r\nCookie: #{client.cookie}\r\n" \
                   "#{SessionClient::TOKEN}: #{client.token}\r\n#{SessionClient::PAGE}: #{client.page}\r\n" \
                   "Content-Type: text/csv\r\nContent-Length: 3000\r\n\r\ntime s,")
    end
  end

  def gave_way?(socket)
    socket.read.include?('"code":"GAVE_WAY"')
  rescue Errno::ECONNRESET
    false
  end

  def test_SWR_LOAD_008_who_holds_back_a_table_gives_way_too
    anna = holder.tap(&:keep)
    half = boresight.while_stopped('http') { Array.new(HALVES) { half_table(anna) } }
    assert_operator half.first(HALVES * 3 / 4).count { |socket| gave_way?(socket) }, :>, HALVES / 2
  ensure
    half&.each(&:close)
  end

  def test_SWR_TRAJ_015_only_who_commands_sends_one_and_as_what_it_is
    anna = holder
    assert_equal '415', put(anna, TABLE, 'application/json').code
    assert_equal '413', put(anna, 'x' * 786_433).code
    anna.give_up
    assert_equal '423', put(anna, TABLE).code
  end

  ROWS = 4096

  # To and fro by a degree in 2 s.
  def long_table(rows)
    "time ms,yaw deg\n" + Array.new(rows) { |row| "#{row * 10},#{(Math.cos(row * Math::PI / 100) / 2) - 0.5}\n" }.join
  end

  # A recording that is begun while a long list is held and run is replayed.
  def test_SWR_TRAJ_021_the_longest_list_is_held_run_and_replayed
    anna = holder
    assert_refused '400', 'BAD_BODY', "line #{ROWS + 2}", put(anna, long_table(ROWS + 1))
    reported = JSON.parse(put(anna, long_table(ROWS)).body)
    assert_equal ROWS, reported['rows'], reported
    files = boresight.recording_files.size
    boresight.kill('recorder', 'KILL')
    wait_until('there is another recording') { boresight.recording_files.size > files }
    assert_answer '202', 'accepted', anna.act('trajectory/run', { checksum: reported['checksum'] })
    boresight.simctl('pedal', 'press')
    wait_until('it is on its way') { anna.keep && held['time_s'] > 1 }
    boresight.simctl('pedal', 'release')
    text, = Open3.capture2e(Boresight.program('boresight-replay'), boresight.recording_files.last)
    assert_match(/^\d{3,} of .* cycles replayed, their outputs equal/, text)
  end

  def axes
    fetch_json('/api/v1/motors')['axes']
  end

  # The yaw goes there and back, each other axis stays.
  def rows(ticks)
    [0, ticks, 0].map { |way| axes.map { |axis| axis['name'] == 'yaw' ? way : axis['position_ticks'] } }
  end

  def test_SWR_TRAJ_019_a_connection_that_commands_sends_one_row_by_row_and_runs_it
    IgtlClient.open(boresight.brp_port) do |client|
      client.run('phase MANUAL')
      client.run('wait STATUS MANUAL')
      lines = rows(-10).each_with_index.map { |row, index| "ROW #{index} #{index * 500} ms #{row.join(' ')} ticks #{([0] * row.size).join(' ')} ticks/s" }
      ['BEGIN 3', *lines, 'END'].each do |line|
        client.run("string Text TRAJECTORY #{line}")
        client.run('expect STATUS TRAJECTORY 1')
      end
      assert_equal [3, 'IGTL'], held.values_at('rows', 'source')
      client.run('string Text TRAJECTORY RUN')
      client.run('expect STATUS ACK_TRAJECTORY 1')
      boresight.simctl('pedal', 'press')
      assert_equal 1, client.status('TRAJECTORY')['code']
    end
  end

  # In MANUAL; longer than a message of any other type may be.
  def test_SWR_TRAJ_022_a_connection_that_commands_sends_one_as_an_array_and_runs_it
    IgtlClient.open(boresight.brp_port) do |client|
      client.run('phase MANUAL')
      client.run('wait STATUS MANUAL')
      client.run("array TRAJECTORY 64 #{(axes.size * 2) + 1} #{array(rows(-10) + (rows(0) * 13)).join(' ')}")
      client.run('expect STATUS TRAJECTORY 1')
      assert_equal [42, 'IGTL'], held.values_at('rows', 'source')
      client.run('string Text TRAJECTORY RUN')
      client.run('expect STATUS ACK_TRAJECTORY 1')
      boresight.simctl('pedal', 'press')
      assert_equal 1, client.status('TRAJECTORY')['code']
      refuse_arrays(client)
    end
  end

  # Numbers row by row, at rest in each; time enough for the first way there and back.
  def array(rows)
    rows.each_with_index.flat_map { |row, index| [([index, 2].min * 480) + (index * 20), *row, *([0] * row.size)] }
  end

  # No part of a refused list is held.
  def refuse_arrays(client)
    columns = (axes.size * 2) + 1
    still = array(rows(0))
    { "32 #{columns} #{still.join(' ')} 200#{' 0' * (columns - 1)}" => 'TRAJECTORY_ORDER: .* Row 3\.',
      "64 #{columns} #{still.first(columns).join(' ')} 100 0.5#{' 0' * (columns - 2)}" => 'OUT_OF_RANGE: ',
      "64 #{columns} 0 nan#{' 0' * (columns - 2)}" => 'NOT_FINITE: ', '64 3 0 0 0' => 'OUT_OF_RANGE: ' }.each do |words, reported|
      client.run("array TRAJECTORY #{words}")
      assert_match(/\A#{reported}/, client.status('TRAJECTORY')['text'])
    end
    assert_equal 0, held['rows']
  end

  def file(ticks)
    Tempfile.create('trajectory').tap do |file|
      file.puts "time s,#{axes.map { |axis| "#{axis['name']} ticks" }.join(',')}"
      rows(ticks).each_with_index { |row, index| file.puts [index, *row].join(',') }
      file.close
    end
  end

  def test_SWR_TRAJ_020_a_file_that_is_named_at_the_start_is_held_and_reported
    instance = Boresight.start(arguments: ['--trajectory', file(-5).path])
    reported = JSON.parse(Net::HTTP.get(URI("http://127.0.0.1:#{instance.http_port}#{PATH}")))
    assert_equal [3, 'FILE'], reported.values_at('rows', 'source')
    assert(instance.log.any? { |event| event['name'] == 'TRAJECTORY_HELD' })
  ensure
    instance&.kill_all
  end

  def test_SWR_TRAJ_020_a_file_that_is_wrong_is_refused_with_its_line
    instance = Boresight.new(arguments: ['--trajectory', file(100_000).path])
    instance.launch
    refute_equal 0, instance.wait_for_end
    assert_match(/line 3, yaw: AXIS_LIMIT: /, instance.output)
  end
end
