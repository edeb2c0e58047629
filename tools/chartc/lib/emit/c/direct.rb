# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'selection'

module Chart
  module C
    # An event moves the regions that wait for it, and each takes its transition at once. Guards read the regions as they
    # were before the step, and so does a region that an earlier one may have moved.
    class Direct
      def initialize(parts, code)
        @parts = parts
        @code = code
        @names = parts.names
      end

      def define
        @parts.document.transitions.each { |transition| define_transition(transition) }
        @steps = define_steps(false)
        @steps_at_rest = define_steps(true)
      end

      # The step for an event, `name` in C, that is one of `events`; `run` is what gathers. Only the regions move that
      # wait for one of them.
      def step(name, events, run = 'run')
        together(@steps.slice(*waiting(events)), 'event' => name, 'run' => run)
      end

      def step_from_outside(run)
        return step('event', @parts.outside_events, run) unless sorts?

        @code.define('void', 'microstep', sorting,
                     comment: Layout.comment('An event moves only the regions that wait for it.'))
        ["#{@code.invoke('microstep', 'run' => run)};"]
      end

      def step_at_rest
        together(@steps_at_rest)
      end

      # True when regions wait for different events; then those that are not for the outside are distinguished as well.
      def sorts?
        groups.length > 1
      end

      # The structure of what guards read of other regions and of the data.
      def types
        return [] if read_fields.empty? || !snapshot?

        ['typedef struct {', read_fields.map { |type, field| "    #{type} #{field};" },
         "} #{@names.function('before_t')};", '']
      end

      private

      def take(transition)
        "take.#{transition.id}"
      end

      def define_transition(transition)
        sequences = @parts.sequences
        steps = sequences.exits(transition) + transition.content + sequences.entries(transition)
        @code.define('void', take(transition), [@parts.trace(transition), *@parts.steps.lines(steps)],
                     comment: Layout.comment(@parts.about(transition)))
      end

      def waiting(events)
        @parts.decisions.waiting(events)
      end

      # Regions => the events from outside that just these wait for.
      def groups
        @groups ||= @parts.outside_events.group_by { |event| waiting([event]) }.reject { |regions, _| regions.empty? }
      end

      # A chart of one region has no others to read.
      def snapshot?
        @parts.regions.to_a.length > 1
      end

      def read_fields
        @read_fields ||= (atoms_read.flat_map { |atom| fields(atom) } + pictured.map { |one| region_field(one) }).uniq
      end

      def pictured
        @pictured ||= @parts.shape.moved_by_others
      end

      def region_field(region)
        [@names.region_type(region), @names.field(region.name)]
      end

      def atoms_read
        guards = @parts.document.transitions.filter_map(&:guard)
        guards.flat_map { |guard| Expression.atoms(guard) }.uniq
      end

      def fields(atom)
        kind, name = atom
        return variable_field(name) if kind == :variable

        region = @parts.regions.of(@parts.document.state(name))
        region ? [region_field(region)] : []
      end

      def variable_field(name)
        variable = @parts.document.data.find { |one| one.name == name }
        variable ? [[@names.variable_type(variable), @names.field(name)]] : []
      end

      # Region => its function, for those that have something to take.
      def define_steps(eventless)
        holder = snapshot? ? 'before' : 'self'
        outcome = Outcome.new('step', Result.new('void'), false, holder, pictured,
                              ->(transition) { "#{@code.invoke(take(transition))};" })
        steps = @parts.regions.to_h do |region|
          [region, @parts.selection.define(@code, region, eventless, outcome, sorts? ? sent_to(region) : nil)]
        end
        steps.compact
      end

      # The events that a region's function is called for where they are sorted: its own, and with its raised ones those
      # that other regions wait for.
      def sent_to(region)
        [@parts.raised_events, *@parts.document.events.map { |event| [event] }]
          .select { |events| waiting(events).include?(region) }.flatten.uniq
      end

      # Calls of the regions' functions. Guards of all of them read one picture.
      def together(steps, replace = {})
        functions = steps.values
        return calls(functions, replace) unless functions.any? { |function| @code.needs?(function, 'before') }

        name = "microstep_of.#{functions.map { |function| function.delete_prefix('step.') }.join('.and.')}"
        define_with_picture(name, functions) unless @code.defined?(name)
        calls([name], replace)
      end

      def calls(functions, replace)
        functions.map { |function| "#{@code.invoke(function, replace)};" }
      end

      def define_with_picture(name, functions)
        @code.define('void', name, [*picture_lines, '', *calls(functions, 'before' => '&before_step')])
      end

      # One switch: which regions an event is for.
      def sorting
        cases = groups.map { |regions, events| [labels(events), branch(step('event', events)), '    break;'] }
        others = @parts.document.events - groups.values.flatten
        ['switch (event) {', cases, labels(others), 'default:', '    /* nothing waits for it from outside */',
         '    break;', '}']
      end

      def labels(events)
        events.map { |event| "case #{@names.event(event)}:" }
      end

      def branch(lines)
        lines.map { |line| "    #{line}" }
      end

      def picture_lines
        ["const #{@names.function('before_t')} before_step = {",
         read_fields.map { |_type, field| "    .#{field} = self->#{field}," }, '};'].flatten
      end
    end
  end
end
