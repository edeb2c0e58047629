# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'open3'
require 'tmpdir'
require_relative '../lib/emit/promela/steps'

# One Promela model as SPIN's verifier. It prints every step; one for large models prints nothing.
class SpinVerifier
  # SPIN or the compiler refused the model.
  class Failed < StandardError; end

  # violation: what was asserted, nil if nothing is violated. trail: the lines of the steps that lead to it.
  Report = Struct.new(:stored, :errors, :violation, :trail, keyword_init: true)

  # Variables that are only written or printed stay part of the state.
  SPIN = %w[spin -a -o1 -o2 model.pml].freeze
  # One process and no cycles to look for: nothing to reduce. Most models are compiled longer than they run.
  COMPILER = %w[gcc -DSAFETY -DNOREDUCE -w pan.c -o pan].freeze
  TALKING = %w[-O0 -DPRINTF].freeze
  SILENT = %w[-O2].freeze
  TOO_SMALL = 'max search depth too small'
  PREFIX = Chart::Promela::Steps::PREFIX

  # How deep a search may go, tried in turn: every new configuration is some ten moves deeper.
  DEPTHS = Array.new(6) { |power| 10_000 * 4**power }.freeze

  def self.open(model)
    Dir.mktmpdir('spin') { |folder| yield new(folder, model, TALKING, DEPTHS) }
  end

  # Of a large model whose depth is known.
  def self.verify(model, depth)
    Dir.mktmpdir('spin') { |folder| new(folder, model, SILENT, [depth]).verify }
  end

  def initialize(folder, model, flags, depths)
    @folder = folder
    @depths = depths
    File.write(File.join(folder, 'model.pml'), model)
    call(*SPIN)
    call(*COMPILER, *flags)
    @limits = ['-w20', "-m#{depth}"]
  end

  # Yields the line of every step of the search, whatever properties say.
  def steps
    report = []
    IO.popen(['./pan', '-A', '-E', *@limits, { chdir: @folder, err: %i[child out] }]) do |pipe|
      pipe.each_line(chomp: true) do |line|
        line.start_with?(PREFIX) ? yield(line.delete_prefix(PREFIX)) : report << line
      end
    end
    check(report.join("\n"))
  end

  # The search with the properties.
  def verify
    output = call('./pan', *@limits)
    errors = output[/errors: (\d+)/, 1].to_i
    check(output) if errors.zero?
    violation = output[/pan:1: assertion violated (.*?) \(at depth/, 1]
    Report.new(stored: output[/(\d+) states, stored/, 1].to_i, errors: errors, violation: violation,
               trail: errors.positive? ? trail : [])
  end

  private

  def depth
    return @depths.first if @depths.one?

    @depths.find { |depth| !call('./pan', '-A', '-E', '-w20', "-m#{depth}").include?(TOO_SMALL) } ||
      raise(Failed, "the search is deeper than #{@depths.last}, or a step never ends")
  end

  def check(output)
    complete = output.include?('errors: 0') && !output.match?(/not completed|out of memory|#{TOO_SMALL}/o)
    raise Failed, "the search did not come to its end: #{output}" unless complete
  end

  def trail
    call('./pan', '-S').lines(chomp: true).grep(/\A#{PREFIX}/o).map { |line| line.delete_prefix(PREFIX) }
  end

  def call(*command)
    output, status = Open3.capture2e(*command, chdir: @folder)
    raise Failed, "#{command.join(' ')}: #{output}" unless status.success? || command.first == './pan'

    output
  end
end
