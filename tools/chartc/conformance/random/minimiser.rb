# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'generator'

module RandomCharts
  # Takes from a chart and its steps all that can be taken while the block still says that they fail.
  class Minimiser
    # A chart without these is another one.
    KEPT = %w[id xmlns xmlns:bs version datamodel name bs:safe].freeze

    def initialize(chart, steps, &fails)
      @chart = chart
      @steps = steps
      @fails = fails
    end

    # [chart, steps], of which nothing more can be taken.
    def run
      loop do
        before = [@chart, @steps]
        shorten
        (@chart.all.length - 1).downto(0) { |index| reduce(index) }
        return before if [@chart, @steps] == before
      end
    end

    private

    # Half of the steps at once, then a quarter and so on; the first one, the start, stays.
    def shorten
      size = @steps.length
      while (size /= 2).positive?
        (@steps.length - size).step(1, -size) do |index|
          fewer = @steps[0...index] + @steps.drop(index + size)
          @steps = fewer if @fails.call(@chart, fewer)
        end
      end
    end

    # The element goes, or leaves its states behind, or loses an attribute or all targets but one.
    def reduce(index)
      return if index >= @chart.all.length
      return if index.positive? && (try { |chart| replace(chart, index, []) } || try { |chart| hoist(chart, index) })

      attributes = @chart.all[index].attributes
      (attributes.keys - KEPT).each { |name| try { |chart| chart.all[index].attributes.delete(name) } }
      attributes.slice('target', 'initial').each do |name, value|
        value.split.each { |id| try { |chart| chart.all[index].attributes.store(name, id) } } if value.include?(' ')
      end
    end

    # Keeps what the block makes of a copy if that fails too.
    def try
      chart = @chart.copy
      yield chart
      tidy(chart)
      @chart = chart if chart != @chart && @fails.call(chart, @steps)
    end

    def replace(chart, index, nodes)
      node = chart.all[index]
      holder = chart.all.find { |one| one.children.any? { |child| child.equal?(node) } }
      place = holder.children.index { |child| child.equal?(node) }
      holder.children[place, 1] = nodes
    end

    def hoist(chart, index)
      replace(chart, index, chart.all[index].states)
    end

    # What speaks of states that are no more goes with them.
    def tidy(chart)
      ids = chart.all.map { |node| node.attributes['id'] }
      chart.all.each do |node|
        node.attributes.delete('initial') if (node.attributes['initial'].to_s.split - ids).any?
        node.attributes.delete('cond') if (node.attributes['cond'].to_s.scan(/In\('(\w+)'\)/).flatten - ids).any?
        node.children.reject! { |child| (child.attributes['target'].to_s.split - ids).any? }
        node.children.reject! { |child| child.attributes['sendid'] && !ids.include?(child.attributes['sendid']) }
      end
    end
  end
end
