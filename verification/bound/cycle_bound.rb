# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'fileutils'
require 'open3'
require 'tmpdir'
require 'yaml'
require_relative 'flow_graph'

# Bounds of loops from a table; each entry has to be of use.
class LoopBounds
  class Refused < StandardError; end

  ROOT = File.expand_path('../..', __dir__)
  TABLE = File.join(__dir__, 'bounds.yml')
  HEAD = /\A(?:\} )?(?:for|while) \((.*)\)(?: \{|;)?\z/

  def initialize(table, values, root: ROOT)
    @table = table
    @values = values
    @root = root
    @used = {}
    @sources = {}
  end

  # Pairs of a loop and the most rounds for each time that it is entered. Parts of an inner loop may lie before it; a
  # head that is the only one of an inner loop is therefore not that of an outer one, if that has another. Where several
  # heads are left, one of them is that of this loop: the largest bound holds.
  def of_function(function, loops)
    sole = {}
    loops.sort_by { |loop| loop.blocks.size }.map do |loop|
      heads = loop.places.filter_map { |place| head(place) }.uniq
      inner = sole.select { |other, _head| other.blocks.proper_subset?(loop.blocks) }.values
      heads -= inner if (heads - inner).any?
      heads = named(function, heads) if heads.length > 1
      sole[loop] = heads.first if heads.one?
      [loop, heads.any? ? heads.map { |file, text| of_head(function, file, text) }.max : of_machine(function, loop)]
    end
  end

  # Entries that fit no loop.
  def idle
    @table.values_at('conditions', 'outer', 'machine').flatten.reject { |entry| @used[entry] }
  end

  private

  # The head that the table names as the outer one of several.
  def named(function, heads)
    entry = @table['outer'].find { |one| one['function'] == function && heads.any? { |head| head[1].include?(one['part']) } }
    return heads unless entry

    @used[entry] = true
    heads.select { |head| head[1].include?(entry['part']) }
  end

  def head(place)
    file, line = place.split(':')
    text = source(file)[line.to_i - 1].to_s.strip if line
    text&.match?(HEAD) ? [file, text[HEAD, 1], line] : nil
  end

  def source(file)
    path = File.expand_path(file, @root)
    @sources[file] ||= File.file?(path) ? File.readlines(path) : []
  end

  def of_head(function, file, text)
    parts = text.split(/;|&&/).map { |part| bare(part.strip.sub(/\A(?:u?int\d+_t|size_t) /, '')) }
    found = @table['conditions'].select { |entry| parts.include?(entry['part']) && fits?(entry, file) }
    raise Refused, "no bound of the loop (#{text}) of #{function}, #{file}" if found.empty?

    found.each { |entry| @used[entry] = true }.map { |entry| entry.key?('rows') ? rows(file, entry['rows']) : value(entry) }.min
  end

  # Without the parentheses around all of it.
  def bare(part)
    inner = part[/\A\((.*)\)\z/, 1]
    inner && inner.each_char.reduce(0) { |depth, c| depth.negative? ? depth : depth + { '(' => 1, ')' => -1 }.fetch(c, 0) }.zero? ? inner : part
  end

  def fits?(entry, file)
    entry['in'].nil? || File.basename(file) == entry['in']
  end

  def of_machine(function, loop)
    entry = @table['machine'].find { |one| loop.places.all? { |place| place.include?(one['place']) } }
    raise Refused, "no bound of the loop of #{function} at #{loop.places.first}" unless entry

    @used[entry] = true
    value(entry)
  end

  # The number of rows in an array of structures: the braces that open inside those of the array.
  def rows(file, array)
    body = source(file).join[/ #{array}\[\] = \{\n(.*?)^\};/m, 1] || raise(Refused, "no array #{array} in #{file}")
    depth = 0
    body.gsub(%r{/\*.*?\*/}m, '').scan(/[{}]/).count do |brace|
      depth += brace == '{' ? 1 : -1
      brace == '{' && depth == 1
    end
  end

  def value(entry)
    most = entry.fetch('most')
    most.is_a?(Integer) ? most : @values.fetch(most)
  end
end

# The most instructions of a call of a function with all that it calls: the longest path of the flow graphs as a linear
# program. Its variables count how often each edge is taken; those of whole numbers are among its solutions, so its
# optimum is never below the longest path.
#
# @satisfies SWR-COST-420
class CycleBound
  class Failed < StandardError; end

  # calls, own: by function, on the longest path: number of its calls, and instructions of its own.
  # graphs: of each function that is followed.
  attr_reader :most, :calls, :own, :graphs

  # library: name => instructions of a call whose code is not followed. never: pattern of functions that are not called.
  # at_most: name => number of calls in all.
  def initialize(code, start, bounds, library: {}, never: /\z./, at_most: {})
    @code = code
    @start = start
    @library = library
    @never = never
    @at_most = at_most
    @bounds = bounds
    @graphs = {}
    @loops = []
    follow
    refuse_recursion
    @rows = []
    @cost = Hash.new(0)
    @callers = Hash.new { |all, name| all[name] = [] }
    @variables = {}
    write
    solve
  end

  # Bounds and facts that a counted path (counted_paths.rb) breaks, one sentence each.
  def complaints(path)
    broken = @loops.select { |name, loop, most| rounds(path, name, loop.back) > most * entries(path, name, loop) }
    broken.map { |name, loop, most| "#{name}: more than #{most} rounds at #{loop.places.first}" } +
      @at_most.select { |name, most| path.calls[name] > most }.map { |name, most| "#{name}: more than #{most} calls" } +
      (path.outside > outside(path) ? ["#{path.outside} instructions of the library, not #{outside(path)}"] : [])
  end

  private

  def rounds(path, name, edges)
    edges.sum { |edge| path.edges[[name, edge]] }
  end

  def entries(path, name, loop)
    rounds(path, name, loop.enter) + (loop.blocks.include?(@graphs[name].entry) ? path.calls[name] : 0)
  end

  # Instructions that the library may need for the calls of the path.
  def outside(path)
    @graphs.sum do |name, graph|
      before = graph.edges.group_by(&:last)
      graph.blocks.values.sum do |block|
        cost = (block.calls + block.next.grep(Array).map(&:last)).sum { |callee| @library.fetch(callee.to_s, 0) }
        cost.zero? ? 0 : cost * (rounds(path, name, before.fetch(block.start, [])) + (block.start == graph.entry ? path.calls[name] : 0))
      end
    end
  end

  def follow
    queue = [@start]
    while (name = queue.pop)
      next if @graphs.key?(name) || outside?(name)

      @graphs[name] = graph = FlowGraph.new(@code.function(name))
      graph.blocks.each_value { |block| queue.concat(block.calls, block.next.grep(Array).map(&:last)) }
    end
  end

  def refuse_recursion
    called = @graphs.transform_values { |graph| graph.blocks.values.flat_map { |block| block.calls + block.next.grep(Array).map(&:last) } & @graphs.keys }
    part = TSort.strongly_connected_components(->(&each) { called.each_key(&each) }, ->(name, &each) { called[name].each(&each) })
                .find { |names| names.length > 1 || called[names.first].include?(names.first) }
    raise Failed, "#{part.join(', ')} calls itself" if part
  end

  def outside?(name)
    @library.key?(name.to_s) || MachineCode::NEVER_RETURN.include?(name) || name.to_s.match?(@never)
  end

  def variable(*key)
    @variables[key] ||= "x#{@variables.length}"
  end

  def write
    @graphs.each { |name, graph| write_function(name, graph) }
    names = [*@graphs.keys, *@callers.keys].uniq
    names.each { |name| write_entry(name) }
  end

  def write_function(name, graph)
    before = graph.edges.group_by(&:last)
    graph.blocks.each_value do |block|
      into = before.fetch(block.start, []).map { |edge| variable(name, *edge) }
      into << variable(:calls, name) if block.start == graph.entry
      out = block.next.map { |after| leave(name, block, after) }
      row(into, out, '= 0')
      into.each { |one| @cost[one] += block.size }
      block.calls.each { |callee| @callers[callee].concat(into) }
    end
    @bounds.of_function(name, graph.loops).each { |loop, most| write_loop(name, loop, most) }
  end

  def leave(name, block, after)
    one = variable(name, block.start, after)
    @callers[after.last] << one if after.is_a?(Array)
    one
  end

  def write_loop(name, loop, most)
    @loops << [name, loop, most]
    enter = loop.enter.map { |edge| variable(name, *edge) }
    enter << variable(:calls, name) if loop.blocks.include?(@graphs[name].entry)
    row(loop.back.map { |edge| variable(name, *edge) }, enter, '<= 0', most)
  end

  # Sum of the first, less so many times that of the others.
  def row(plus, minus, rest, times = 1)
    terms = Hash.new(0)
    plus.each { |one| terms[one] += 1 }
    minus.each { |one| terms[one] -= times }
    terms.reject! { |_one, factor| factor.zero? }
    @rows << "#{terms.map { |one, factor| format('%+d %s', factor, one) }.join("\n ")} #{rest}" if terms.any?
  end

  def write_entry(name)
    one = variable(:calls, name)
    row([one], @callers[name], "= #{name == @start ? 1 : 0}")
    @rows << "#{one} <= #{@at_most[name]}" if @at_most.key?(name)
    @rows << "#{one} = 0" if MachineCode::NEVER_RETURN.include?(name) || name.to_s.match?(@never)
    @cost[one] += @library.fetch(name.to_s, 0)
  end

  def solve
    Dir.mktmpdir do |folder|
      program = File.join(folder, 'program.lp')
      answer = File.join(folder, 'answer')
      File.write(program, text)
      said, = Open3.capture2e('glpsol', '--lp', program, '--write', answer)
      lines = File.file?(answer) ? File.readlines(answer) : []
      # Both the program and its dual have a feasible solution, so this is the optimum.
      raise Failed, "glpsol found no longest path: #{said.lines.last(4).join}" unless lines.grep(/^s bas \d+ \d+ f f /).one?

      take(lines)
    end
  end

  def text
    goal = @cost.map { |one, cost| "+ #{cost} #{one}" }.join("\n")
    ['Maximize', "cost: #{goal}", 'Subject To', *@rows.each_with_index.map { |row, i| "r#{i}: #{row}" },
     'End', ''].join("\n")
  end

  # "s bas ROWS COLUMNS f f OPTIMUM", then for each column "j NUMBER STATUS VALUE REDUCED", in the order of their first use.
  def take(lines)
    @most = lines.grep(/^s bas/).first.split.last.to_f.ceil
    values = lines.grep(/^j /).map { |line| line.split[3].to_f }
    value = text.scan(/\bx\d+\b/).uniq.zip(values).to_h
    @calls = [*@graphs.keys, *@callers.keys].uniq.to_h { |name| [name, value[variable(:calls, name)].to_f.round] }
    @own = @variables.group_by { |key, _one| key.first == :calls ? key.last : key.first }
                     .transform_values { |list| list.sum { |_key, one| @cost.fetch(one, 0) * value[one].to_f }.round }
  end
end
