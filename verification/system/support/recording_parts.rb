# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'digest'

# The blocks of a recording, and recordings made of them. A system test includes it.
module RecordingParts
  HEADER = 256
  RUN = 136
  FIELDS = 28
  PREFIX = 64
  CHUNK = 1024
  TRAILER = 0x4E455342
  RUN_END = 0x45525342

  # Blocks and trailer: fields, and what stands behind the hash.
  def parts_of(bytes)
    parts = []
    at = HEADER
    while at < bytes.bytesize
      size = bytes[at + 20, 4].unpack1('V')
      rest = bytes[at + PREFIX, (size.fdiv(CHUNK).ceil * 4) + size]
      parts << [bytes[at, FIELDS], rest]
      at += PREFIX + rest.bytesize
    end
    parts
  end

  # The first cycle of a block; the last one of all of a trailer.
  def cycle_of(part)
    part.first[8, 4].unpack1('V')
  end

  # A recording of such parts, numbered anew.
  def joined(header, parts)
    text = header.dup
    before = text[-32..]
    parts.each_with_index do |(fields, rest), index|
      fields = fields.dup
      fields[4, 4] = [index].pack('V')
      text += block = sealed(before, fields, rest)
      before = block[32, 32]
    end
    text
  end

  def trailer(magic, last_cycle)
    [[magic, 0, last_cycle, 0, 0, 0, 0].pack('V7'), '']
  end

  # A header with other bytes at `place`.
  def changed_header(header, place, bytes)
    header = header.dup
    header[place, bytes.bytesize] = bytes
    header[224, 32] = Digest::SHA256.digest(header[0, 224])
    header
  end
end
