# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../../tools/chartc/chart'

# The charts of the product with their walks, and the limits that charts may name.
module ProductCharts
  ROOT = File.expand_path('../..', __dir__)
  LIMITS = Chart::Limits.read(File.join(ROOT, 'build/gen/limits/limits.json')).freeze

  # A chart that is refused is reported in the words of its refusal.
  def self.read(file)
    Chart.compile(file, LIMITS)
  rescue Chart::Refusal => e
    abort e.message
  end

  # file => chart
  ALL = Dir[File.join(ROOT, 'statecharts/*.scxml')].sort.to_h { |file| [file, read(file)] }.freeze
  abort 'there are no product charts' if ALL.empty?
end
