# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'fileutils'
require 'json'
require 'net/http'
require 'open3'
require 'socket'
require 'tmpdir'

# One running Boresight: its own ports, names and directory, so that several run side by side.
#
#   boresight = Boresight.start
#   boresight.command('START_UP')
#   boresight.simctl('pedal', 'press')
#   boresight.wait_until('all axes are homed') { boresight.status['is_homed'] }
#   boresight.stop
class Boresight
  PROGRAMS = ENV.fetch('BORESIGHT_BIN', File.expand_path('../../../build/bin', __dir__))
  NAMES = %w[box control recorder igtl http].freeze
  # A bound against hanging, and no judgement: far above what any wait takes on a machine that is busy with other things.
  TIMEOUT_SECONDS = 120
  POLL_SECONDS = 0.02
  # How often something is asked for in all.
  TRIES = 3

  # The awaited event did not happen.
  class TimedOut < StandardError; end

  class << self
    def start(**options)
      new(**options).tap(&:start)
    end

    def program(name)
      File.join(PROGRAMS, name)
    end

    # `count` ports that no process listens on.
    def free_ports(count)
      servers = Array.new(count) { TCPServer.new('127.0.0.1', 0) }
      servers.map { |server| server.addr[1] }
    ensure
      servers&.each(&:close)
    end

    def now
      Process.clock_gettime(Process::CLOCK_MONOTONIC)
    end

    # Polls the block until it is true, and returns what it returned.
    def wait_until(reason)
      deadline = now + TIMEOUT_SECONDS
      loop do
        result = yield
        return result if result
        raise TimedOut, "waited #{TIMEOUT_SECONDS} s in vain until #{reason}" if now > deadline

        sleep POLL_SECONDS
      end
    end

    def running
      @running ||= []
    end

    def next_instance
      @instances = (@instances || 0) + 1
      "test-#{Process.pid}-#{@instances}"
    end
  end

  attr_reader :directory, :recordings, :instance, :http_port, :igtl_port, :brp_port, :pid

  # `arguments` are added to the command line; `prefix` goes in front of it. `box` and `recordings` are somebody else's.
  def initialize(arguments: [], prefix: [], programs: PROGRAMS, box: nil, recordings: nil)
    @http_port, @igtl_port, @brp_port = Boresight.free_ports(3)
    @instance = Boresight.next_instance
    @directory = Dir.mktmpdir('boresight')
    @box = box
    @recordings = recordings || File.join(@directory, 'recordings')
    @command = [*prefix, File.join(programs, 'boresight'), '--instance', @instance,
                '--http-port', @http_port.to_s, '--igtl-port', @igtl_port.to_s,
                '--brp-port', @brp_port.to_s, '--recordings', @recordings, *arguments]
    @command.push('--box', box) if box
  end

  # Starts it and waits until the console answers.
  def start
    launch
    wait_until('the console answers') { started? }
  rescue StandardError
    warn "Boresight said:\n#{output}"
    kill_all
    raise
  end

  # Starts it without waiting.
  def launch
    @pid = Process.spawn(*@command, out: log_file, err: %i[child out], in: File::NULL)
    Boresight.running << self
    @pid
  end

  # Asks it to stop; returns its exit code.
  def stop(signal = 'TERM')
    Process.kill(signal, @pid)
    wait_for_end
  ensure
    kill_all
  end

  # Exit code once it has ended by itself.
  def wait_for_end
    wait_until('the supervisor ends') { ended? }
    @status.exitstatus
  end

  def kill_all
    children = @pid ? pids : {}
    begin
      Process.kill('KILL', @pid) unless @pid.nil? || ended?
    rescue Errno::ESRCH
      nil
    end
    children.each_value { |pid| kill_pid(pid) }
    [@process_client, @peer].compact.each(&:close)
    Boresight.running.delete(self)
    Dir.glob("/dev/shm/*#{@instance}*").each { |path| FileUtils.rm_f(path) }
    FileUtils.rm_rf(@directory)
  end

  # Everything it has printed.
  def output
    @last_output = File.read(log_file) if File.exist?(log_file)
    @last_output.to_s
  end

  # Recordings, the oldest first.
  def recording_files
    Dir.glob(File.join(recordings, 'blackbox-*.bsr')).sort
  end

  # Logs of events, the oldest first.
  def log_files
    Dir.glob(File.join(recordings, 'events-*.log')).sort
  end

  # Lines of the newest log.
  def log_lines
    log_files.last(1).flat_map { |path| File.readlines(path, chomp: true) }
  end

  # Without the counts of the cards, which are no events: a slow machine makes some.
  def event_lines
    log_lines.grep_v(/ CARD_COUNTS /)
  end

  # Number of the event that reports the last pause of the machine that ended a motion; nil: of none.
  def last_pause
    log.select { |entry| entry['name'] == 'LOOP_STOPPED' || entry['text'].include?('SILENT') }.last&.fetch('number')
  end

  def box
    @box || "#{@instance}-box"
  end

  # Gives the box an order; returns its answer.
  def simctl(*words)
    answer, status = Open3.capture2e(Boresight.program('boresight-simctl'), '--box', box, *words)
    raise "simctl #{words.join(' ')}: #{answer}" unless status.success?

    answer
  end

  def status
    get('status')
  end

  def motors
    get('motors')
  end

  def targeting
    get('targeting')
  end

  # Events from number `from` on.
  def log(from = 0)
    get(from.zero? ? 'log' : "log?after=#{from - 1}")['entries']
  end

  # As soon as http answers again, for a test that has just killed it.
  def patiently
    wait_until('http answers') do
      yield
    rescue SystemCallError, EOFError, Net::ReadTimeout, Net::OpenTimeout, RuntimeError
      nil
    end
  end

  # Asks for a stop at the console's port, or at another.
  def post_stop(port = http_port)
    http(port) { |connection| connection.post('/api/v1/stop', '', 'Content-Type' => 'application/json') }
  end

  # The port for stops, as the server gives it to the page.
  def stop_port
    Integer(http { |connection| connection.get('/') }.body[/name="boresight-stop-port" content="(\d{5})"/, 1], 10)
  end

  # The supervisor's children by name; a zombie is not one.
  def pids
    Dir.glob('/proc/[0-9]*/stat').each_with_object({}) do |path, found|
      stat = File.read(path)
      state, parent = stat[(stat.rindex(')') + 2)..].split.first(2)
      next if state == 'Z' || parent.to_i != supervisor_pid

      pid = path[/\d+/].to_i
      name = File.basename(File.binread("/proc/#{pid}/cmdline").split("\0").first.to_s)
      found[name.delete_prefix('boresight-')] = pid
    rescue SystemCallError
      next
    end
  end

  def pid_of(name)
    pids[name]
  end

  def kill(name, signal)
    Process.kill(signal, pid_of(name) || raise("#{name} does not run"))
  end

  # Another server takes the place of http.
  def restart_http
    first = status['boot_id']
    kill('http', 'KILL')
    wait_until('another server answers') { patiently { status['boot_id'] } != first }
  end

  # Rows of "simctl show": slot, axis, ..., drive and the number of watchdog trips.
  def box_axes
    rows = simctl('show').lines.map(&:split).select { |words| words.first.to_s.match?(/\A\d+\z/) }
    rows.reject { |words| words[1] == 'sensor' }
  end

  def driven_axes
    box_axes.reject { |words| words.include?('off') }
  end

  # Holds programs while the block runs. One that is held for long may be replaced meanwhile.
  def while_stopped(*names)
    held = pids.values_at(*names)
    held.each { |pid| Process.kill('STOP', pid) }
    yield
  ensure
    held&.reverse_each { |pid| let_go(pid) }
  end

  def let_go(pid)
    Process.kill('CONT', pid)
  rescue Errno::ESRCH
    nil
  end

  def wait_until(reason, &)
    Boresight.wait_until(reason, &)
  rescue TimedOut => e
    raise TimedOut, "#{e.message}; Boresight said:\n#{output}"
  end

  # Sends a workphase command as a client of the OpenIGTLink port does. The connection stays: a server may drop what
  # a client that has gone asked for.
  def command(workphase)
    @commands = (@commands || 0) + 1
    @peer ||= WorkphasePeer.new(@brp_port)
    @peer.command(format('CMD_%04d', @commands), workphase)
  end

  # The client that commands goes away; returns once its authority has gone with it.
  def leave
    @peer&.close
    @peer = nil
    wait_until('nobody has authority') { get('authority')['state'] == 'nobody' }
  end

  # Homes every axis; the pedal is pressed as long as that takes.
  def home
    despite_pauses do
      press_and_command('START_UP')
      wait_for_homing
      simctl('pedal', 'release')
      raise "homing ended early; Boresight said:\n#{output}" unless status['is_homed']
    end
  end

  # Options of a system whose homing no test looks at.
  FAST = %w[--fast 20].freeze

  # The same in fast time; what follows passes at the pace of the world.
  def home_fast
    simctl('pace', FAST.last)
    home
    simctl('pace', '1')
  end

  # A machine that keeps OpenIGTLink's process from running for 2 s costs it authority, as it shall, and one that makes cycles
  # late too often stops the motion: what the block has asked for is asked again, pedal up.
  def despite_pauses
    tries ||= 0
    before = last_pause
    yield
  rescue StandardError
    raise if last_pause == before || (tries += 1) == TRIES

    simctl('pedal', 'release')
    await_released_pedal
    retry
  end

  def wait_for_homing
    patiently { !moving? && (status['is_homed'] || status['order'] == 'none') }
  end

  # Arms `workphase`, then presses the pedal; returns once an axis is driven.
  def press_and_command(workphase)
    simctl('pedal', 'release')
    await_released_pedal
    command(workphase)
    wait_until("#{workphase} is armed") { status['order'] != 'none' }
    simctl('pedal', 'press')
    wait_until('an axis is driven') { moving? }
  end

  # Its contacts bounce: released for 50 cycles.
  def await_released_pedal
    since = nil
    wait_until('the pedal is released') do
      now = status
      since = now['pedal'] == 'released' ? (since || now['cycle']) : nil
      since && now['cycle'] >= since + 50
    end
  end

  def moving?
    motors['axes'].any? { |axis| axis['is_driven'] }
  end

  # The workphase client of the demonstration, connected to this instance.
  def client(*arguments)
    @process_client ||= ProcessClient.new(Boresight.program('boresight-client'), '--port', @brp_port.to_s, *arguments)
  end

  def ended?
    return true if @status

    reaped, status = Process.wait2(@pid, Process::WNOHANG)
    @status = status if reaped
    !@status.nil?
  end

  private

  def log_file
    File.join(@directory, 'output')
  end

  def started?
    raise "the supervisor has ended: #{output.lines.last(4).join}" if ended?

    status
    output.include?('Console:')
  rescue SystemCallError, EOFError, Net::ReadTimeout, Net::OpenTimeout, JSON::ParserError, HttpRefused
    false
  end

  # An answer other than 200.
  class HttpRefused < RuntimeError; end

  def get(name)
    response = http { |connection| connection.get("/api/v1/#{name}") }
    raise HttpRefused, "#{name}: #{response.code} #{response.body}" unless response.code == '200'

    JSON.parse(response.body)
  end

  def http(port = @http_port, &)
    Net::HTTP.start('127.0.0.1', port, open_timeout: TIMEOUT_SECONDS, read_timeout: TIMEOUT_SECONDS, &)
  end

  # With a prefix (sh -c, setpriv ...) that executes it, the process is still the same.
  def supervisor_pid
    @pid
  end

  def kill_pid(pid)
    Process.kill('KILL', pid)
  rescue Errno::ESRCH
    nil
  end
