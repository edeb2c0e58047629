# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'json'
require_relative '../../tools/chart/compiled'

# The charts of the product with their walks, and the limits that charts may name.
module ProductCharts
  ROOT = File.expand_path('../..', __dir__)
  LIMITS = JSON.parse(File.read(File.join(ROOT, 'build/gen/limits/limits.json')))
               .to_h { |limit| [limit.fetch('name'), limit.fetch('value')] }.freeze
  # file => chart
  ALL = Dir[File.join(ROOT, 'statecharts/*.scxml')].sort.to_h do |file|
    [file, Chart::Compiled.from(file, File.read(file, encoding: 'UTF-8'), LIMITS)]
  end.freeze
  raise 'there are no product charts' if ALL.empty?
end
