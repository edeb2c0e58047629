# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'json'
require_relative '../../tools/chartc/lib/compiled'

# The charts of the product with their walks, and the limits that charts may name.
module ProductCharts
  ROOT = File.expand_path('../..', __dir__)
  listed = JSON.parse(File.read(File.join(ROOT, 'build/gen/limits/limits.json')))
  LIMITS = listed.to_h { |limit| limit.values_at('name', 'value') }.freeze
  # The requirement of each limit.
  OWNERS = listed.to_h { |limit| limit.values_at('name', 'requirement') }.freeze

  # A chart that is refused is told in the words of its refusal.
  def self.read(file)
    Chart::Compiled.from(file, File.read(file, encoding: 'UTF-8'), LIMITS, owners: OWNERS)
  rescue Chart::Refusal => e
    abort e.message
  end

  # file => chart
  ALL = Dir[File.join(ROOT, 'statecharts/*.scxml')].sort.to_h { |file| [file, read(file)] }.freeze
  abort 'there are no product charts' if ALL.empty?
end
