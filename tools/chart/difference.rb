# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'difference/facts'

module Chart
  # The difference in meaning of two versions of charts, as text: a line for each change, with + for what came,
  # - for what went and ~ for what is different. Layout, comments and line numbers do not count.
  # @satisfies SWR-CHART-006
  class Difference
    NONE = 'no difference in meaning'
    WORST = { 'x86_instructions' => 'x86-64 instructions', 'arm_instructions' => 'ARM instructions',
              'stack_bytes' => 'stack bytes', 'ram_bytes' => 'RAM bytes' }.freeze

    # Of two versions of one chart; the worst cases are contents of worst_case.yml, or nil.
    def self.between(old, new, old_worst = nil, new_worst = nil)
      lines = new(Facts.of(old), Facts.of(new)).lines + worst_lines(old, new, old_worst, new_worst)
      title = old.document.name
      title += " -> #{new.document.name}" unless title == new.document.name
      "#{lines.empty? ? "#{title}: #{NONE}" : [title, *lines.map { |line| "  #{line}" }].join("\n")}\n"
    end

    # Of two versions of a folder of charts.
    def self.of_folders(old_charts, new_charts, old_worst = nil, new_worst = nil)
      old, new = [old_charts, new_charts].map { |charts| charts.to_h { |chart| [chart.document.name, chart] } }
      (old.keys | new.keys).sort.map do |name|
        next "+ chart #{name}\n" unless old.key?(name)
        next "- chart #{name}\n" unless new.key?(name)

        between(old[name], new[name], old_worst, new_worst)
      end.join
    end

    def self.worst_lines(old, new, old_worst, new_worst)
      before = old_worst&.dig('charts', old.document.name)
      after = new_worst&.dig('charts', new.document.name)
      return [] unless before && after

      WORST.filter_map do |key, title|
        witness = after[key.sub('instructions', 'witness')] if key.end_with?('instructions')
        where = " (#{witness})" if witness
        "~ worst case #{title}: #{before[key]} -> #{after[key]}#{where}" unless before[key] == after[key]
      end
    end
    private_class_method :worst_lines

    def initialize(old, new)
      @old = old
      @new = new
    end

    def lines
      @old.keys.flat_map { |section| changes(section, @old.fetch(section), @new.fetch(section)) }
    end

    private

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
      old.keys.filter_map do |aspect|
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
