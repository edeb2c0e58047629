# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'difference/facts'
require_relative 'difference/version'

module Chart
  # The difference in meaning of two versions of charts, as text: a line for each change, with + for what came,
  # - for what went and ~ for what is different. Layout, comments and line numbers do not count.
  # @satisfies SWR-CHART-006
  class Difference
    NONE = 'no difference in meaning'
    WORST = { 'x86_instructions' => 'x86-64 instructions', 'arm_instructions' => 'ARM instructions',
              'x86_check_instructions' => 'x86-64 instructions of the check',
              'arm_check_instructions' => 'ARM instructions of the check',
              'stack_bytes' => 'stack bytes', 'ram_bytes' => 'RAM bytes' }.freeze

    # Of each chart of two Versions.
    def self.of(old, new)
      new.keep(old.names) if old.file? && !new.file?
      old.keep(new.names) if new.file? && !old.file?
      between(old.charts, new.charts, old.worst_case, new.worst_case)
    end

    # The worst cases are contents of worst_case.yml, or nil. One chart is compared with one whatever their names.
    def self.between(old_charts, new_charts, old_worst = nil, new_worst = nil)
      return [new(*old_charts, *new_charts, old_worst, new_worst)] if old_charts.one? && new_charts.one?

      old, new = [old_charts, new_charts].map { |charts| charts.to_h { |chart| [chart.document.name, chart] } }
      (old.keys | new.keys).sort.map { |name| new(old[name], new[name], old_worst, new_worst) }
    end

    # Two charts; one is nil if the other version has none of its name.
    def initialize(old, new, old_worst = nil, new_worst = nil)
      @charts = [old, new]
      @worst = [old_worst, new_worst]
    end

    def none?
      @charts.all? && lines.empty?
    end

    def to_s
      old, new = names
      return "+ chart #{new}\n" unless old
      return "- chart #{old}\n" unless new

      title = names.uniq.join(' -> ')
      none? ? "#{title}: #{NONE}\n" : "#{[title, *lines.map { |line| "  #{line}" }].join("\n")}\n"
    end

    def lines
      @lines ||= begin
        old, new = @charts.map { |chart| Facts.of(chart) }
        old.keys.flat_map { |section| changes(section, old.fetch(section), new.fetch(section)) } + worst_lines
      end
    end

    private

    def names
      @charts.map { |chart| chart&.document&.name }
    end

    def worst_lines
      before, after = @worst.zip(names).map { |worst, name| worst&.dig('charts', name) }
      return [] unless before && after

      WORST.filter_map do |key, title|
        words = change(before[key], after[key]) || next
        witness = after[key.sub('instructions', 'witness')] if key.end_with?('instructions')
        "~ worst case #{title}: #{words}#{" (#{witness})" if witness}"
      end
    end

    def changes(section, old, new)
      (old.keys | new.keys).flat_map do |id|
        name = [section, id].compact.join(' ')
        next aspects(section, name, old[id], new[id]) if old.key?(id) && new.key?(id)

        # A new order is no news beside the new elements in it.
        next [] if section == 'order'

        new.key?(id) ? ["+ #{name}#{all(new[id])}"] : ["- #{name}#{all(old[id])}"]
      end
    end

    def aspects(section, name, old, new)
      (old.keys & new.keys).filter_map do |aspect|
        words = change(old[aspect], new[aspect])
        next unless words

        # Sizes and what holds for the whole chart speak for themselves.
        title = %w[chart size].include?(section) ? aspect : [name, aspect].compact.join(' ')
        "~ #{title}: #{words}"
      end
    end

    def change(old, new)
      case old
      when Facts::Sequence then reordered(old.names, new.names)
      when Array then unordered(old, new)
      else "#{old || 'none'} -> #{new || 'none'}" unless old == new
      end
    end

    # Only of those that both versions have.
    def reordered(old, new)
      before = old & new
      after = new & old
      "#{before.join(', ')} -> #{after.join(', ')}" unless before == after
    end

    def unordered(old, new)
      came = new - old
      went = old - new
      return "#{old.first} -> #{new.first}" if old.length == 1 && new.length == 1 && came.any?

      [*went.map { |name| "- #{name}" }, *came.map { |name| "+ #{name}" }].join(', ') unless came.empty? && went.empty?
    end

    def all(aspects)
      words = aspects.filter_map do |aspect, value|
        text = Array(value).join(' ')
        "#{aspect} #{text}" unless text.empty?
      end
      words.empty? ? '' : ": #{words.join(', ')}"
    end
  end
end
