# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'counters'
require_relative 'scene'

# Instructions of controller_step() over a scene, by stage, as x86-64 and as Cortex-A9 code.
class Instructions
  RESULT = File.join(BENCH_OUT, 'instructions.json')
  CLOCK_MHZ = 667.0 # Clock of the Zynq-7020 on the controller board.

  # Returns the table.
  def run
    puts 'Instructions of a control cycle'
    @scene = Scene.new
    puts "  #{@scene.samples.length} cycles of a scene: #{@scene.samples.count(&:is_even)} at equal distances, the " \
         'others with commands, answers or events'
    @x86 = timed('x86-64 under callgrind') { CallgrindCounter.new.count(@scene.file, @scene.numbers) }
    @arm = timed('Cortex-A9 under qemu-arm') { ArmCounter.new.count(@scene.file, @scene.numbers) }
    puts '  every output equal to that of the scene, on both'
    File.write(RESULT, "#{JSON.pretty_generate(result)}\n")
    report
  end

  private

  def timed(what)
    print "  counting #{what} ... "
    began = Boresight.now
    yield.tap { |counts| puts format('%<n>d cycles, %<s>.0f s', n: counts.length, s: Boresight.now - began) }
  end

  def result
    @result ||= {
      samples: @scene.samples.length,
      stages: [*STAGES, :all].to_h do |stage|
        [stage, { x86_64: @scene.figures(@x86, stage), cortex_a9: @scene.figures(@arm, stage) }]
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
    ['The median is of the evenly spaced cycles, the worst of all.',
     "At one instruction per clock of #{CLOCK_MHZ.to_i} MHz the Cortex-A9 would need #{share(all[:median])} of the " \
     "cycle of 1000 us, at worst #{share(all[:worst])}.",
     'Instructions are not time: waiting for memory is not in them.']
  end

  def share(instructions)
    format('%.1f %%', instructions / CLOCK_MHZ / 10.0)
  end
end
