# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'interpreter'
require_relative 'refusal'

module Chart
  # Explores every reachable configuration, breadth first, with every stimulus and every valuation of
  # the inputs. Legal configurations that are never reached are stepped too, so that the compiled code
  # is compared on them as well; they count for nothing else.
  class Walk
    # stimulus is [:event, name] or [:expire, timer ids]; outcomes hold one entry per valuation.
    Pair = Struct.new(:leaves, :armed, :stimulus, :outcomes, :reachable, keyword_init: true)

    attr_reader :pairs, :start, :reached

    def initialize(document)
      @document = document
      @interpreter = Interpreter.new(document)
      @valuations = valuations
    end

    def run
      @pairs = []
      @start = @interpreter.start
      @reached = { [@start.leaves, @start.armed] => nil }
      explore
      (legal_configurations - @reached.keys).each { |configuration| step_all(configuration, false) }
      self
    end

    # Hashes input name => boolean; bit n of the index is input n.
    def valuations
      names = @document.inputs.map(&:name)
      (0...(1 << names.length)).map do |bits|
        names.each_with_index.to_h { |name, index| [name, bits[index] == 1] }
      end
    end

    def reachable_pairs
      @pairs.select(&:reachable)
    end

    # Stimuli with valuations: what the printed number of pairs counts.
    def pair_count
      reachable_pairs.length * @valuations.length
    end

    # The shortest list of stimuli that leads to a configuration, in words.
    def path_to(configuration)
      path = []
      while (step = @reached[configuration])
        configuration, stimulus, inputs = step
        path.unshift(describe(stimulus, inputs))
      end
      path.empty? ? 'at the start' : path.join(', ')
    end

    def active(leaves)
      @interpreter.active(leaves).map(&:id)
    end

    def legal_configurations
      first, *rest = @document.regions.map { |region| region.leaves.map(&:id) }
      first.product(*rest).map { |leaves| [leaves, @interpreter.armed_by(leaves)] }
    end

    private

    def explore
      queue = @reached.keys
      until queue.empty?
        configuration = queue.shift
        step_all(configuration, true).each do |pair|
          pair.outcomes.each_with_index do |outcome, index|
            following = [outcome.leaves, outcome.armed]
            next if @reached.key?(following)

            @reached[following] = [configuration, pair.stimulus, @valuations[index]]
            queue << following
          end
        end
      end
    end

    def step_all(configuration, reachable)
      leaves, armed = configuration
      found = stimuli(armed).map do |stimulus|
        outcomes = @valuations.map { |inputs| step(leaves, armed, stimulus, inputs) }
        Pair.new(leaves: leaves, armed: armed, stimulus: stimulus, outcomes: outcomes, reachable: reachable)
      end
      @pairs.concat(found)
      found
    end

    def stimuli(armed)
      events = @document.events.map { |event| [:event, event] }
      expiries = (1..armed.length).flat_map { |count| armed.combination(count).map { |timers| [:expire, timers] } }
      events + expiries
    end

    def step(leaves, armed, stimulus, inputs)
      kind, what = stimulus
      return @interpreter.dispatch(leaves, armed, what, inputs) if kind == :event

      @interpreter.expire(leaves, armed, what, inputs)
    end

    def describe(stimulus, inputs)
      kind, what = stimulus
      set = inputs.select { |_name, value| value }.keys
      words = kind == :event ? what : "#{what.join(' and ')} expires"
      set.empty? ? words : "#{words} with #{set.join(' and ')}"
    end
  end
end
