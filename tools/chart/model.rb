# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

module Chart
  # The parsed chart: a tree of states. The interpreter and the C emitter share this and nothing else.
  State = Struct.new(:id, :kind, :parent, :children, :initial, :transitions, :timers, :req, :line,
                     :order, :comment, keyword_init: true) do
    # Ancestors, innermost first, without the state itself.
    def ancestors
      parent ? [parent] + parent.ancestors : []
    end

    def leaf?
      kind == :leaf
    end

    def leaves
      leaf? ? [self] : children.flat_map(&:leaves)
    end

    def inside?(other)
      ancestors.include?(other)
    end

    def inspect
      "#<State #{id}>"
    end

    def hash
      id.hash
    end

    def eql?(other)
      equal?(other)
    end

    def ==(other)
      equal?(other)
    end
  end

  Transition = Struct.new(:id, :number, :source, :event, :guard, :guard_text, :target, :internal,
                          :actions, :raises, :req, :line, keyword_init: true) do
    def inspect
      "#<Transition #{id}>"
    end
  end

  Timer = Struct.new(:id, :event, :delay_us, :limit, :state, :line, keyword_init: true)
  Input = Struct.new(:name, :comment, :line, keyword_init: true)
  Invariant = Struct.new(:id, :req, :expression, :text, :line, keyword_init: true)

  # A region is what one enum in C holds: the whole chart, or one child of the root parallel.
  Region = Struct.new(:name, :state) do
    def leaves
      state.leaves
    end
  end

  # One chart file.
  Document = Struct.new(:name, :file, :comment, :root, :states, :transitions, :timers, :inputs,
                        :invariants, :safe, :internal_events, keyword_init: true) do
    def regions
      @regions ||= if root.initial.kind == :parallel
                     root.initial.children.map { |child| Region.new(child.id, child) }
                   else
                     [Region.new('state', root)]
                   end
    end

    def leaves
      states.select(&:leaf?)
    end

    # Compound states other than regions, the ones worth asking for by name.
    def compounds
      states.select { |state| state.kind == :compound } - regions.map(&:state)
    end

    def region_of(state)
      regions.find { |region| region.state == state || state.inside?(region.state) }
    end

    def state(id)
      states.find { |state| state.id == id }
    end

    def events
      transitions.map(&:event).uniq
    end

    def actions
      transitions.flat_map(&:actions).uniq
    end

    def raises?
      transitions.any? { |transition| transition.raises.any? }
    end

    def inspect
      "#<Document #{name}>"
    end
  end
end
