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
        outcome = Outcome.new('select', Result.new('uint32_t'), true, 'self', [], found)
        selects = @order.to_h do |region|
          [region, @parts.selection.define(@code, region, eventless, outcome)]
        end
        taking = @order.select { |region| selects[region] }
        return @code.define('void', name, []) if taking.empty?

        late = taking.select { |region| late?(region, eventless) }
        @code.define('void', name, ['uint64_t touched = 0U;', *taking.map { |region| selected(region, selects) },
                                    *taking.map { |region| claimed(region) }, '',
                                    *late.flat_map { |region| placed(region, selects) },
                                    *stages(taking, acts(taking, late, selects))])
      end

      # --- the order of contents -------------------------------------------------------------------------------------
      # Without a target a transition excludes nothing, so that outer ones and inner ones may come together: an outer one
      # where the first leaf stands that asks outside.

      def late?(region, eventless)
        nested = @regions.with_nested(region).drop(1).map(&:state)
        mine, others = transitions.partition { |one| @regions.of(one.source) == region }
        others = others.select { |one| nested.any? { |state| one.source == state || one.source.inside?(state) } }
        mine.any? { |one| others.any? { |other| together?(one, other, eventless) } }
      end

      def together?(one, other, eventless)
        return false unless one.targetless? || other.targetless?

        eventless ? one.eventless? && other.eventless? : one.events.intersect?(other.events)
      end

      # [region, tests]: the regions inside whose leaf asks the outer region, and when.
      def asking(outer, selects)
        outer.leaves.select(&:parallel?).flat_map do |parallel|
          @regions.children(parallel).flat_map do |region|
            before = [at(outer, '==', parallel), *("(#{found(region)} == 0U)" if selects[region])]
            own = region.leaves.select(&:parallel?).map { |leaf| at(region, '!=', leaf) }
            [[region, before + own], *asking(region, selects).map { |one, tests| [one, before + tests] }]
          end
        end
      end

      def at(region, operator, leaf)
        "(self->#{@names.field(region.name)} #{operator} #{@names.leaf(leaf)})"
      end

      def place(region)
        @names.local('place', region)
      end

      def number(region)
        "#{@order.index(region) + 1}U"
      end

      def placed(outer, selects)
        rows = asking(outer, selects).each_with_index.flat_map do |(region, tests), index|
          [*Layout.at_operators("#{'} else ' if index.positive?}if (#{tests.join(' && ')}) {"),
           "    #{place(outer)} = #{number(region)};"]
        end
        ["uint32_t #{place(outer)} = 0U;", '', *rows, '} else {', '    /* nothing inside asks */', '}', '']
      end

      def acts(taking, late, selects)
        @order.flat_map do |region|
          own = taking.include?(region) ? [act(late.include?(region) ? in_place(region, '0U') : take(region))] : []
          own + late.select { |outer| asking(outer, selects).any? { |one, _tests| one == region } }
                    .map { |outer| act(in_place(outer, number(region))) }
        end
      end

      def act(transition)
        "#{@code.invoke('act', {}, transition)};"
      end

      def in_place(outer, number)
        "(#{place(outer)} == #{number}) ? #{take(outer)} : 0U"
      end

      def found(region)
        @names.local('found', region)
      end

      def selected(region, selects)
        call = @code.invoke(selects[region])
        inner = settled_inside(region, selects)
        "const uint32_t #{found(region)} = #{inner ? "(#{inner}) ? 0U : #{call}" : call};"
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
        own = selects[region] && "(#{found(region)} != 0U)"
        inner = settled_inside(region, selects)
        return own if inner.nil?

        own ? "(#{own} || (#{inner}))" : "(#{inner})"
      end

      def take(region)
        @names.local('take', region)
      end

      def claimed(region)
        "const uint32_t #{take(region)} = #{@names.function('claim')}(#{found(region)}, &touched);"
      end

      def stages(taking, acts)
        [*stage('leave', taking.reverse), *acts, *stage('arrive', taking)]
      end

      def stage(name, regions)
        return [] unless @code.defined?(name)

        regions.map { |region| "#{@code.invoke(name, {}, take(region))};" }
      end
    end
  end
end
