# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

module Chart
  # Sets of names as integers, one bit a name, in the order given.
  class Bits
    def initialize(names)
      @names = names
      @bits = names.each_with_index.to_h { |name, index| [name, 1 << index] }
      @lists = {}
    end

    def bit(name)
      @bits.fetch(name)
    end

    def set(names)
      names.reduce(0) { |set, name| set | bit(name) }
    end

    # In the order given at the beginning; the same frozen list for the same set.
    def names(set)
      @lists[set] ||= @names.select { |name| set.anybits?(bit(name)) }.freeze
    end
  end
end
