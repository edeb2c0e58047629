# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'crowd'
require_relative 'cyclictest'
require_relative 'support'
require_relative '../system/support/session_client'

# Cost of clients that crowd the HTTP server while the bench moves. Each crowd is met twice, for the same time: by the
# control loop, and by cyclictest in its place, beside a whole system without the loop's rights. The crowd leaves the loop's
# core both times, as who is at another computer: beside cyclictest the loop's own elastic substitute kept it away from there,
# beside the loop nothing did, and its packets were received on the core that it ran on.
class Crowds
  SECONDS = Integer(ENV.fetch('BENCH_SECONDS', '10'))
  CROWDS = { 'quiet' => {}, 'consoles' => { consoles: 8 }, 'lazy' => { lazy: 200 },
             'flood' => { comers: 64 }, 'halves' => { halves: 300 }, 'guesses' => { guessers: 32 },
             'all' => { consoles: 8, lazy: 200, comers: 64, halves: 300, guessers: 32 } }.freeze
  STOPS = 200
  STOP_SECONDS = 10 # Duration of stops at one port, if there are not STOPS before.
  NO_RIGHTS = %w[prlimit --rtprio=0 --memlock=65536 setpriv --bounding-set=-sys_nice,-ipc_lock].freeze
  WAKE = { 'p50' => :p50, 'p99' => :p99, 'p99.9' => :p999, 'worst' => :worst }.freeze
  LOOP = { p50: 'wake_p50_us', p99: 'wake_p99_us', p999: 'wake_p999_us', worst: 'wake_worst_us' }.freeze
  SHOWN = { 'control loop' => :loop, 'cyclictest' => :cyclictest, 'loop / cyclictest' => :ratio }.freeze
  PORTS = { 'STOP at its port' => :stop_port, 'STOP at the console\'s' => :console_port }.freeze

  def run
    off_the_loops_core { report }
  end

  private

  def report
    puts "Crowds at the HTTP server, #{CROWDS.size} times twice #{SECONDS} s of moves (BENCH_SECONDS changes that)"
    folder = Dir.mktmpdir('accounts')
    @accounts = Accounts.make(File.join(folder, 'accounts'))
    @reference = Cyclictest.new
    @met = CROWDS.to_h { |name, counts| [name, meet(name, counts)] }
    [title, Table.render(['', *CROWDS.keys], rows), *remarks].join("\n")
  ensure
    FileUtils.rm_rf(folder) if folder
  end

  # This program and all that it starts; control, box and cyclictest take that core by themselves.
  def off_the_loops_core
    return yield if Cyclictest::LAST_CORE.zero?

    pin("0-#{Cyclictest::LAST_CORE - 1}")
    begin
      yield
    ensure
      pin("0-#{Cyclictest::LAST_CORE}")
    end
  end

  def pin(cores)
    _, status = Open3.capture2e('taskset', '--all-tasks', '--pid', '--cpu-list', cores, Process.pid.to_s)
    raise BenchFailed, "taskset #{cores} failed" unless status.success?
  end

  def meet(name, counts)
    print "  #{name} ... "
    @is_shared ||= Neighbours.new.any?
    met = meet_loop(counts).merge(cyclictest: meet_cyclictest(counts))
    met[:ratio] = ratio(met)
    puts "worst #{met[:loop][:worst]} us"
    met
  end

  def ratio(met)
    WAKE.values.to_h { |key| [key, met[:loop][key] / met[:cyclictest][key].to_f] } if met[:cyclictest]
  end

  def meet_loop(counts)
    robot = start('--real-time')
    met = { before_kb: server_kb(robot, 'VmRSS') }
    seen = Crowd.around(robot.http_port, **counts) do
      met.update(move_for(robot))
      met[:loop] = LOOP.transform_values { |key| robot.status.dig('loop', key) }
      met.update(stops_of(robot))
      met[:after_kb] = server_kb(robot, 'VmRSS')
    end
    met.merge(most_kb: server_kb(robot, 'VmHWM'), counts: robot.status['counts'], seen: seen)
  ensure
    robot&.kill_all
  end

  # Without the loop, which would wait for it.
  def meet_cyclictest(counts)
    robot = start(prefix: Process.uid.zero? ? NO_RIGHTS : [])
    figures = nil
    Crowd.around(robot.http_port, **counts) do
      reference = Thread.new { @reference.measure(SECONDS) }
      move_for(robot)
      figures = reference.value
    end
    figures
  ensure
    robot&.kill_all
  end

  def start(*arguments, prefix: [])
    Boresight.start(arguments: ['--robot', TargetMove::ROBOT, '--accounts', @accounts, *arguments], prefix: prefix)
  end

  # A motion that ends elsewhere is a result, and no failure; the crowd is met for as long as by cyclictest all the same.
  # Otherwise most of the loop's cycles were those in which the programs start.
  def move_for(robot)
    ends = Boresight.now + SECONDS
    target_move = TargetMove.new(robot)
    target_move.prepare
    loop do
      target_move.move
      break if Boresight.now >= ends
    end
    { off_nm: target_move.off_nm }
  rescue RuntimeError => e
    sleep [ends - Boresight.now, 0].max
    { trouble: e.message }
  end

  def stops_of(robot)
    { stop_port: stop_times(robot, robot.stop_port), console_port: stop_times(robot, robot.http_port) }
  end

  # In ms, the shortest first.
  def stop_times(robot, port)
    ends = Boresight.now + STOP_SECONDS
    times = []
    times << stop_ms(robot, port) while times.size < STOPS && Boresight.now < ends
    times.sort
  end

  def stop_ms(robot, port)
    began = Boresight.now
    code = robot.post_stop(port).code
    raise BenchFailed, "a stop was answered #{code}" unless code == '200'

    (Boresight.now - began) * 1000
  end

  def server_kb(robot, name)
    Integer(File.read("/proc/#{robot.pid_of('http')}/status")[/^#{name}:\s+(\d+) kB$/, 1])
  end

  def title
    "Crowds at the HTTP server while the robot moves: wake-up latency in us, STOP in ms, the server's memory in kB"
  end

  def rows
    wake_rows + stop_rows + PLAIN.map { |says, value| [says, *@met.values.map(&value)] }
  end

  def wake_rows
    SHOWN.flat_map do |says, who|
      WAKE.map { |quantile, key| ["#{says}, #{quantile}", *@met.values.map { |met| met.dig(who, key) }] }
    end
  end

  def stop_rows
    PORTS.flat_map do |says, port|
      times = @met.values.map { |met| met.fetch(port) }
      [["#{says}, number", *times.map(&:size)], ["#{says}, p50", *times.map { |some| quantile(some, 0.5) }],
       ["#{says}, p99", *times.map { |some| quantile(some, 0.99) }], ["#{says}, worst", *times.map(&:last)]]
    end
  end

  def quantile(sorted, share)
    sorted[(sorted.size * share).ceil - 1]
  end

  # The rest of the table.
  PLAIN = { 'memory before' => ->(met) { met[:before_kb] }, 'memory after' => ->(met) { met[:after_kb] },
            'memory at most' => ->(met) { met[:most_kb] },
            'cycles lost' => ->(met) { met[:counts]['cycles_lost'] },
            'cycles late' => ->(met) { met[:counts]['overruns'] },
            'events lost' => ->(met) { met[:counts]['events_lost'] + met[:seen]['missed'] },
            'requests answered' => ->(met) { Crowd::KINDS.sum { |kind| met[:seen][kind.to_s]['answered'] } },
            'refused or dropped' => lambda { |met|
              Crowd::KINDS.sum { |kind| met[:seen][kind.to_s].values_at('refused', 'dropped').sum }
            },
            'farthest from a target, um' => ->(met) { met[:off_nm] && (met[:off_nm] / 1000.0) } }.freeze
  private_constant :PLAIN

  def remarks
    lines = ["This is #{machine}, and the crowd ran on it: only the ratios say something about the program.",
             'Both met the same crowd, off their core, beside box, recorder and servers; cyclictest also beside a loop without ' \
             'its rights. The figures of the loop are from its start to the end of the moves, before the stops.']
    lines.concat(@met.filter_map { |name, met| "#{name}: a move did not end: #{met[:trouble]}" if met[:trouble] })
    lines << Neighbours::REMARK if @is_shared
    lines << "cyclictest could not run: #{@reference.refusal}" if @reference.refusal
    lines
  end
end
