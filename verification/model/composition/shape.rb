# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Required contents of composition.yml, before anything of it is understood: sections, and in them rows with their words.
class CompositionShape
  SECTIONS = { 'axes' => Integer, 'members' => Hash, 'facts' => Hash, 'permit' => String, 'reasons' => Hash,
               'inputs' => Hash, 'stimuli' => Array, 'reactions' => Array, 'properties' => Array }.freeze
  PARTS = %w[facts reasons].freeze
  # Required and possible words of the rows of a section.
  ROWS = {
    'stimuli' => [%w[send], { 'send' => String, 'when' => String }],
    'reactions' => [%w[after send], { 'after' => String, 'send' => Array, 'when' => String, 'of' => String }],
    'properties' => [%w[id req],
                     { 'id' => String, 'req' => String, 'always' => String, 'after' => Array, 'only' => Array,
                       'from' => String, 'then' => String, 'reaches' => String, 'steps' => Integer }]
  }.freeze
  # Further words of a property of a kind.
  KINDS = { 'always' => [], 'after' => %w[then], 'only' => %w[from then], 'reaches' => [] }.freeze

  # wrong: the class of what is raised.
  def self.check(rows, wrong)
    new(rows, wrong).check
  end

  def initialize(rows, wrong)
    @rows = rows
    @wrong = wrong
  end

  def check
    entries(@rows, 'the file', SECTIONS.keys, SECTIONS)
    PARTS.each { |name| part(name) }
    texts('members', @rows['members'])
    texts('inputs', @rows['inputs'])
    ROWS.each { |name, (needed, known)| @rows[name].each { |row| entries(row, name, needed, known) } }
    @rows['properties'].each { |row| property(row) }
  end

  private

  def refuse(words)
    raise @wrong, words
  end

  def entries(row, place, needed, known)
    refuse("#{place}: #{row.inspect} has no names") unless row.is_a?(Hash)
    missing = (needed - row.keys).first
    refuse("#{place}: #{shown(row)} has no #{missing}") if missing
    row.each do |name, value|
      refuse("#{place}: #{name} means nothing; known are #{known.keys.join(', ')}") unless known.key?(name)
      kind(value, known.fetch(name), "#{place}: #{name}")
    end
  end

  def kind(value, kind, place)
    refuse("#{place} is no #{kind}") unless value.is_a?(kind)
    refuse("#{place} is not a list of names") if kind == Array && value.first.is_a?(String) && !value.all?(String)
  end

  def shown(row)
    row['id'] || row['send'] || row['after'] || 'it'
  end

  def part(name)
    entries(@rows[name], name, %w[common axis], 'common' => Hash, 'axis' => Hash)
    @rows[name].each { |which, conditions| texts("#{name} #{which}", conditions) }
  end

  def texts(place, hash)
    stray = hash.find { |name, text| !name.is_a?(String) || !text.is_a?(String) } or return
    refuse("#{place}: #{stray.first} says #{stray.last.inspect}")
  end

  def property(row)
    kinds = KINDS.keys & row.keys
    refuse("properties: #{row['id']} says nothing, or too much") unless kinds.one?
    missing = (KINDS.fetch(kinds.first) - row.keys).first
    refuse("properties: #{row['id']} has no #{missing}") if missing
  end
end
