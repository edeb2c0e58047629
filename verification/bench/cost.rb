# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'yaml'
require_relative 'counters'
require_relative 'scene'

# Cost of a cycle as Cortex-A9 code, by robot and stage; the approved figures are in the same form.
class Cost
  APPROVED = File.join(ROOT, 'verification/bench/cost.yml')
  WRITTEN = File.join(BENCH_OUT, 'cost.yml')
  APPROVE = 'make cost-approve'
  ROBOTS = %w[neuro prostate].freeze
  GATED = %w[median worst].freeze
  HEAD = <<~TEXT
    # SPDX-License-Identifier: Apache-2.0
    # What a control cycle costs at most, written by `make cost`, approved by `#{APPROVE}`.
    # Instructions of controller_step() on a Cortex-A9 for the cards of each robot, seven with that of a sensor, by stage,
    #   each with all that it calls, counted by qemu-arm over single cycles of one scene (verification/bench/samples.c).
    #   The median is of cycles at equal distances, the worst of these and of all with a command, an answer or an event.
  TEXT

  def self.approved
    new(YAML.safe_load_file(APPROVED).fetch('robots'))
  end

  def self.measured
    new(ROBOTS.to_h { |robot| [robot, stages(Scene.new(robot))] })
  end

  def self.stages(scene)
    counts = ArmCounter.new.count(scene.file, scene.numbers)
    [*STAGES, :all].to_h { |stage| [stage.to_s, row(scene.figures(counts, stage))] }
  end

  # Median of the whole cycle, of cycles at equal distances, by the mode that the robot moved in; NONE at rest.
  def self.medians_by_mode(*play)
    scene = Scene.new(*play)
    evens = scene.numbers.select { |i| scene.samples[i].is_even }
    counts = ArmCounter.new.count(scene.file, evens)
    evens.group_by { |i| scene.samples[i].mode }
         .transform_values { |numbers| median(numbers.map { |i| counts[i][:all] }) }
  end

  def self.row(figures)
    { 'median' => figures[:median], 'worst' => figures[:worst],
      'worst_in' => "cycle #{figures[:worst_cycle]} #{figures[:worst_with]}".strip }
  end
  private_class_method :stages, :row

  # By robot and stage.
  attr_reader :rows

  def initialize(rows)
    @rows = rows
  end

  def write
    File.write(WRITTEN, HEAD + YAML.dump({ 'robots' => rows }, line_width: -1).delete_prefix("---\n"))
  end

  # Figures above the approved ones, one sentence each.
  def complaints(approved)
    each_row.flat_map do |robot, stage, row|
      before = approved.rows.fetch(robot).fetch(stage)
      GATED.select { |key| row.fetch(key) > before.fetch(key) }.map do |key|
        where = " (#{row['worst_in']})" if key == 'worst'
        "#{robot}, #{stage}: #{key} grew from #{before[key]} to #{row[key]} instructions#{where}; " \
          "if it must be, approve it anew: #{APPROVE}"
      end
    end
  end

  def summary
    each_row.map do |robot, stage, row|
      format('%-9<robot>s%-8<stage>s %6<median>d, at most %6<worst>d',
             robot: robot, stage: stage, median: row['median'], worst: row['worst'])
    end
  end

  private

  def each_row
    rows.flat_map { |robot, stages| stages.map { |stage, row| [robot, stage, row] } }
  end
end

if $PROGRAM_NAME == __FILE__
  begin
    puts(Cost.measured.tap(&:write).summary)
  rescue BenchFailed => e
    abort "cost: #{e.message}"
  end
end
