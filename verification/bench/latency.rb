# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'cyclictest'
require_relative 'support'
require_relative '../system/support/boresight'

# Wake-up latency of the control loop beside that of cyclictest with the same settings, in turn on the same machine.
class Latency
  SECONDS = Integer(ENV.fetch('BENCH_SECONDS', '10'))
  PAIRS = 2
  RESULT = File.join(BENCH_OUT, 'latency.json')
  RIGHTS = { 'fifo' => 'SCHED_FIFO', 'core' => 'a core of its own', 'memory' => 'locked memory' }.freeze

  # Returns the table.
  def run
    puts "Wake-up latency, #{PAIRS} times #{SECONDS} s each, in turn (BENCH_SECONDS changes that)"
    raise BenchFailed, 'BENCH_SECONDS must be at least 2' if SECONDS < 2

    @cyclictest = Cyclictest.new
    @ours = []
    @reference = []
    PAIRS.times do |i|
      @ours << announced("control loop, run #{i + 1}") { measure_loop }
      @reference << announced("cyclictest, run #{i + 1}") { @cyclictest.measure(SECONDS) }
    end
    File.write(RESULT, "#{JSON.pretty_generate(result)}\n")
    report
  end

  private

  def announced(what)
    print "  #{what} ... "
    @is_shared ||= Neighbours.new.any?
    yield.tap { |figures| puts figures ? "worst #{figures[:worst]} us" : 'not possible' }
  end

  # The whole system, fresh; no client asks it anything until the end.
  def measure_loop
    robot = Boresight.start(arguments: ['--real-time'])
    sleep SECONDS
    loop_figures = robot.wait_until('the loop has run long enough') do
      figures = robot.status['loop']
      figures if figures['cycles'] >= SECONDS * 1000
    end
    note_missing_rights(loop_figures['rights'])
    { p50: loop_figures['wake_p50_us'], p99: loop_figures['wake_p99_us'], p999: loop_figures['wake_p999_us'],
      worst: loop_figures['wake_worst_us'], cycles: loop_figures['cycles'] }
  ensure
    robot&.kill_all
  end

  def note_missing_rights(rights)
    @missing = RIGHTS.reject { |name, _| rights[name] }.values
  end

  def result
    @result ||= { seconds: SECONDS, control_loop: @ours, cyclictest: @reference.compact, missing_rights: @missing }
  end

  def report
    [title, table, *remarks].join("\n")
  end

  def title
    "Wake-up latency in us: SCHED_FIFO 80, every 1000 us, core #{Cyclictest::LAST_CORE}, memory locked"
  end

  def table
    head = ['', 'p50', 'p99', 'p99.9', 'worst', 'cycles']
    keys = [*Cyclictest::QUANTILES.keys, :worst, :cycles]
    rows = @ours.zip(@reference).each_with_index.flat_map do |(ours, reference), i|
      [["control loop, run #{i + 1}", *ours.values_at(*keys)],
       ["cyclictest, run #{i + 1}", *(reference ? reference.values_at(*keys) : Array.new(keys.length))]]
    end
    Table.render(head, rows << ['loop / cyclictest', *ratios, ''])
  end

  # Ratios of the means of the runs; of the worst times the worst.
  def ratios
    return Array.new(Cyclictest::QUANTILES.length + 1) if @reference.any?(&:nil?)

    means = Cyclictest::QUANTILES.keys.map { |key| ratio(@ours.sum { |run| run[key] }, @reference.sum { |run| run[key] }) }
    means << ratio(@ours.map { |run| run[:worst] }.max, @reference.map { |run| run[:worst] }.max)
  end

  def ratio(ours, reference)
    reference.zero? ? nil : ours.to_f / reference
  end

  def remarks
    lines = ["This is #{machine}: the times are the machine's;", 'only the ratio says something about the program.',
             'The loop ran with its whole system beside it (box, recorder, servers), cyclictest with nothing.']
    lines << "Not granted to the loop: #{@missing.join(', ')}; run as root for a fair comparison." if @missing.any?
    lines << Neighbours::REMARK if @is_shared
    lines << "cyclictest could not run: #{@cyclictest.refusal}" if @cyclictest.refusal
    lines
  end
end
