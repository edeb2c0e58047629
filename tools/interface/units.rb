# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

module Interface
  # The unit of each number that HTTP clients read or write: its name ends in it, or the member `unit` beside it says it
  # (`unit: axis`), or the file says what it is instead of a quantity.
  #
  # @satisfies SWR-TOOL-028
  module Units
    # `dc` is 0.1 degree Celsius, `mn` a millinewton.
    SUFFIXES = %w[mm um deg rpm min s ms us cycles ticks hz mv ma dc mn bytes percent per_mille].freeze
    AXIS = 'axis'
    # Kind of a number without a unit. `text`: the sentence `text` beside it has its unit; `pose`: a matrix in mm.
    NONE = %w[count id ratio reading pose text].freeze
    BESIDE = { AXIS => 'unit', 'text' => 'text' }.freeze
    # Not the one of a speed: what goes in a second is of the axis.
    SUFFIX = /(?:\A|(?<!_per)_)(?:#{SUFFIXES.join('|')})\z/
    # Forms that say their unit themselves.
    FORMS = { 'position' => AXIS, 'speed' => AXIS, 'matrix' => 'pose' }.freeze
    NUMBERS = %w[number point].freeze
    # Units as people write them; each other one is written as its suffix.
    WRITTEN = { 'deg' => 'degrees', 'min' => 'minutes', 'hz' => 'Hz', 'mv' => 'mV', 'ma' => 'mA', 'mn' => 'mN', 'us' => 'microseconds', 'um' => 'micrometres',
                'dc' => '0.1 degree Celsius', 'per_mille' => 'per mille' }.freeze

    # The unit of a number for people; nil: it has none.
    def self.written(name, unit)
      return "the unit of its axis#{' per second' if name.end_with?('_per_s')}" if unit == AXIS

      suffix = name[SUFFIX]&.delete_prefix('_')
      suffix && WRITTEN.fetch(suffix, suffix)
    end

    # One number. `names`: of all that stands in the same object.
    def self.check(node, name, unit, names)
      is_said = name.match?(SUFFIX)
      given = unit&.choice([AXIS, *NONE])
      node.refuse("is the number #{name} without a unit; end it in one of #{SUFFIXES.join(', ')}, or say " \
                  "`unit: #{AXIS}`, or which of #{NONE.join(', ')} it is") unless is_said || given
      unit.refuse("is #{given}, but #{name} ends in a unit") if is_said && given
      beside(node, name, given, names)
    end

    # A number whose form has the unit already.
    def self.check_form(shown, names)
      shown.node.refuse("is the speed #{shown.key}; expected a name that ends in _per_s") \
        if shown.form == 'speed' && !shown.key.end_with?('_per_s')
      beside(shown.node, shown.key, FORMS.fetch(shown.form), names)
    end

    def self.beside(node, name, given, names)
      wanted = BESIDE[given]
      node.refuse("has the unit of #{name} in #{wanted}, which is not there") if wanted && !names.include?(wanted)
    end
    private_class_method :beside
  end
end
