# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'yaml'
require_relative 'generator'
require_relative 'minimiser'
require_relative 'product_generator'
require_relative 'survey'
require_relative 'trial'

module RandomCharts
  # Compares chart after chart, and asks of those that are refused by what running shows whether it shows that; what
  # differs is made small and kept. Each second seed is a chart of a product.
  class Hunt
    FOLDER = File.expand_path('../../../../build/conformance/random', __dir__)
    # Where the cases stand that every run of the conformance gate takes.
    CASES = File.expand_path('../cases', __dir__)
    # So many charts make one program.
    TOGETHER = 25
    # A chart that differs, and how.
    Found = Struct.new(:seed, :differences, :file)

    # products: how many of the accepted ones; shapes: programs of each; judged: refusals that are right.
    attr_reader :accepted, :products, :refused, :shapes, :judged, :found, :last_seed

    # keep: the folder for what differs.
    def initialize(first_seed, keep: File.join(FOLDER, 'found'))
      @first_seed = @last_seed = first_seed
      @keep = keep
      @accepted = @products = @judged = 0
      @shapes = Hash.new(0)
      @refused = Hash.new(0)
      @found = []
    end

    # Goes on until the block, asked after each program, says that it is enough.
    def run
      seeds = (@first_seed..).lazy
      seeds.filter_map { |seed| trial(seed) }.each_slice(TOGETHER) do |trials|
        compare(trials)
        @accepted += trials.length
        @products += trials.count { |one| one.trial.document.mode == :product }
        @last_seed = trials.last.seed
        break if yield self
      end
      self
    end

    def to_s
      "random charts: #{@accepted} (seeds #{@first_seed} to #{@last_seed}, #{@products} of products) as " \
        "#{@shapes.sort.map { |shape, count| "#{count} #{shape}" }.join(' and ')} programs, " \
        "#{@refused.values.sum} refused (#{@refused.sort.map { |rule, count| "R#{rule}: #{count}" }.join(', ')}; " \
        "#{@judged} judged), #{@found.length} differ"
    end

    private

    Seeded = Struct.new(:seed, :chart, :trial)
    private_constant :Seeded

    def trial(seed)
      chart = (seed.even? ? ProductGenerator : Generator).new(seed).chart
      trial = Trial.new("chart_#{seed}", chart.xml) { |machine, inputs| Scenario.new(Random.new(seed)).steps(machine, inputs) }
      Seeded.new(seed, chart, trial)
    rescue Chart::Refusal => e
      @refused[e.rule] += 1
      judge(seed, chart, e) if Survey::RULES.include?(e.rule) && e.message.include?('reached by')
      nil
    end

    # What the walk says is done, appendix D must do.
    def judge(seed, chart, refusal)
      case Survey.new(chart.xml).breaks?(refusal.rule, Trial::MOST_SNAPSHOTS)
      when true then @judged += 1
      when false then keep(Seeded.new(seed, chart), ["refused for nothing: #{refusal.message}"])
      end
    end

    def compare(trials)
      trials.each { |one| @shapes[one.trial.machine.shape] += 1 }
      differing(trials).each { |one| keep_small(one) }
    end

    # One that the compiler refuses, or that ends the program, is found by itself.
    def differing(trials)
      Trial.differences(FOLDER, trials.map(&:trial)).zip(trials).filter_map { |words, one| one if words.any? }
    rescue Program::Refused
      trials.length == 1 ? trials : trials.each_slice(1).flat_map { |one| differing(one) }
    end

    def keep_small(one)
      chart, steps = Minimiser.new(one.chart, one.trial.steps) { |*candidate| words(*candidate).any? }.run
      keep(Seeded.new(one.seed, chart, Trial.new('found', chart.xml, steps)), words(chart, steps))
    end

    # A refused chart has no steps.
    def keep(one, differences)
      file = File.join(@keep, name = "seed_#{one.seed}")
      FileUtils.mkdir_p(@keep)
      one.chart.attributes['name'] &&= name
      File.write("#{file}.scxml", one.chart.xml)
      File.write("#{file}.yml", Case.new(one.trial, one.seed).text) if one.trial
      @found << Found.new(one.seed, differences, file)
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
    def initialize(trial, seed)
      @trial = trial
      @seed = seed
    end

    def text
      rows = @trial.steps.zip(@trial.expected)
      start, *rest = rows.map { |step, seen| words(step, seen) }
      limits = @trial.document.mode == :product ? { 'limits' => ProductGenerator::LIMITS } : {}
      says = "Differed once, as the random chart of seed #{@seed}."
      YAML.dump({ 'says' => says }.merge(limits, 'start' => start, 'steps' => rest))
          .sub("---\n", "# SPDX-License-Identifier: Apache-2.0\n")
    end

    private

    def words(step, seen)
      stimulus = { event: { 'event' => step.value }, advance: { 'advance' => "#{step.value}us" }, start: {},
                   stray: { 'event' => @trial.document.events.length } }
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
  hunt = RandomCharts::Hunt.new(seed, keep: RandomCharts::Hunt::CASES).run { |one| one.accepted >= count }
  hunt.found.each { |one| puts "seed #{one.seed}: #{one.file}.scxml", one.differences }
  puts hunt
  exit(hunt.found.empty?)
end
