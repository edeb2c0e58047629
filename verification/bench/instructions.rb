# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'counters'
require_relative 'example'
require_relative 'support'

# Instructions of controller_step() over a recording, by stage, as x86-64 and as Cortex-A9 code.
class Instructions
  SAMPLER = File.join(ROOT, 'build/gcc/bin/bench-samples')
  SAMPLES = File.join(BENCH_OUT, 'samples.bin')
  RESULT = File.join(BENCH_OUT, 'instructions.json')
  ARM_EVEN = 60 # Evenly spaced cycles that are also traced as Cortex-A9 code, and
  ARM_WORST = 20 # the costliest ones of x86-64.
  CLOCK_MHZ = 667.0 # Of the Zynq-7020 on the controller board.
  COMMANDS_PER_CYCLE = JSON.parse(File.read(File.join(ROOT, 'build/gen/limits/limits.json')))
                           .find { |limit| limit['name'] == 'commands_per_cycle' }.fetch('value')

  Sample = Struct.new(:is_even, :cycle, :label)

  # Returns the table.
  def run
    puts 'Instructions of a control cycle'
    take_samples
    puts "  #{@samples.length} cycles of it: #{evens.length} at equal distances, " \
         "#{@samples.length - evens.length} with commands, answers or events"
    @x86 = timed('x86-64 under callgrind') { CallgrindCounter.new.count(SAMPLES, @samples.each_index.to_a) }
    @arm = timed('Cortex-A9 under qemu-arm') { ArmCounter.new.count(SAMPLES, arm_numbers) }
    puts '  every output equal to the recorded one, on both'
    File.write(RESULT, "#{JSON.pretty_generate(result)}\n")
    report
  end

  private

  # Of BENCH_RECORDING, or of the demonstration's longest recording, or of one of our own when there is none that this
  # build repeats.
  def take_samples
    candidates.each do |file|
      return nil if sample(file)

      puts "  #{relative(file)} does not serve: #{@said.strip}"
    end
    puts '  no recording of `make demo` serves: making one (about 30 s)'
    file = Example.make
    raise BenchFailed, @said unless sample(file)
  end

  def candidates
    return [ENV['BENCH_RECORDING']] if ENV['BENCH_RECORDING']

    Dir.glob(File.join(ROOT, 'build/demo/*.bsr')).sort_by { |file| -File.size(file) }
  end

  def sample(file)
    @said, errors, status = Open3.capture3(SAMPLER, file, SAMPLES)
    unless status.success?
      @said = errors
      return false
    end
    @recording = relative(file)
    @samples = @said.lines(chomp: true).map do |line|
      kind, cycle, label = line.split("\t", 3)
      Sample.new(kind == 'even', cycle.to_i, label)
    end
    puts "  recording: #{@recording}"
    true
  end

  def relative(file)
    file.delete_prefix("#{ROOT}/")
  end

  def evens
    @samples.each_index.select { |i| @samples[i].is_even }
  end

  def arm_numbers
    some = evens.each_slice([evens.length / ARM_EVEN, 1].max).map(&:first)
    worst = @x86.keys.max_by(ARM_WORST) { |i| @x86[i][:all] }
    by_stage = STAGES.map { |stage| worst_of(@x86, stage) }
    (some + worst + by_stage).uniq.sort
  end

  def timed(what)
    print "  counting #{what} ... "
    began = Boresight.now
    yield.tap { |counts| puts format('%<n>d cycles, %<s>.0f s', n: counts.length, s: Boresight.now - began) }
  end

  def worst_of(counts, stage)
    counts.keys.max_by { |i| counts[i][stage] }
  end

  def figures(counts, stage)
    worst = worst_of(counts, stage)
    { median: median((evens & counts.keys).map { |i| counts[i][stage] }), worst: counts[worst][stage],
      worst_cycle: @samples[worst].cycle, worst_with: @samples[worst].label }
  end

  def result
    @result ||= {
      recording: @recording, samples: @samples.length, samples_cortex_a9: @arm.length,
      stages: [*STAGES, :all].to_h do |stage|
        [stage, { x86_64: figures(@x86, stage), cortex_a9: figures(@arm, stage) }]
      end
    }
  end

  def report
    ['Instructions of controller_step, by stage, with everything it calls (gcc -O2)', table, *remarks].join("\n")
  end

  def table
    head = ['stage', 'x86-64 median', 'worst', 'Cortex-A9 median', 'worst', 'worst cycle (x86-64), what it had']
    rows = result[:stages].map do |stage, of|
      x86, arm = of.values_at(:x86_64, :cortex_a9)
      [stage == :all ? 'controller_step' : stage, x86[:median], x86[:worst], arm[:median], arm[:worst],
       "#{x86[:worst_cycle]} #{shorten(x86[:worst_with])}".rstrip]
    end
    Table.render(head, rows, left: [0, 5])
  end

  def shorten(text)
    text.length > 48 ? "#{text[0, 45]}..." : text
  end

  def remarks
    all = result[:stages][:all][:cortex_a9]
    obey = result[:stages][:obey][:cortex_a9][:worst]
    full = all[:worst] + ((COMMANDS_PER_CYCLE - 1) * obey)
    ["The median is of the evenly spaced cycles, the worst of all; #{@arm.length} of them ran as Cortex-A9 code.",
     "At one instruction per clock of #{CLOCK_MHZ.to_i} MHz the Cortex-A9 would need #{share(all[:median])} of the " \
     "cycle of 1000 us, at worst #{share(all[:worst])}.",
     "A cycle takes at most #{COMMANDS_PER_CYCLE} commands; if each were as costly as the worst here: " \
     "#{Table.text(full)} instructions, #{share(full)}.",
     'Instructions are not time: waiting for memory is not in them.']
  end

  def share(instructions)
    format('%.1f %%', instructions / CLOCK_MHZ / 10.0)
  end
end
