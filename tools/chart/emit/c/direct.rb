# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'selection'

module Chart
  module C
    # Each region takes its transition at once. Guards that read other regions read them as they were before the step.
    class Direct
      def initialize(parts, code)
        @parts = parts
        @code = code
        @names = parts.names
      end

      def define
        @parts.document.transitions.each { |transition| define_transition(transition) }
        @step = define_step(false)
        @rest = @parts.decisions.eventless? ? define_step(true) : nil
      end

      def call(event)
        "#{@code.invoke(@step, 'event' => event)};"
      end

      def call_at_rest
        @rest && "#{@code.invoke(@rest)};"
      end

      # The structure of what guards read of other regions and of the data.
      def types
        return [] if read_fields.empty? || !snapshot?

        ['typedef struct {', read_fields.map { |type, field| "    #{type} #{field};" },
         "} #{@names.function('before_t')};", '']
      end

      private

      def take(transition)
        "take_#{@names.stem_of(transition.id)}"
      end

      def define_transition(transition)
        sequences = @parts.sequences
        steps = sequences.exits(transition) + transition.content + sequences.entries(transition)
        @code.define('void', take(transition), [@parts.trace(transition), *@parts.steps.lines(steps)],
                     comment: Layout.comment(@parts.about(transition)))
      end

      # One region needs no picture of the others.
      def snapshot?
        @parts.regions.to_a.length > 1
      end

      def read_fields
        @read_fields ||= atoms_read.flat_map { |atom| fields(atom) }.uniq
      end

      def atoms_read
        guards = @parts.document.transitions.filter_map(&:guard)
        guards.flat_map { |guard| Expression.atoms(guard) }.uniq
      end

      def fields(atom)
        kind, name = atom
        return variable_field(name) if kind == :variable

        region = @parts.regions.of(@parts.document.state(name))
        region ? [[@names.region_type(region), @names.field(region.name)]] : []
      end

      def variable_field(name)
        variable = @parts.document.data.find { |one| one.name == name }
        variable ? [[@names.variable_type(variable), @names.field(name)]] : []
      end

      def define_step(eventless)
        outcome = Outcome.new('step', Result.new('void'), false,
                              ->(transition) { "#{@code.invoke(take(transition))};" })
        holder = snapshot? ? 'before' : 'self'
        steps = @parts.regions.filter_map do |region|
          @parts.selection.define(@code, region, eventless, holder, outcome)
        end
        combine(eventless ? 'microstep_at_rest' : 'microstep', steps)
      end

      def combine(name, steps)
        picture = steps.any? { |step| @code.needs?(step, 'before') }
        calls = steps.map { |step| "#{@code.invoke(step, 'before' => '&before_step')};" }
        @code.define('void', name, picture ? [*picture_lines, '', *calls] : calls)
        name
      end

      def picture_lines
        ["const #{@names.function('before_t')} before_step = {",
         read_fields.map { |_type, field| "    .#{field} = self->#{field}," }, '};'].flatten
      end
    end
  end
end
