# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../model'

module Chart
  # The tree of states: ids, kinds, order, what each one declares. Transitions and content come later.
  class States
    STATES = %w[state parallel final history].freeze
    KINDS = { 'parallel' => :parallel, 'final' => :final, 'history' => :history }.freeze

    # More are refused at once, before anything is made of them.
    MOST = 400

    attr_reader :root, :all

    def initialize(context, chart)
      @context = context
      @all = []
      @of = {}.compare_by_identity
      @root = State.new(id: nil, kind: :root, order: -1, line: chart.line, comment: chart.comment, **empty)
      @of[chart] = @root
      add_children(chart, @root)
    end

    # The state that an element declares.
    def of(element)
      @of.fetch(element)
    end

    # Element => state of the root and all states, in document order.
    def by_element
      @of
    end

    def find(id)
      @by_id ||= @all.to_h { |state| [state.id, state] }
      @by_id[id]
    end

    def ids
      @all.map(&:id)
    end

    private

    def empty
      { children: [], transitions: [], entry: [], exit: [], req: [], hazards: [], ignores: [] }
    end

    def add_children(element, parent)
      element.children.each do |child|
        parent.children << read(child, parent) if STATES.include?(child.name)
      end
    end

    def read(element, parent)
      state = State.new(**empty, id: id_of(element), kind: kind_of(element), parent: parent, line: element.line,
                                 order: @all.length, comment: element.comment)
      @all << state
      refuse_size(element.line) if @all.length > MOST
      @of[element] = state
      declare(element, state)
      add_children(element, state)
      check_regions(state)
      state
    end

    def refuse_size(line)
      @context.refuse(line, 19, "more than #{MOST} states; split the chart")
    end

    def check_regions(state)
      return unless state.parallel? && state.substates.empty?

      @context.refuse(state.line, 2, "parallel \"#{state.id}\" has no regions; write <state> inside it")
    end

    def declare(element, state)
      state.req = @context.claims(element, 'bs:req')
      state.hazards = @context.claims(element, 'bs:hazard')
      state.ignores = element.attributes.fetch('bs:ignores', '').split
      state.depth = element.attributes.fetch('type', 'shallow').to_sym if state.history?
      return if @context.lenient? || !state.leaf? || state.req.any?

      @context.refuse(element.line, 9, "state \"#{state.id}\" names no requirement; add bs:req=\"SWR-...\"")
    end

    # Conformance charts need not name every state.
    def id_of(element)
      id = element.attributes.fetch('id') { return @context.unnamed(element, @all.length) }
      @context.name(id, element.line)
    end

    def kind_of(element)
      KINDS.fetch(element.name) do
        element.children.any? { |child| STATES.include?(child.name) } ? :compound : :atomic
      end
    end
  end
end
