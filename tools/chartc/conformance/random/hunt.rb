# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'yaml'
require_relative 'generator'
require_relative 'minimiser'
require_relative 'trial'

module RandomCharts
  # Compares chart after chart; what differs is made small and kept as a case (tools/chartc/conformance/cases).
  class Hunt
    FOLDER = File.expand_path('../../../../build/conformance/random', __dir__)
    # So many charts make one program.
    TOGETHER = 25
    # A chart that differs, and how.
    Found = Struct.new(:seed, :differences, :file)

    attr_reader :accepted, :refused, :machines, :found, :last_seed

    def initialize(first_seed)
      @first_seed = @last_seed = first_seed
      @accepted = @machines = 0
      @refused = Hash.new(0)
      @found = []
    end

    # Goes on until the block, asked after each program, says that it is enough.
    def run
      seeds = (@first_seed..).lazy
      seeds.filter_map { |seed| trial(seed) }.each_slice(TOGETHER) do |trials|
        compare(trials)
        @accepted += trials.length
        @last_seed = trials.last.seed
        break if yield self
      end
      self
    end

    def to_s
      "random charts: #{@accepted} (seeds #{@first_seed} to #{@last_seed}) as #{@machines} programs, " \
        "#{@refused.values.sum} refused (#{@refused.sort.map { |rule, count| "R#{rule}: #{count}" }.join(', ')}), " \
        "#{@found.length} differ"
    end

    private

    Seeded = Struct.new(:seed, :chart, :trial)
    private_constant :Seeded

    def trial(seed)
      chart = Generator.new(seed).chart
      trial = Trial.new("chart_#{seed}", chart.xml) { |machine, inputs| Scenario.new(Random.new(seed)).steps(machine, inputs) }
      Seeded.new(seed, chart, trial)
    rescue Chart::Refusal => e
      @refused[e.rule] += 1
      nil
    end

    def compare(trials)
      @machines += trials.sum { |one| one.trial.machines.length }
      differing(trials).each { |one| keep(one) }
    end

    # One that the compiler refuses, or that ends the program, is found by itself.
    def differing(trials)
      Trial.differences(FOLDER, trials.map(&:trial)).zip(trials).filter_map { |words, one| one if words.any? }
    rescue Program::Refused
      trials.length == 1 ? trials : trials.each_slice(1).flat_map { |one| differing(one) }
    end

    def keep(one)
      chart, steps = Minimiser.new(one.chart, one.trial.steps) { |*candidate| words(*candidate).any? }.run
      file = File.join(FOLDER, 'found', "seed_#{one.seed}")
      FileUtils.mkdir_p(File.dirname(file))
      trial = Trial.new('found', chart.xml, steps)
      File.write("#{file}.scxml", chart.xml)
      File.write("#{file}.yml", Case.new(trial).text)
      @found << Found.new(one.seed, words(chart, steps), file)
    end

    # What goes wrong with a chart and its steps; nothing if the compiler does not take it.
    def words(chart, steps)
      Trial.differences(FOLDER, [Trial.new('small', chart.xml, steps)]).first
    rescue Program::Refused => e
      [e.message]
    rescue Chart::Refusal, AppendixD::Endless, KeyError
      []
    end
  end

  # A trial as conformance's own cases are written, with what appendix D shows.
  class Case
    def initialize(trial)
      @trial = trial
    end

    def text
      rows = @trial.steps.zip(@trial.expected)
      start, *rest = rows.map { |step, seen| words(step, seen) }
      YAML.dump('says' => 'To be said.', 'start' => start, 'steps' => rest).sub("---\n", "# SPDX-License-Identifier: Apache-2.0\n")
    end

    private

    def words(step, seen)
      stimulus = { event: { 'event' => step.value }, advance: { 'advance' => "#{step.value}us" }, start: {} }
      with = step.inputs.select { |_name, value| value }.keys
      row = stimulus.fetch(step.kind)
      row['with'] = with if with.any?
      row.merge('in' => seen.leaves, 'data' => seen.data, 'armed' => seen.armed,
                'actions' => step.kind == :start ? nil : seen.actions).reject { |_key, value| value.nil? || value.empty? }
    end
  end
end

if $PROGRAM_NAME == __FILE__
  count, seed = ARGV.map(&:to_i)
  hunt = RandomCharts::Hunt.new(seed).run { |one| one.accepted >= count }
  hunt.found.each { |one| puts "seed #{one.seed}: #{one.file}.scxml", one.differences }
  puts hunt
  exit(hunt.found.empty?)
end
