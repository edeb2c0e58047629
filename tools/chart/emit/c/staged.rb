# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'selection'

module Chart
  module C
    # Selects in all regions, inner ones first, resolves conflicts, then runs all exits, all content, all entries.
    # Nothing changes while guards are read. A transition inside wins over one outside, an earlier region over a later.
    class Staged
      def initialize(parts, code)
        @parts = parts
        @code = code
        @names = parts.names
        @regions = parts.regions
        @order = parts.regions.inner_first
      end

      def types
        []
      end

      def define
        define_claim
        define_stage('leave') { |transition| @parts.sequences.exits(transition) }
        define_stage('act', &:content)
        define_stage('arrive') { |transition| @parts.sequences.entries(transition) }
        define_step('microstep', false)
        define_step('microstep_at_rest', true) if @parts.decisions.eventless?
      end

      # What follows is what Direct has.
      def sorts?
        false
      end

      def step(event, _events, run = 'run')
        ["#{@code.invoke('microstep', 'event' => event, 'run' => run)};"]
      end

      def step_from_outside(run)
        step('event', @parts.outside_events, run)
      end

      def step_at_rest
        @parts.decisions.eventless? ? ["#{@code.invoke('microstep_at_rest')};"] : []
      end

      private

      def transitions
        @parts.document.transitions
      end

      # The regions that a transition changes, as a bit mask.
      def mask(transition)
        bits = @parts.sequences.reach(transition).sum { |region| 1 << @regions.to_a.index(region) }
        format('0x%XULL', bits)
      end

      # A selected transition is dropped if one selected before changes a region that it would change.
      def define_claim
        rows = transitions.reject(&:targetless?).map do |transition|
          ["case #{transition.number}U:", "    reach = #{mask(transition)};", '    break;']
        end
        reach = rows.empty? ? ['const uint64_t reach = 0U;'] : ['uint64_t reach = 0U;', '', *switch('transition', rows)]
        head = "static uint32_t #{@names.function('claim')}"
        @claim = [Layout.call(head, ['uint32_t transition', 'uint64_t *touched'], ''),
                  '{', '    uint32_t claimed = 0U;', reach.flatten.map { |line| line.empty? ? line : "    #{line}" },
                  '    if ((reach & *touched) == 0U) {', '        *touched |= reach;', '        claimed = transition;',
                  '    }', '    return claimed;', '}', '']
        @code.add('claim', @claim)
      end

      def switch(subject, rows)
        ["switch (#{subject}) {", *rows.flatten, 'default:', '    break;', '}']
      end

      # void NAME(self, run, transition): one case for each transition that does something at this stage.
      def define_stage(name)
        rows = transitions.filter_map do |transition|
          lines = @parts.steps.lines(yield(transition))
          lines.unshift(@parts.trace(transition)) if name == 'act'
          next if lines.empty?

          [Layout.comment(@parts.about(transition)), "case #{transition.number}U:",
           *lines.map { |line| "    #{line}" }, '    break;']
        end
        return if rows.empty?

        @code.define('void', name, switch('transition', rows), also: ['uint32_t transition'])
      end

      def define_step(name, eventless)
        found = ->(transition) { "found = #{transition.number}U;" }
        outcome = Outcome.new('select', Result.new('uint32_t'), true, 'self', found)
        selects = @order.to_h do |region|
          [region, @parts.selection.define(@code, region, eventless, outcome)]
        end
        taking = @order.select { |region| selects[region] }
        return @code.define('void', name, []) if taking.empty?

        @code.define('void', name, ['uint64_t touched = 0U;', *taking.map { |region| selected(region, selects) },
                                    *taking.map { |region| claimed(region) }, '', *stages(taking)])
      end

      def local(region)
        "in_#{@names.field(region.name)}"
      end

      def selected(region, selects)
        call = @code.invoke(selects[region])
        inner = settled_inside(region, selects)
        "const uint32_t found_#{local(region)} = #{inner ? "(#{inner}) ? 0U : #{call}" : call};"
      end

      # True when each region inside the active parallel has its own transition: then none outside is looked at.
      def settled_inside(region, selects)
        tests = region.leaves.select(&:parallel?).filter_map do |leaf|
          inner = @regions.children(leaf).map { |one| settled(one, selects) }
          next if inner.include?(nil)

          ["(self->#{@names.field(region.name)} == #{@names.leaf(leaf)})", *inner].join(' && ')
        end
        tests.empty? ? nil : tests.map { |test| tests.length == 1 ? test : "(#{test})" }.join(' || ')
      end

      # nil when the region can never have one.
      def settled(region, selects)
        own = selects[region] && "(found_#{local(region)} != 0U)"
        inner = settled_inside(region, selects)
        return own if inner.nil?

        own ? "(#{own} || (#{inner}))" : "(#{inner})"
      end

      def claimed(region)
        "const uint32_t take_#{local(region)} = #{@names.function('claim')}(found_#{local(region)}, &touched);"
      end

      def stages(taking)
        [['leave', taking.reverse], ['act', taking], ['arrive', taking]].flat_map do |stage, regions|
          next [] unless @code.defined?(stage)

          regions.map { |region| "#{@code.invoke(stage, {}, "take_#{local(region)}")};" }
        end
      end
    end
  end
end
