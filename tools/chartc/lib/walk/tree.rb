# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../model'
require_relative 'bits'

module Chart
  # The states of a document as bits, and what of the tree the interpreter needs in every step. A configuration is
  # the set of all active states but the root.
  class Tree
    def initialize(document)
      @states = document.states.reject(&:history?)
      @bits = Bits.new(@states.map(&:id))
      @leaves = @bits.set(@states.select(&:leaf?).map(&:id))
      @with_ancestors = @states.to_h { |state| [state.id, @bits.set([state, *state.ancestors[0..-2]].map(&:id))] }
      @inside = [document.root, *@states].to_h { |state| [state.id, descendants(state)] }
      @lists = {}
    end

    def bit(id)
      @bits.bit(id)
    end

    # The configuration with these leaves.
    def configuration(leaves)
      leaves.reduce(0) { |set, id| set | @with_ancestors.fetch(id) }
    end

    def inside(state)
      @inside.fetch(state.id)
    end

    def leaves(configuration)
      @bits.names(configuration & @leaves)
    end

    def ids(set)
      @bits.names(set)
    end

    # In document order.
    def states(set)
      @lists[set] ||= @states.select { |state| set.anybits?(bit(state.id)) }.freeze
    end

    def children(state)
      @bits.set(state.substates.map(&:id))
    end

    private

    def descendants(state)
      @bits.set(@states.select { |one| one.inside?(state) }.map(&:id))
    end
  end
end
