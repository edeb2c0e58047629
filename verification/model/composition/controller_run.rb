# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'open3'
require_relative 'program'

# Configurations that the controller itself comes into, and its permits there (controller_run.c).
class ControllerRun
  ROOT = CompiledChart::ROOT
  SOURCES = %w[verification/model/composition/controller_run.c verification/integration/support/rig.c
               build/gen/interface/app/answer_list.c].freeze
  SUPPORT = %w[core app bsp bsp/include build/gen verification].freeze
  COLUMNS = %w[loop pedal estop card axis_1 axis_2 stall_1 stall_2 workphase arming authority need plan scanner permit_1 permit_2].freeze
  EPISODES = 120

  # Lists of numbers, one for each of COLUMNS; the block may change controller_drive.c.
  def self.seen(composition, episodes: EPISODES)
    drive = File.read("#{ROOT}/core/controller/cycle/controller_drive.c")
    Dir.mktmpdir do |folder|
      CompositionProgram.new(composition).write(folder)
      File.write("#{folder}/controller_drive.c", block_given? ? yield(drive) : drive)
      build(folder)
      call("#{folder}/run", episodes.to_s).lines.uniq.map { |line| line.split.map(&:to_i) }
    end
  end

  # Part of it about this composition.
  def self.part(seen, composition)
    places = [*composition.members.map(&:name), *composition.permits.keys].map { |name| COLUMNS.index(name) }
    seen.map { |numbers| numbers.values_at(*places) }.uniq
  end

  def self.build(folder)
    unity = File.join(Gem::Specification.find_by_name('ceedling').gem_dir, 'vendor/unity/src')
    library = 'build/gcc/libtest-core.a'
    call('make', '--no-print-directory', '-C', ROOT, library)
    includes = Dir.glob(SUPPORT, base: ROOT).map { |support| "#{ROOT}/#{support}" }
    own = %w[plan_chart scanner_chart need_chart controller_drive].map { |name| "#{folder}/#{name}.c" }
    call('gcc', '-std=c99', '-O2', *[folder, unity, *includes].map { |include| "-I#{include}" },
         *SOURCES.map { |source| "#{ROOT}/#{source}" }, "#{unity}/unity.c", *own, "#{ROOT}/#{library}", '-lm',
         '-o', "#{folder}/run")
  end

  def self.call(*command)
    output, status = Open3.capture2e(*command)
    status.success? ? output : raise(CompiledChart::Failed, output)
  end
  private_class_method :build, :call
end
