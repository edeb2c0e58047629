# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../model/product_charts'

# Verdict of the compiler on a mutant. A rule whose message is mended by following it (an event that is taken or ignored
# now, a question that is asked no longer) refuses nothing: the mutant that follows is judged.
module Judge
  # R24: an input that nothing reads; R25, R26: an event without transition or ignored in vain; R35: a guard that is
  # always true.
  MENDED = [24, 25, 26, 35].freeze

  module_function

  # [Chart::Refusal, nil], or [nil, what Chart.compile gives].
  def judge(file, tree)
    [nil, Chart.compile(file, ProductCharts::LIMITS, tree: tree, forgiven: MENDED)]
  rescue Chart::Refusal => e
    [e, nil]
  end

  # Runs the block in a process of its own; a thread with its answer.
  def beside
    pipe = IO.popen('-', 'rb')
    if pipe.nil?
      $stdout.binmode.write(Marshal.dump(yield))
      $stdout.flush
      exit!(0)
    end
    Thread.new { Marshal.load(pipe.read).tap { pipe.close } } # rubocop:disable Security/MarshalLoad
  end

  # All that shows of a chart: where it starts and where it goes when it is damaged, and on every reachable pair where it
  # leads, what it does, which timers it starts.
  def behaviour(chart)
    steps = chart.walk.reachable_pairs.to_h do |pair|
      [[pair.before, pair.stimulus], pair.outcomes.map { |one| shown(one) }]
    end
    [shown(chart.walk.start), chart.document.safe.map(&:id), steps]
  end

  def shown(outcome)
    [outcome.after, outcome.actions.sort, outcome.started]
  end
end