end

# Just enough of OpenIGTLink to command a workphase: a STRING message of header version 1.
class WorkphasePeer
  POLYNOMIAL = 0x42F0E1EBA9EA3693
  MASK = 0xFFFFFFFFFFFFFFFF

  def self.crc64(bytes)
    bytes.each_byte.reduce(0) do |crc, byte|
      crc ^= byte << 56
      8.times { crc = crc[63] == 1 ? ((crc << 1) ^ POLYNOMIAL) & MASK : (crc << 1) & MASK }
      crc
    end
  end

  def self.message(name, text)
    body = [3, text.bytesize, text].pack('nna*')
    [1, 'STRING', name, 0, body.bytesize, crc64(body)].pack('na12a20Q>Q>Q>') + body
  end

  def initialize(port)
    @socket = TCPSocket.new('127.0.0.1', port)
  end

  # Sends `text` as the message `name` and waits for the first answer's header.
  def command(name, text)
    @socket.write(WorkphasePeer.message(name, text))
    raise 'no answer to the command' unless @socket.wait_readable(Boresight::TIMEOUT_SECONDS)

    @socket.readpartial(4096)
  end

  def close
    @socket.close
  end
end

# A program that reads orders and answers with lines of JSON.
class ProcessClient
  def initialize(*command)
    @input, @answers, @thread = Open3.popen2(*command)
    @buffer = +''
  end

  def write(line)
    @input.puts(line)
    @input.flush
  end

  # The next line, parsed.
  def read
    line = Boresight.wait_until('the client says something') { next_line }
    JSON.parse(line)
  end

  def close
    @input.close unless @input.closed?
    Process.kill('KILL', @thread.pid) if @thread.alive?
    @thread.value
  rescue Errno::ESRCH
    nil
  end

  private

  def next_line
    return @buffer.slice!(/\A.*\n/) if @buffer.include?("\n")

    text = @answers.read_nonblock(4096, exception: false)
    @buffer << text if text.is_a?(String)
    nil
  end
end
