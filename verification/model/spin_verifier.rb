# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'open3'
require 'tmpdir'
require_relative '../../tools/chart/emit/promela/steps'

# One Promela model as SPIN's verifiers: one that prints every step and one that prints nothing.
class SpinVerifier
  # SPIN or the compiler refused the model.
  class Failed < StandardError; end

  # violation: what was asserted, nil if nothing is violated. trail: the lines of the steps that lead to it.
  Report = Struct.new(:stored, :errors, :violation, :trail, keyword_init: true)

  # Variables that are only written or printed stay part of the state.
  SPIN = %w[spin -a -o1 -o2 model.pml].freeze
  # One process and no cycles to look for: nothing to reduce.
  COMPILER = %w[gcc -O1 -DSAFETY -DNOREDUCE -w pan.c].freeze
  TOO_SMALL = 'max search depth too small'
  PREFIX = Chart::Promela::Steps::PREFIX

  # How deep a search may go, tried in turn: every new configuration is some ten moves deeper.
  DEPTHS = Array.new(6) { |power| 10_000 * 4**power }.freeze

  # depths: for a model whose depth is known, that one alone.
  def self.open(model, depths: DEPTHS)
    Dir.mktmpdir('spin') do |folder|
      File.write(File.join(folder, 'model.pml'), model)
      yield new(folder, depths)
    end
  end

  def initialize(folder, depths)
    @folder = folder
    @depths = depths
    call(*SPIN)
    call(*COMPILER, '-o', 'silent')
    call(*COMPILER, '-DPRINTF', '-o', 'talking')
    @limits = ['-w20', "-m#{depth}"]
  end

  # Yields the line of every step of the search, whatever properties say.
  def steps
    report = []
    IO.popen(['./talking', '-A', '-E', *@limits, { chdir: @folder, err: %i[child out] }]) do |pipe|
      pipe.each_line(chomp: true) do |line|
        line.start_with?(PREFIX) ? yield(line.delete_prefix(PREFIX)) : report << line
      end
    end
    check(report.join("\n"))
  end

  # The search without a word, with the properties.
  def verify
    output = call('./silent', *@limits)
    errors = output[/errors: (\d+)/, 1].to_i
    check(output) if errors.zero?
    violation = output[/^pan:1: assertion violated (.*?) \(at depth/, 1]
    Report.new(stored: output[/(\d+) states, stored/, 1].to_i, errors: errors, violation: violation,
               trail: errors.positive? ? trail : [])
  end

  private

  def depth
    return @depths.first if @depths.one?

    @depths.find { |depth| !call('./silent', '-A', '-E', '-w20', "-m#{depth}").include?(TOO_SMALL) } ||
      raise(Failed, "the search is deeper than #{@depths.last}, or a step never ends")
  end

  def check(output)
    complete = output.include?('errors: 0') && !output.match?(/not completed|out of memory|#{TOO_SMALL}/o)
    raise Failed, "the search did not come to its end: #{output}" unless complete
  end

  def trail
    call('./talking', '-S').lines(chomp: true).grep(/\A#{PREFIX}/o).map { |line| line.delete_prefix(PREFIX) }
  end

  def call(*command)
    output, status = Open3.capture2e(*command, chdir: @folder)
    raise Failed, "#{command.join(' ')}: #{output}" unless status.success? || File.basename(command.first) == 'silent'

    output
  end
end
