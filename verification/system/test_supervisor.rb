# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Rule under test: one command starts everything or says in one sentence why not; one key stops everything in order.

require 'io/console'
require 'pty'
require_relative 'support/system_test'

class TestSupervisor < SystemTest
  # Those that the supervisor ends when they hang.
  REPLACED = %w[http igtl recorder].freeze

  def started_at(pid)
    stat = File.read("/proc/#{pid}/stat")
    stat[(stat.rindex(')') + 2)..].split[19].to_i
  end

  def test_SWR_SUP_001_starts_the_five_programs_in_order
    pids = boresight.pids
    assert_equal Boresight::NAMES.sort, pids.keys.sort
    times = Boresight::NAMES.map { |name| started_at(pids[name]) }
    assert_equal times.sort, times
  end

  # A folder of programs, each of which notes its end.
  def with_noting_programs
    Dir.mktmpdir do |directory|
      FileUtils.cp(Boresight.program('boresight'), directory)
      notes = File.join(directory, 'notes')
      Boresight::NAMES.each do |name|
        file = File.join(directory, "boresight-#{name}")
        File.write(file, <<~SCRIPT, perm: 0o755)
          #!/bin/sh
          trap 'kill $program' TERM
          '#{Boresight.program("boresight-#{name}")}' "$@" & program=$!
          wait $program; wait $program
          echo #{name} >>'#{notes}'
        SCRIPT
      end
      yield directory, notes
    end
  end

  # Where the machine holds one for longer than it may take, it is killed and notes nothing: it is tried again.
  def stop_noting(directory, notes)
    Array.new(Boresight::TRIES).each do
      FileUtils.rm_f(notes)
      assert_equal 0, Boresight.start(programs: directory).stop
      break if File.readlines(notes).size == Boresight::NAMES.size
    end
    File.readlines(notes, chomp: true)
  end

  def test_SWR_SUP_001_they_end_in_order
    with_noting_programs do |directory, notes|
      clients, rest = stop_noting(directory, notes).partition.with_index { |_, index| index < 2 }
      assert_equal [%w[http igtl], %w[control recorder box]], [clients.sort, rest]
    end
  end

  def test_SWR_SUP_001_ctrl_c_stops_all_and_leaves_nothing
    instance = boresight.instance
    assert_equal 0, boresight.stop('INT')
    assert_nothing_left(instance)
  end

  def test_SWR_SUP_001_stopping_while_an_axis_moves_ends_the_recording_with_its_trailer
    boresight.press_and_command('START_UP')
    Process.kill('TERM', boresight.pid)
    assert_equal 0, boresight.wait_for_end
    text, code = replay(boresight.recording_files.last)
    assert_equal 0, code, text
    refute_includes text, 'Cut short'
  end

  def test_SWR_SUP_001_the_slowest_motion_starts_and_ends_in_order
    boresight(arguments: %w[--slow 100])
    wait_until('some cycles have run') { boresight.status['cycle'] > 20 }
    Process.kill('TERM', boresight.pid)
    assert_equal 0, boresight.wait_for_end
    text, code = replay(boresight.recording_files.last)
    assert_equal 0, code, text
  end

  def test_SWR_SUP_001_the_programs_end_when_the_supervisor_is_killed
    instance = boresight.instance
    Process.kill('KILL', boresight.pid)
    wait_until('all programs have ended') { processes_of(instance).empty? }
  end

  def test_SWR_SUP_001_the_same_name_can_be_started_again_after_a_kill
    Process.kill('KILL', boresight.pid)
    wait_until('all programs have ended') { processes_of(boresight.instance).empty? }
    second = Boresight.new(arguments: ['--instance', boresight.instance])
    second.start
    assert_equal 'UNDEFINED', second.status['workphase']['name']
  end

  def test_SWR_SUP_001_when_control_dies_everything_stops_and_the_operator_decides
    boresight.kill('control', 'KILL')
    assert_equal 4, boresight.wait_for_end
    assert_match(/^control ended \(signal 9 \(Killed\)\)/, boresight.output)
    assert_nothing_left(boresight.instance)
  end

  def test_SWR_CTRL_005_control_informs_the_cards_and_says_so_whatever_ends_it
    { 'USR1' => 'asked to end by signal 10', 'HUP' => 'asked to end by signal 1',
      'SEGV' => 'crashed by signal 11, report this' }.each do |signal, why|
      one = Boresight.start
      one.kill('control', signal)
      assert_equal 4, one.wait_for_end
      assert_includes one.output, "control: #{why}; all 7 cards confirm that their drive is off."
    end
  end

  def test_SWR_SUP_006_when_a_program_of_the_board_dies_everything_stops
    boresight.kill('box', 'KILL')
    assert_equal 4, boresight.wait_for_end
    assert_match(/^box ended/, boresight.output)
  end

  def assert_starts_again(name)
    before = boresight.pid_of(name)
    boresight.kill(name, 'KILL')
    wait_until("#{name} runs again") { boresight.pid_of(name)&.!=(before) }
    refute_empty boresight.output.lines.grep(/#{name} ended \(signal 9 \(Killed\)\)/)
    boresight.patiently { boresight.status }
  end

  def test_SWR_SUP_002_igtl_is_started_again
    assert_starts_again('igtl')
  end

  def test_SWR_SUP_002_http_is_started_again
    assert_starts_again('http')
  end

  def test_SWR_SUP_002_the_recorder_is_started_again_into_a_new_file
    assert_starts_again('recorder')
    wait_until('there is a second recording') { boresight.recording_files.size > 1 }
  end

  def test_SWR_SUP_002_a_program_that_keeps_ending_is_started_less_often
    3.times do |i|
      wait_until('igtl runs') { boresight.pid_of('igtl') }
      boresight.kill('igtl', 'KILL')
      wait_until('the supervisor says so') { boresight.output.scan(/igtl ended/).size == i + 1 }
    end
    assert_equal %w[200 400 800], boresight.output.scan(/again in (\d+) ms/).flatten
  end

  # Only the supervisor ends it: it is held, and lives.
  def test_SWR_LIFE_001_a_process_that_hangs_is_replaced_and_the_log_reports_it_once
    before = boresight.pids
    REPLACED.each { |name| boresight.kill(name, 'STOP') }
    wait_until('all are replaced') { REPLACED.all? { |name| boresight.pid_of(name)&.!=(before[name]) } }
    assert_equal before['control'], boresight.pid_of('control')
    REPLACED.each { |name| assert_equal 1, boresight.output.scan(/^#{name} has given no sign of life for 10 s/).size }
    boresight.patiently { boresight.status }
    assert_equal '200', boresight.post_stop(boresight.stop_port).code
    wait_until('the log names them') { replacements.size == REPLACED.size }
    assert_equal(REPLACED, replacements.map { |text| text[/(\w+): gave no sign of life/, 1] }.sort)
  end

  # A note that a STOP has refused is sent again, with the same number.
  def replacements
    boresight.log.select { |event| event['name'] == 'NOTE' }.uniq { |event| event['value'] }
             .map { |event| event['text'] }.grep(/gave no sign of life/)
  end

  # Ends with `code`, one sentence that matches, and nothing left.
  def assert_refuses(instance, code, sentence)
    instance.launch
    assert_equal code, instance.wait_for_end, instance.output
    assert_match sentence, instance.output
    assert_equal 1, instance.output.lines.size, instance.output
    assert_empty processes_of(instance.instance)
  end

  def test_SWR_SUP_003_a_port_in_use_is_named_with_what_to_do
    { http_port: /HTTP_PORT/, brp_port: /BRP_PORT/, igtl_port: /IGTL_PORT/ }.each do |port, remedy|
      instance = Boresight.new
      server = TCPServer.new('127.0.0.1', instance.public_send(port))
      assert_refuses(instance, 3, /Port #{instance.public_send(port)} for .* is in use; .*#{remedy}/)
      server.close
      instance.kill_all
    end
  end

  def test_SWR_SUP_003_a_missing_program_is_named_with_what_to_do
    Dir.mktmpdir do |directory|
      %w[boresight boresight-box boresight-control].each { |name| FileUtils.cp(Boresight.program(name), directory) }
      assert_refuses(Boresight.new(programs: directory), 3, /boresight-recorder is missing .*; build it with make/)
    end
  end

  def test_SWR_SUP_003_recordings_that_cannot_be_written_are_named_with_what_to_do
    assert_refuses(Boresight.new(arguments: ['--recordings', '/dev/null/recordings']), 3,
                   %r{Nothing can be recorded in /dev/null/recordings .*--recordings})
  end

  def test_SWR_SUP_003_a_second_one_of_the_same_name_is_refused_and_the_first_goes_on
    second = Boresight.new(arguments: ['--instance', boresight.instance])
    second.launch
    assert_equal 3, second.wait_for_end
    assert_match(/already runs .*--instance/, second.output)
    assert boresight.status
  end

  def test_SWR_SUP_003_wrong_options_are_named
    { %w[--robot prostatic] => /no robot "prostatic"/, %w[--http-port 0] => /"0" is no number for --http-port; give one from 1 to 65535/,
      %w[--bind nowhere] => /"nowhere" is no IPv4 address/, %w[--colour red] => /"--colour" is no option/,
      %w[--instance a/b] => %r{"a/b" names no instance} }.each do |words, sentence|
      assert_refuses(Boresight.new(arguments: words), 2, sentence)
    end
  end

  def test_SWR_SUP_007_wrong_options_of_the_board_are_named
    { %w[--slow 0] => /"0" is no number for --slow; give one from 1 to 100/, %w[--slow 101] => /"101" is no number for --slow/,
      %w[--fast 101] => /"101" is no number for --fast; give one from 1 to 100/, %w[--box b --fast 2] => /--fast is of no use with --box/,
      %w[--slow] => /--slow lacks its value, NUMBER/, %w[--box a/b] => %r{"a/b" is no name for --box},
      %w[--box b --slow 2] => /--slow is of no use with --box/ }.each do |words, sentence|
      assert_refuses(Boresight.new(arguments: words), 2, sentence)
    end
  end

  def test_SWR_SUP_007_the_usage_names_the_options_of_the_board
    text, status = Open3.capture2e(Boresight.program('boresight'), '--help')
    assert status.success?
    assert_match(/^  --box NAME .*\n  --slow NUMBER .*\n  --fast NUMBER .*\n  --tissue TEXT .*\n(?: {20,}.*\n)*  --real-time /, text)
  end

  def test_SWR_ROBOT_016_an_unknown_robot_is_refused_with_the_names_of_those_there_are
    folders = Dir.glob(File.expand_path('../../core/robot/*/robot.yml', __dir__)).sort.map { |path| File.dirname(path) }
    names = folders.map { |folder| File.basename(folder) }
    list = [names[..-2].join(', '), names.last].reject(&:empty?).join(' or ')
    assert_refuses(Boresight.new(arguments: %w[--robot scara]), 2,
                   /no robot "scara"; choose #{list} with --robot or ROBOT/)
    { 'boresight-box' => %w[--robot scara],
      'boresight-control' => %w[--robot scara --instance x --box x --positions x] }.each do |program, words|
      text, status = Open3.capture2e(Boresight.program(program), *words)
      assert_equal 2, status.exitstatus
      assert_match(/There is no robot "scara"; choose #{list} with --robot/, text)
    end
  end

  def test_SWR_SUP_003_an_address_of_another_machine_is_named
    assert_refuses(Boresight.new(arguments: %w[--bind 203.0.113.1]), 3, /203.0.113.1 is no address of this machine/)
  end

  def test_SWR_SUP_004_without_a_terminal_the_status_is_a_line_that_names_each_program
    line = wait_until('the status is printed') { boresight.output.lines.grep(/links 7/).last }
    assert_match(/\| #{Boresight::NAMES.join(' ')} ok$/, line)
    ['UNDEFINED', 'pedal released', 'e-stop', 'no motion:'].each { |part| assert_includes line, part }
  end

  # In elastic time control waits for the box; in real time the cards and inputs of one that is held are as behind a cut cable.
  def test_SWR_EVENT_032_a_box_that_is_not_heard_is_not_said_to_be_pulled_or_acquiring
    instance = Boresight.start(arguments: %w[--real-time])
    instance.command('START_UP')
    first = instance.log.last['number'] + 1
    instance.while_stopped('box') do
      wait_until('the inputs are not read') { instance.status['unread_inputs'].any? }
      assert_nothing_pulled(instance, first)
    end
    wait_until('they are read again') { instance.log(first).any? { |event| event['name'] == 'INPUTS_READ' } }
    assert_empty instance.status['unread_inputs']
    assert_empty(%w[ESTOP_PULLED ESTOP_RELEASED SCANNER] & instance.log(first).map { |event| event['name'] })
  ensure
    instance&.kill_all
  end

  # The shown state, and the log from `first` on.
  def assert_nothing_pulled(instance, first)
    status = instance.status
    assert_equal(%w[PEDAL ESTOP SCANNER GATE], status['unread_inputs'].map { |input| input['name'] })
    assert_equal 'CHECK_BOX', status.dig('next_step', 'name')
    refute status['is_scanner_active']
    assert_equal 'INPUTS_UNREAD', status['alarms'].first['event']
    wait_until('the line says it') { instance.output.match?(/no motion: inputs unread \| pedal NOT READ \| e-stop NOT READ/) }
    sentences = [*instance.log(first), *status['alarms'], status['next_step'], *status_reasons(instance)].map { |one| one['text'] }
    assert_empty sentences.grep(/e-stop (is|was) pulled|Release the e-stop|scanner (is|started)|By the (e-stop|scanner|pedal)/)
  end

  def status_reasons(instance)
    instance.motors['axes'].flat_map { |axis| axis.dig('permit', 'reasons') }
  end

  def test_SWR_SUP_005_the_status_says_how_fast_time_passes
    { [] => /\belastic time \d+ %/, %w[--real-time --slow 2] => /\breal time \d+ %, loop p99 \d+ us/ }.each do |words, text|
      instance = Boresight.start(arguments: words)
      wait_until('the status is printed') { instance.output.match?(text) }
      instance.kill_all
    end
  end

  def read_all(terminal)
    terminal.read_nonblock(65_536)
  rescue IO::WaitReadable, Errno::EIO
    ''
  end

  # On a terminal of 80 columns; the block gets a way to wait for what is shown, and the name. Returns all that was shown.
  def on_a_terminal(environment)
    ports = Boresight.free_ports(3).map(&:to_s)
    name = Boresight.next_instance
    seen = +''
    Dir.mktmpdir do |directory|
      terminal, keys, pid = PTY.spawn({ 'TERM' => 'xterm', 'NO_COLOR' => nil }.merge(environment),
                                      Boresight.program('boresight'), '--instance', name, '--recordings', directory,
                                      '--http-port', ports[0], '--igtl-port', ports[1], '--brp-port', ports[2])
      shows = ->(text) { wait_until("#{text.inspect} is shown") { (seen << read_all(terminal)).match?(text) } }
      shows.call(/pedal released/)
      yield shows, name
      keys.write("\x03")
      shows.call(/Boresight has stopped\./)
      Process.wait(pid)
    end
    assert_nothing_left(name)
    seen
  end

  def test_SWR_SUP_004_on_a_terminal_the_line_is_rewritten_when_something_changes_and_ctrl_c_stops
    seen = on_a_terminal({}) do |shows, name|
      Open3.capture2e(Boresight.program('boresight-simctl'), '--instance', name, 'pedal', 'press')
      shows.call(/\r[^\n]*pedal pressed/)
    end
    assert_includes seen, "\e[33me-stop latched\e[0m"
  end

  def test_SWR_SUP_011_the_line_stays_in_its_row_and_without_colours_if_none_are_wanted
    seen = on_a_terminal('NO_COLOR' => '1') { |shows, _name| shows.call(/e-stop latched \.\.\./) }
    rows = seen.scan(/\r([^\r\n]*)\e\[K/).flatten.grep(/e-stop/)
    assert_empty rows.select { |row| row.size > 79 }
    refute_match(/\e\[[0-9;]*m/, seen)
  end
end
