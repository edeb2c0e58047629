# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'document'
require_relative 'drive'
require_relative 'followers'
require_relative 'force'
require_relative 'formula'
require_relative 'hand'
require_relative 'kinematics'
require_relative 'limit'
require_relative 'pose'
require_relative 'probe'
require_relative 'reported'
require_relative 'steering'

module Robot
  # An axis as the file gives it: values by key, and the nodes they came from.
  class Axis
    UNITS = %w[ticks_per_mm ticks_per_rad].freeze
    SWITCH = { 'over_travel_ticks' => (0..10_000), 'switch_hysteresis_ticks' => (1..10_000),
               'home_time_ms' => (1000..600_000) }.freeze
    # Way that homing may go from its switch beyond over-travel and hysteresis, and the needle in all.
    HOME_MARGIN = { true => Rational('0.1'), false => Rational('0.005236') }.freeze # 0.1 mm or 0.3 degrees
    LARGEST_NEEDLE_WAY_MM = Rational('0.2')
    # A switch may be active up to so far beyond its hysteresis: 0.01 mm or 0.06 degrees, and what two counts make.
    SWITCH_SLACK = { true => Rational('0.01'), false => Rational('0.001047') }.freeze
    SWITCH_SLACK_TICKS = 2
    POSITION = (-1_000_000..1_000_000)
    SPEED = (1..Limit.of('axis_speed_most_ticks_per_s'))
    # @satisfies SWR-PROFILE-271
    ACCELERATION = (Limit.of('acceleration_least_ticks_per_s2')..Limit.of('acceleration_most_ticks_per_s2'))
    WHOLE = {
      'slot' => (0..9), 'home_stage' => Followers::STAGES, 'minimum_ticks' => POSITION, 'maximum_ticks' => POSITION,
      'home_ticks' => POSITION, 'start_ticks' => POSITION, 'deadband_ticks' => (0..1000), 'speed_ticks_per_s' => SPEED,
      'acceleration_ticks_per_s2' => ACCELERATION, 'home_speed_ticks_per_s' => SPEED,
      'full_speed_ticks_per_s' => SPEED, 'following_error_ticks' => (1..1_000_000), 'jump_ticks' => (1..1_000_000),
      'following_time_ms' => (0..1000), 'drift_ticks' => (0..10_000)
    }.freeze
    CHOICES = {
      'limit_switch' => %w[none lower upper], 'home' => %w[switch in_place],
      'motor_inverted' => %w[true false], 'encoder_inverted' => %w[true false], 'needle' => %w[across along about]
    }.freeze

    def initialize(node)
      @node = node
      @nodes = node.mapping(['name', *WHOLE.keys, *CHOICES.keys, *Drive::CHOICES.keys],
                            UNITS + Drive::KEYS + SWITCH.keys + ['follows'])
      @values = { 'name' => @nodes['name'].name }
      WHOLE.each { |key, range| @values[key] = @nodes[key].integer(range) }
      CHOICES.each { |key, values| @values[key] = @nodes[key].choice(values) }
      @values['follows'] = Followers.read(@nodes['follows'])
      read_unit
      @values.merge!(Drive.new(node, @nodes).values)
      read_switch
      check
    end

    def [](key)
      @values.fetch(key)
    end

    def refuse(key, reason)
      @nodes.fetch(key, @node).refuse(reason)
    end

    def linear?
      @nodes.key?('ticks_per_mm')
    end

    # The axis moved by `ticks`, in mm or rad.
    def units(ticks)
      ticks / self['ticks_per_unit']
    end

    # The farthest that homing goes away from the switch.
    def home_way_ticks
      return 0 if self['limit_switch'] == 'none'

      margin = (HOME_MARGIN[linear?] * self['ticks_per_unit']).ceil
      way = self['over_travel_ticks'] + self['switch_hysteresis_ticks'] + margin
      needle? ? [way, (LARGEST_NEEDLE_WAY_MM * self['ticks_per_unit']).floor].min : way
    end

    # The positions that a target may have: where the switch is surely free.
    def targets
      slack = (SWITCH_SLACK[linear?] * self['ticks_per_unit']).ceil
      zone = self['switch_hysteresis_ticks'] + [slack, SWITCH_SLACK_TICKS].max
      low, high = self['minimum_ticks'], self['maximum_ticks']
      low = [low, self['home_ticks'] + zone].max if self['limit_switch'] == 'lower'
      high = [high, self['home_ticks'] - zone].min if self['limit_switch'] == 'upper'
      { 'target_minimum_ticks' => low, 'target_maximum_ticks' => high }
    end

    def needle?
      self['needle'] == 'along'
    end

    # @satisfies SWR-AXIS-060
    def check_home_time
      travel = self['maximum_ticks'] - self['minimum_ticks']
      percent = Limit.of('home_time_least_percent')
      least = Rational(travel * 10 * percent, self['home_speed_ticks_per_s']).ceil
      return if self['limit_switch'] == 'none' || self['home_time_ms'] >= least

      refuse('home_time_ms', "is #{self['home_time_ms']}; expected at least #{least}, " \
                             "#{percent} percent of what the travel takes at home_speed_ticks_per_s")
    end

    private

    def read_unit
      given = UNITS & @nodes.keys
      found = given.empty? ? 'no unit' : 'two units'
      @node.refuse("has #{found}; expected #{UNITS.join(' or ')}") unless given.size == 1
      @values['ticks_per_unit'] = @nodes[given.first].decimal(1..100_000)
    end

    # Keys that belong to some axes only; 0 for the others.
    def read_group(ranges, is_wanted)
      ranges.each do |key, range|
        @node.refuse("has no #{key}; expected #{range.begin} to #{range.end}") if !@nodes.key?(key) && is_wanted
        @values[key] = is_wanted ? @nodes[key].integer(range) : 0
      end
    end

    def read_switch
      has_switch = self['limit_switch'] != 'none'
      stray = SWITCH.keys.find { |key| @nodes.key?(key) } unless has_switch
      refuse(stray, 'does not belong to an axis without a switch; expected none') if stray
      read_group(SWITCH, has_switch)
    end

    def check
      below('minimum_ticks', 'maximum_ticks')
      %w[home_ticks start_ticks].each { |key| check_inside(key) }
      refuse('home', 'is switch, but the axis has none; expected in_place') if homes_without_switch?
      check_travel_time
      check_home_speed
      at_most('speed_ticks_per_s', 'full_speed_ticks_per_s')
      below('deadband_ticks', 'following_error_ticks')
      check_jump
    end

    def check_inside(key)
      return if self[key].between?(self['minimum_ticks'], self['maximum_ticks'])

      refuse(key, "is #{self[key]}; expected #{self['minimum_ticks']} to #{self['maximum_ticks']}")
    end

    def homes_without_switch?
      self['home'] == 'switch' && self['limit_switch'] == 'none'
    end

    def check_home_speed
      percent = Limit.of('unhomed_speed_percent')
      most = self['speed_ticks_per_s'] * percent / 100
      return if self['home_speed_ticks_per_s'] <= most

      refuse('home_speed_ticks_per_s', "is #{self['home_speed_ticks_per_s']}; expected at most #{most}, " \
                                       "#{percent} percent of speed_ticks_per_s (#{self['speed_ticks_per_s']})")
    end

    # @satisfies SWR-PROFILE-511
    def check_travel_time
      most = Limit.of('travel_time_most_s')
      least = Rational(self['maximum_ticks'] - self['minimum_ticks'], most).ceil
      return if self['speed_ticks_per_s'] >= least

      refuse('speed_ticks_per_s', "is #{self['speed_ticks_per_s']}; expected at least #{least}, with which the travel takes #{most} s")
    end

    def check_jump
      per_cycle = self['full_speed_ticks_per_s'] / 1000
      return if self['jump_ticks'] > per_cycle

      refuse('jump_ticks', "is #{self['jump_ticks']}; expected more than the #{per_cycle} of a cycle at full speed")
    end

    def below(key, other)
      refuse(key, "is #{self[key]}; expected less than #{other} (#{self[other]})") if self[key] >= self[other]
    end

    def at_most(key, other)
      refuse(key, "is #{self[key]}; expected at most #{other} (#{self[other]})") if self[key] > self[other]
    end
  end

  # A limit that axes share, in mm or deg.
  CoupledLimit = Struct.new(:name, :is_length, :refusal, :is_curved, :mask, :minimum, :maximum, :margin, :formula,
                            keyword_init: true)

  # A whole robot file, checked.
  #
  # @satisfies SWR-ROBOT-001
  # @satisfies SWR-ROBOT-021
  # @satisfies SWR-ROBOT-025
  class Description
    LARGEST_DEPTH_MM = 200
    LARGEST_TRAVEL_MM = 2000

    CARDS = %w[sensor].freeze # That go without an axis.

    attr_reader :name, :kinematics, :card_firmware, :axes, :sensor_slots, :force, :hand, :steering, :geometry, :probe,
                :coupled_limits, :followers, :poses, :reported

    def initialize(path, text)
      nodes = Node.parse(path, text).mapping(%w[name kinematics card_firmware geometry probe coupled_limits axes],
                                             %w[cards force hand poses reported steering])
      @name = nodes['name'].name
      @kinematics = nodes['kinematics'].choice(Kinematics.names)
      @expected = Kinematics.new(@kinematics)
      @card_firmware = nodes['card_firmware'].version
      @geometry = {}
      @places = {}
      read_lengths(nodes['geometry'], @expected.lengths('geometry'))
      @probe = Probe.new(nodes['probe'], @expected)
      check_lengths
      @coupled_limits = read_coupled_limits(nodes['coupled_limits'])
      @axes = read_axes(nodes['axes'])
      @sensor_slots = nodes.key?('cards') ? read_sensors(nodes['cards']) : []
      @force = nodes.key?('force') ? Force.new(nodes['force'], @sensor_slots) : nil
      @followers = Followers.new(@axes)
      check_axes
      @hand = Hand.new(nodes['hand'], @axes[needle_axis], @force)
      @steering = Steering.new(nodes['steering'], @axes)
      @poses = read_poses(nodes['poses'])
      @reported = Reported.new(nodes['reported'], @axes.map { |axis| axis['name'] }, @geometry, @probe)
    end

    def needle_axis
      @axes.index(&:needle?)
    end

    def bare_direction
      @expected.bare_direction
    end

    # The lengths of the geometry as C calls them.
    def length_names
      @geometry.keys.map { |key| key.delete_suffix('_mm') }
    end

    private

    def read_coupled_limits(node)
      limits = node.sequence.map { |limit| limit.mapping(%w[name minimum maximum]) }
      names = limits.map { |limit| limit['name'].name }
      expected = @expected.coupled_limits.keys
      node.refuse("are #{words(names)}; expected #{words(expected)}") unless names == expected
      limits.map { |limit| read_coupled_limit(limit, @expected.coupled_limits.fetch(limit['name'].name)) }
    end

    def read_coupled_limit(nodes, about)
      name, is_length = nodes['name'].name, about.fetch('unit') == 'mm'
      minimum, maximum = %w[minimum maximum].map { |side| read_bound(nodes[side], is_length) }
      least = minimum + (2 * coupled_margin(is_length))
      nodes['maximum'].refuse("is #{decimal(maximum)}; expected more than #{decimal(least)}") if maximum <= least
      CoupledLimit.new(name: name, is_length: is_length, refusal: @expected.refusal(name), mask: @expected.mask(name),
                       is_curved: about.fetch('curved'), minimum: minimum, maximum: maximum,
                       margin: coupled_margin(is_length), formula: Formula.new(about.fetch('value')))
    end

    # A length of the geometry by its name, or a number.
    def read_bound(node, is_length)
      return @geometry.fetch(node.word) if is_length && @geometry.key?(node.word)

      node.decimal(is_length ? -LARGEST_TRAVEL_MM..LARGEST_TRAVEL_MM : -180..180)
    end

    # Margin that ends keep to each side, in mm or deg.
    def coupled_margin(is_length)
      is_length ? Rational(Limit.of('coupled_margin_nm'), 1_000_000) : Rational(Limit.of('coupled_margin_bam') * 360, 2**32)
    end

    def words(names)
      names.empty? ? 'none' : names.join(', ')
    end

    def read_lengths(node, ranges)
      node.mapping(ranges.keys).then { |nodes| ranges.keys.to_h { |key| [key, nodes[key]] } }.each do |key, length|
        @geometry[key] = length.decimal(ranges[key])
        @places[key] = length
      end
    end

    def read_axes(node)
      axes = node.sequence.map { |axis| Axis.new(axis) }
      unique(axes, 'name')
      unique(axes, 'slot')
      names = axes.map { |axis| axis['name'] }
      node.refuse("are #{names.join(', ')}; expected #{@expected.axes.join(', ')}") unless names == @expected.axes
      axes
    end

    def read_poses(node)
      poses = node ? node.mapping([], Pose::NAMES) : {}
      poses.to_h { |name, pose| [name, Pose.new(name, pose, @axes).tap { |one| one.check(@coupled_limits, @geometry) }.ticks] }
    end

    # Their slots.
    def read_sensors(node)
      holders = @axes.to_h { |axis| [axis['slot'], axis['name']] }
      node.sequence.map do |card|
        nodes = card.mapping(%w[slot card])
        slot = nodes['slot'].integer(Axis::WHOLE.fetch('slot'))
        nodes['slot'].refuse("is #{slot}, which #{holders[slot]} has; expected another") if holders.key?(slot)
        holders[slot] = nodes['card'].choice(CARDS)
        slot
      end
    end

    def unique(axes, key)
      seen = {}
      axes.each do |axis|
        axis.refuse(key, "is #{axis[key]}, which #{seen[axis[key]]} has; expected another") if seen.key?(axis[key])
        seen[axis[key]] = axis['name']
      end
    end

    def check_lengths
      @expected.between.each do |key, (below, above)|
        low, high = @geometry[below], @geometry.values_at(*above).sum
        next if @geometry[key] > low && @geometry[key] < high

        @places[key].refuse("is #{decimal(@geometry[key])}; expected between #{decimal(low)} and #{decimal(high)}")
      end
    end

    def check_axes
      @axes.each { |axis| check_unit(axis) }
      @axes.each { |axis| check_needle(axis) }
      needle = @axes[needle_axis]
      needle.refuse('minimum_ticks', 'is negative; expected 0 or more, 0 is fully out') \
        if needle['minimum_ticks'].negative?
      needle.refuse('maximum_ticks', "is deeper than #{LARGEST_DEPTH_MM} mm; expected less") \
        if needle.units(needle['maximum_ticks']) > LARGEST_DEPTH_MM
      @axes.each(&:check_home_time)
    end

    def check_needle(axis)
      expected = @expected.needle(axis['name'])
      axis.refuse('needle', "is #{axis['needle']}; expected #{expected}") unless axis['needle'] == expected
    end

    def check_unit(axis)
      unit = @expected.unit(axis['name'])
      axis.refuse('name', "is #{axis['name']} in #{axis.linear? ? 'mm' : 'rad'}; expected ticks_per_#{unit}") \
        unless axis.linear? == (unit == 'mm')
      %w[minimum_ticks maximum_ticks].each do |key|
        axis.refuse(key, "is farther than #{LARGEST_TRAVEL_MM} mm; expected less") \
          if axis.linear? && axis.units(axis[key]).abs > LARGEST_TRAVEL_MM
      end
    end

    def decimal(value)
      text = format('%.3f', value)
      text.sub(/\.?0+\z/, '')
    end
  end
end
