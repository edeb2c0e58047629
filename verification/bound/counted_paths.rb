# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative '../bench/counters'

# Edges that each counted cycle takes in the flow graphs, from the trace of the emulator.
class CountedPaths < ArmCounter
  # Of a cycle: times that an edge of a function is taken, calls of a function, instructions outside the graphs.
  Path = Struct.new(:edges, :calls, :outside)

  # graphs: by function, as CycleBound#graphs.
  def initialize(graphs)
    super()
    @owners = graphs.flat_map { |name, graph| graph.blocks.keys.map { |start| [start, [name, graph]] } }.to_h
    @ranges = graphs.values.flat_map { |graph| graph.blocks.values.map { |block| block.addresses } }.flatten.to_h { |at| [at, true] }
    @known = graphs.transform_values { |graph| graph.edges.to_h { |edge| [edge, true] } }
    @inside = {}
    @paths = []
  end

  def paths(samples, numbers)
    count(samples, numbers)
    @paths
  end

  private

  def translate(address)
    super
    @inside[@block] = [] if @block == address
    @inside[@block] << address.to_i(16)
  end

  def take(address)
    super
    while @paths.length < @counts.length
      @paths << Path.new(Hash.new(0), Hash.new(0), 0)
      @last = {}
    end
    @inside.fetch(address).each { |at| pass(at) } if @stage
  end

  def pass(at)
    @paths.last.outside += 1 unless @ranges.key?(at)
    name, graph = @owners[at]
    return unless name

    edge = [@last[name], at]
    if @known[name].key?(edge)
      @paths.last.edges[[name, edge]] += 1
    else
      raise BenchFailed, "#{name} goes a way that its graph lacks, to #{at.to_s(16)}" unless at == graph.entry

      @paths.last.calls[name] += 1
    end
    @last[name] = at
  end
end
