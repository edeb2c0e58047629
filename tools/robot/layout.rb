# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

module Robot
  # A structure of core/robot/robot.h as bytes, for the seals that are compiled into the table.
  class Layout
    HEADERS = %w[card/card robot/robot].map { |name| File.expand_path("../../core//#{name}.h", __dir__) }.freeze
    FORMATS = { 'char' => 'C', 'uint8_t' => 'C', 'uint16_t' => 'S<', 'int32_t' => 'l<', 'uint32_t' => 'L<', 'int64_t' => 'q<' }.freeze
    SIZES = { 'char' => 1, 'uint8_t' => 1, 'uint16_t' => 2, 'int32_t' => 4, 'uint32_t' => 4, 'int64_t' => 8 }.freeze
    START = 0x5EA1ED00 # SEAL_START of core/base/seal.h

    def self.header
      @header ||= HEADERS.map { |path| File.read(path) }.join.gsub(%r{/\*.*?\*/}m, '')
    end

    # The fields of structure `name`: [type, name, length of the array or nil].
    def self.fields(name)
      body = header[/typedef struct \{([^}]*)\}\s*#{name};/, 1]
      body.scan(/(\w+)\s+(\w+)(?:\[(\w+)\])?;/)
    end

    # The bytes of structure `name` up to its field `seal`; `values`: what is written for each field in C.
    def self.bytes(name, values)
      fields(name).take_while { |_, field, _| field != 'seal' }.inject(''.b) do |bytes, (type, field, length)|
        value = values.fetch(field)
        next bytes + structures(type, value, length) unless SIZES.key?(type)
        raise "#{name} has padding before #{field}" unless (bytes.size % SIZES.fetch(type)).zero?

        bytes + packed(type, value, length)
      end
    end

    # `value`: one structure as a hash, or an array of structures that is filled up with zeros.
    def self.structures(type, value, length)
      return bytes(type, value) unless length

      each = fields(type).sum { |field_type, _, count| SIZES.fetch(field_type) * number(count || 1) }
      value.inject(''.b) { |bytes, one| bytes + bytes(type, one) }.ljust(each * number(length), "\0")
    end

    def self.packed(type, value, length)
      return [value.delete('"')].pack("a#{length}") if type == 'char'

      bytes = Array(value).map { |one| [number(one)].pack(FORMATS.fetch(type)) }.join
      bytes.ljust(SIZES.fetch(type) * number(length || 1), "\0")
    end

    # 12, "12U", "0x1AU", "INT64_C(12)", "(uint8_t)NAME", or the name of a constant.
    def self.number(value)
      text = value.to_s.sub(/\A\(\w+\)/, '').delete_prefix('INT64_C(').delete_suffix(')').delete_suffix('U')
      Integer(text, exception: false) || Integer(header[/\b#{text}(?: = | )(\d+)/, 1])
    end

    # As seal_of() of core/base/seal.h.
    def self.seal(name, values)
      bytes(name, values).unpack('L<*').inject(START) do |seal, word|
        (((seal << 5) | (seal >> 27)) + word) & 0xFFFFFFFF
      end
    end
  end
end
