# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'set'
require 'tsort'
require_relative 'machine_code'

# Blocks of a function and its loops.
class FlowGraph
  # calls: functions called in it. next: as MachineCode has it. places: lines of its source.
  Block = Struct.new(:start, :addresses, :next, :calls, :places) do
    def size
      addresses.length
    end
  end
  # back: edges within it that lead to where it is entered; enter: edges that enter it; places: lines of what belongs
  # to it and to no loop within it.
  Loop = Struct.new(:back, :enter, :places, :blocks)

  attr_reader :entry, :blocks, :loops

  def initialize(code)
    @entry = code.first.address
    @blocks = reachable(split(code))
    @loops = []
    find_loops(@blocks.keys, edges)
  end

  # Pairs of a block and what follows it, within the function.
  def edges
    @edges ||= @blocks.values.flat_map { |block| inner(block).map { |after| [block.start, after] } }
  end

  private

  def inner(block)
    block.next.grep(Integer)
  end

  def split(code)
    heads = code.each_cons(2).flat_map { |one, after| one.next == [after.address] ? [] : [after.address, *one.next] }
    heads = [@entry, *heads, *code.last.next].to_set
    code.slice_before { |one| heads.include?(one.address) }.to_h do |list|
      [list.first.address, Block.new(list.first.address, list.map(&:address), list.last.next, list.flat_map(&:calls), list.map(&:place).uniq)]
    end
  end

  def reachable(blocks)
    seen = { @entry => blocks.fetch(@entry) }
    queue = [@entry]
    while (at = queue.pop)
      inner(blocks.fetch(at)).each do |after|
        queue << after unless seen.key?(after)
        seen[after] = blocks.fetch(after) { raise MachineCode::Unknown, "#{blocks[at].places.last} leads out of its code" }
      end
    end
    seen
  end

  # A loop is a strongly connected part; without the edges back to where it is entered, those within it appear. A
  # circuit passes a place of entry of some such part, whether the loop has one such place or several.
  def find_loops(nodes, edges)
    followers = edges.group_by(&:first).transform_values { |list| list.map(&:last) }
    TSort.strongly_connected_components(->(&each) { nodes.each(&each) }, ->(at, &each) { followers.fetch(at, []).each(&each) })
         .each { |part| add_loop(part.to_set, edges) }
  end

  def add_loop(part, edges)
    within = edges.select { |from, to| part.include?(from) && part.include?(to) }
    return if within.empty?

    enter = self.edges.select { |from, to| !part.include?(from) && part.include?(to) }
    # Inside another loop, an edge that was taken away leads to an entry as well.
    taken = (self.edges - edges).select { |_from, to| part.include?(to) }
    entries = (enter + taken).map(&:last).to_set
    entries << @entry if part.include?(@entry)
    back = within.select { |_from, to| entries.include?(to) }
    found = Loop.new(back, enter | taken, nil, part)
    @loops << found
    find_loops(part.to_a, within - back)
    inner = @loops.select { |other| other.blocks.proper_subset?(part) }.flat_map { |other| other.blocks.to_a }
    found.places = (part.to_a - inner).flat_map { |at| @blocks[at].places }.uniq
  end
end
