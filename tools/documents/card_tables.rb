# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Tables of the frames for a vendor of cards, read from the C that speaks them: words and bits of the headers of
# core/card, frames and conversation that the unit tests try.
#
# @satisfies SWR-CARD-008
class CardTables
  VECTORS = 'verification/unit/support/card_vectors.h'
  # A field of a word in a comment: its bits, its name, what it says; its values.
  FIELD = /\A(?<bits>\d+(?:\.\.\d+)?) (?<name>\w+): (?<says>.*?); (?<values>.*)\.\z/
  # Inside of a comment of C.
  INSIDE = '(?:(?!\*/).)*?'
  BEGINNING = /\A\d+(?:\.\.\d+)? \w+: /
  WORDS_IN_A_LINE = 8
  NAMES = {
    'card_command_words' => [:words, 'COMMAND'],
    'card_report_words' => [:words, 'REPORT'],
    'card_drive_mode' => [:enumeration, 'CARD_DRIVE_'],
    'card_type' => [:enumeration, 'CARD_TYPE_'],
    'card_system' => [:bits, 'CARD_SYSTEM_'],
    'card_control' => [:bits, 'CARD_CONTROL_'],
    'card_status' => [:bits, 'CARD_STATUS_'],
    'card_limit' => [:bits, 'CARD_LIMIT_'],
    'card_vectors' => [:vectors],
    'card_conversation' => [:conversation]
  }.freeze

  # `limits`: those of the requirements, by name.
  def initialize(root, limits)
    @root = root
    @limits = limits
  end

  # Lines of the table, nil when nothing has this name. `markdown` makes lines of heads and rows.
  def table(name, markdown)
    kind, prefix = NAMES[name]
    kind && send(kind, *prefix, markdown)
  end

  private

  def read(file)
    File.read(File.join(@root, file), encoding: 'UTF-8')
  end

  def headers
    @headers ||= %w[card card_frame].map { |name| read("core/card/#{name}.h") }.join
  end

  # Words of both directions come before and after those of one.
  def words(direction, markdown)
    found = read('core/card/card_words.h').scan(%r{^/\*\*(#{INSIDE})\*/\n#define CARD_(BOTH|#{direction})_\w+ (\d+)U$}m)
    rows = found.sort_by { |_, _, word| word.to_i }.flat_map do |comment, _, word|
      fields(comment).map { |bits, name, *says| [word, bits, "`#{name}`", *says] }
    end
    markdown.call(%w[Word Bits Field What Values], rows)
  end

  # A line that begins no field belongs to the one before; `{NAME}` is a limit.
  def fields(comment)
    lines = comment.lines.map { |line| line.sub(/\A\s*\*?\s*/, '').strip }.reject(&:empty?)
    joined = lines.slice_when { |_, line| line.match?(BEGINNING) }.map { |part| part.join(' ') }
    joined.map { |text| FIELD.match(text.gsub(/\{(\w+)\}/) { @limits.fetch(Regexp.last_match(1)).value }).captures }
  end

  def enumeration(prefix, markdown)
    body = headers[/typedef enum \{((?:(?!\}).)*\b#{prefix}\w+ = .*?)\} \w+;/m, 1]
    after = body.scan(%r{\b#{prefix}(\w+) = (\d+),?(?:\s*/\*\*<(.*?)\*/)?}m)
    before = body.scan(%r{/\*\*(?!<)(#{INSIDE})\*/\s*#{prefix}(\w+) = }m).to_h { |says, name| [name, says] }
    markdown.call(%w[No. Name What], after.map { |name, code, says| [code, "`#{name}`", text(says || before[name])] })
  end

  def bits(prefix, markdown)
    found = headers.scan(%r{^#define #{prefix}(\w+) 0x(\h+)U\s*/\*\*<(.*?)\*/}m)
    markdown.call(%w[Bit Name What], found.map { |name, value, says| [value.hex.bit_length - 1, "`#{name}`", text(says)] })
  end

  def text(comment)
    comment.gsub(/\s*\n\s*(\*\s*)?/, ' ').strip
  end

  # Rows of an array of structures, as their texts without the braces.
  def rows_of(array)
    read(VECTORS)[/ #{array}\[\] = \{\n(.*?)\n\};/m, 1].split(/^    \{/).drop(1)
  end

  def strings(row)
    row.scan(/((?:"[^"]*"\s*)+),/).flatten.map { |parts| parts.scan(/"([^"]*)"/).join }
  end

  def vectors(_markdown)
    rows_of('card_vectors').flat_map do |row|
      name, says = strings(row)
      what = row[/^\s*true,/] ? 'Command' : 'Report'
      refusal = row[/CARD_FRAME_(\w+)/, 1]
      becomes = refusal == 'OK' ? 'taken' : "refused as `#{refusal}`"
      ["`#{name}`: #{says} #{what}, #{becomes}.", '', '```text', *hex(row), '```', '']
    end[0..-2]
  end

  def hex(row)
    row.scan(/0x(\h{8})U/).flatten.each_slice(WORDS_IN_A_LINE).map { |line| line.join(' ').downcase }
  end

  def conversation(markdown)
    rows = rows_of('card_conversation').map do |row|
      numbers = row.gsub(/(?:"[^"]*"\s*)+,/, '').delete("\n{}").split(',').map(&:strip)
      [*numbers.first(4), *strings(row), *numbers.drop(4)].map { |cell| short(cell) }
    end
    markdown.call(%w[Sequence Control Mode Wait,\ us What Accepted Applied Faults Gaps], rows)
  end

  def short(cell)
    cell.sub(/\ACARD_(?:CONTROL|DRIVE|STATUS)_(\w+)\z/, '`\1`').sub(/\A(\d+)U\z/, '\1')
  end
end
