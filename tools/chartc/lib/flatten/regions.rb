# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

module Chart
  # A region is what one enum in C holds: a part of the tree in which exactly one leaf is active at a time. It
  # ends at atomic and final states and at parallels; each child of a parallel begins a region of its own.
  # outer: the parallel it lies in, nil for the region of the chart itself.
  Region = Struct.new(:name, :state, :leaves, :outer) do
    def inspect
      "#<Region #{name}>"
    end
  end

  # One field that a history needs: the leaf of one region, as it was when the history was recorded.
  Memory = Struct.new(:history, :region)

  # The regions of a document, outer ones before those inside, in document order.
  class Regions
    include Enumerable

    def self.of(document)
      new(document).to_a
    end

    def initialize(document)
      @document = document
      @regions = []
      @of = {}
      root = document.root
      lone_parallel?(root) ? add_inside(root.substates.first) : add('state', root, nil)
      @regions.freeze
    end

    def each(&block)
      @regions.each(&block)
    end

    # The region whose enum states whether the state is active; nil for a lone parallel and the root above it, which
    # are always active.
    def of(state)
      @of[state]
    end

    # Regions that begin at the children of a parallel.
    def children(parallel)
      parallel.substates.map { |child| @of[child] }
    end

    # The region and all regions nested in its leaves.
    def with_nested(region)
      inner = region.leaves.select(&:parallel?).flat_map { |leaf| children(leaf) }
      [region] + inner.flat_map { |one| with_nested(one) }
    end

    # Inner regions before the one they are nested in, siblings in document order.
    def inner_first
      outermost = @regions.select { |region| region.outer.nil? || of(region.outer).nil? }
      outermost.flat_map { |region| post_order(region) }
    end

    def always_active?(region)
      return true if region.outer.nil?

      outer = of(region.outer)
      outer.nil? || (outer.leaves.length == 1 && always_active?(outer))
    end

    # Leaving the region makes it "none" until it is entered: when it can be inactive, or when the end of its parallel
    # depends on it.
    def vanishes?(region)
      !always_active?(region) || (region.outer && @document.events.include?("done.state.#{region.outer.id}"))
    end

    # A region needs the value "none" when it vanishes, or when a history must say "never recorded".
    def none?(region)
      vanishes?(region) || memories.any? { |memory| memory.region == region }
    end

    # What the histories of the document remember.
    def memories
      @memories ||= @document.histories.flat_map { |history| memories_of(history) }
    end

    # A shallow history remembers the region of its parent; a deep one also those nested in it.
    def memories_of(history)
      parent = history.parent
      found = parent.parallel? ? children(parent) : [of(parent)]
      found = found.flat_map { |region| nested_in(region, parent) } if history.depth == :deep
      found.map { |region| Memory.new(history, region) }
    end

    private

    def lone_parallel?(root)
      root.substates.length == 1 && root.substates.first.parallel? && root.substates.first.transitions.empty?
    end

    def nested_in(region, state)
      leaves = region.leaves.select { |leaf| leaf.parallel? && (leaf == state || leaf.inside?(state)) }
      [region] + leaves.flat_map { |leaf| children(leaf) }.flat_map { |one| nested_in(one, state) }
    end

    def add(name, state, outer)
      region = Region.new(name, state, [], outer)
      @regions << region
      @of[state] = region
      collect(state, region)
      region
    end

    def collect(state, region)
      @of[state] = region
      if state.leaf? || state.parallel?
        region.leaves << state
        add_inside(state) if state.parallel?
      else
        state.substates.each { |child| collect(child, region) }
      end
    end

    def add_inside(parallel)
      parallel.substates.each { |child| add(child.id, child, parallel) }
    end

    def post_order(region)
      inner = region.leaves.select(&:parallel?).flat_map { |leaf| children(leaf) }
      inner.flat_map { |one| post_order(one) } + [region]
    end
  end
end
