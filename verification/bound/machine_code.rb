# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'open3'

# Functions of a program in Thumb-2 code with debugging information, as objdump reads them.
class MachineCode
  # Code of a form that is not followed.
  class Unknown < StandardError; end

  # next: what may follow, an address of the same function, [:jump, name of another function] or :return.
  # calls: functions that it calls and that return to what follows. place: "file:line" of the source.
  Instruction = Struct.new(:address, :operation, :operands, :place, :next, :calls)

  OBJDUMP = 'arm-linux-gnueabihf-objdump'
  CONDITION = '(?:eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)'
  JUMP = /\A(?:b#{CONDITION}?|cbn?z)\z/
  SOMETIMES = /\A(?:b#{CONDITION}|cbn?z)\z/
  CALL = /\Ablx?#{CONDITION}?\z/
  # The first two end in the safe state; their cycle is not finished.
  NEVER_RETURN = %w[contract_broken __stack_chk_fail].freeze
  CODE = /^ +(\h+):\t(\S+)(?:\t([^;@]*))?/
  SOURCE = /^(?:\.\/)?(\S+\.[chS]):(\d+)/
  DATA = /\A\.(?:word|short|byte)\z/
  WIDTHS = { '.word' => 4, '.short' => 2, '.byte' => 1 }.freeze

  def self.of(program)
    text, status = Open3.capture2(OBJDUMP, '-d', '-l', '--no-show-raw-insn', program)
    raise Unknown, "#{OBJDUMP} cannot read #{program}" unless status.success?

    new(text)
  end

  def initialize(text)
    @functions = {}
    @linked = {}
    read(text)
    @names = @functions.to_h { |name, list| [list.first&.address, name] }
  end

  # Instructions of a function, with what follows each.
  def function(name)
    @linked[name] ||= link(name, @functions.fetch(name) { raise Unknown, "#{name} is no function of the program" })
  end

  # Number of the instructions of a function whose jumps all lead forward.
  def straight(name)
    list = @functions.fetch(name) { raise Unknown, "#{name} is no function of the program" }
    back = list.find { |one| one.operation.match?(JUMP) && target(one).first <= one.address && target(one).last == name }
    back ? raise(Unknown, "#{name} has a loop") : list.length
  end

  private

  def read(text)
    list = place = nil
    text.each_line do |line|
      if (found = line.match(/^\h+ <([^>]+)>:$/))
        list = @functions[place = found[1]] = []
      elsif list && (found = line.match(CODE))
        list << Instruction.new(found[1].to_i(16), found[2].sub(/\.[nw]\z/, ''), found[3].to_s.strip, place)
      elsif (found = line.match(SOURCE))
        place = "#{found[1]}:#{found[2]}"
      end
    end
  end

  def link(name, list)
    skipped = 0
    list.each_with_index do |one, index|
      next if one.operation.start_with?('.')

      after = list[index + 1]&.address
      one.calls = []
      one.next = follow(one, name, list, index) { after }
      one.next |= [after] if skipped.positive? || one.operation.match?(SOMETIMES)
      skipped = one.operation.match?(/\Ait[te]*\z/) ? one.operation.length - 1 : [skipped - 1, 0].max
    end
    list.select(&:next)
  end

  def follow(one, name, list, index)
    case one.operation
    when JUMP then [leap(one, name)]
    when CALL then call(one, name) { yield }
    when /\Atb[bh]\z/ then table(list, index, one.operation == 'tbb' ? 1 : 2)
    when /\Abx#{CONDITION}?\z/o then one.operands == 'lr' ? [:return] : computed(one, name)
    when /\A(?:pop|ldm)/ then one.operands.match?(/\bpc\b/) ? [:return] : [yield]
    when /\Aldr/ then load(one, list, index) { yield }
    when /\A(?:cmp|cmn|tst|str|push|vstr)/ then [yield]
    else one.operands.start_with?('pc,') ? computed(one, name) : [yield]
    end
  end

  # Nothing follows a call that does not return.
  def call(one, name)
    one.calls << callee(one, name)
    NEVER_RETURN.include?(one.calls.last) ? [] : [yield]
  end

  def computed(one, name)
    raise Unknown, "#{name} computes where it goes at #{one.place}: #{one.operation} #{one.operands}"
  end

  def load(one, list, index)
    return [yield] unless one.operands.start_with?('pc,')

    one.operands.start_with?('pc, [sp]') ? [:return] : table(list, index, 4)
  end

  def target(one)
    [one.operands[/(\h+) <[^>]*>\z/, 1].to_i(16), one.operands[/<([^+>]+)(?:\+0x\h+)?>\z/, 1]]
  end

  def leap(one, name)
    address, function = target(one)
    return address if function == name

    @names[address] == function || imported?(one) or computed(one, name)
    [:jump, imported?(one) ? :library : function]
  end

  # A stub of the linker, before a function of the C library that is chosen when the program starts.
  def imported?(one)
    one.operands.match?(/<_init\+/)
  end

  def callee(one, name)
    return :library if imported?(one)

    one.operands[/<([^+>]+)>\z/, 1] || computed(one, name)
  end

  # Addresses in the table behind a jump; one of bytes may be filled up by a zero.
  def table(list, index, size)
    bytes = list.drop(index + 1).drop_while { |one| one.operation == 'nop' }.take_while { |one| one.operation.match?(DATA) }
                .flat_map { |one| split(one) }
    entries = bytes.each_slice(size).map { |slice| slice.each_with_index.sum { |byte, place| byte << (8 * place) } }
    entries.pop if size == 1 && entries.last.zero?
    base = list[index].address + 4
    entries.map { |entry| size == 4 ? entry & ~1 : base + (2 * entry) }.uniq
  end

  def split(one)
    value = one.operands.to_i(16)
    Array.new(WIDTHS.fetch(one.operation)) { |place| (value >> (8 * place)) & 0xFF }
  end
end
