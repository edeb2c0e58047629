# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'document'
require_relative 'limit'

module Robot
  # How far the needle is bent by its rotation (core/robot/steering.h): points of curvature and strength, and the largest
  # curvature that the slowest drive of the axis about the needle leaves.
  #
  # @satisfies SWR-STEER-003
  class Steering
    MOST_POINTS = 8 # ROBOT_STEERING_POINTS of core/robot/robot.h
    NONE = { 'axis' => '0U', 'points' => '0U', 'most_per_km' => '0U', 'needle_percent' => '0U', 'curvature_per_km' => ['0U'] * MOST_POINTS,
             'alpha_q16' => ['0U'] * MOST_POINTS }.freeze
    PER_KM = 1000
    ONE_Q16 = 65_536
    CURVATURE_PER_M = (0..20)
    ALPHA = (0..1)
    FULL_PERCENT = 100
    UM_PER_MM = 1000.0
    TURN_STEPS = 720
    MARGIN_TICKS = 17
    WIDTH_RAD = Math::PI / 3 # c of core/motion/curv.h

    # Of steering_law_t, as C writes them.
    attr_reader :values

    # `node`: nil without.
    def initialize(node, axes)
      @values = NONE
      read(node, axes) if node
    end

    private

    def read(node, axes)
      about = axes.index { |axis| axis['needle'] == 'about' }
      node.refuse('is of a robot without an axis about the needle; expected one') unless about
      refuse_short(node, axes[about])
      nodes = node.mapping(%w[curvature_per_m alpha])
      curvatures = points(nodes['curvature_per_m'], CURVATURE_PER_M, PER_KM)
      alphas = points(nodes['alpha'], ALPHA, ONE_Q16)
      nodes['alpha'].refuse("has #{alphas.size} points; expected #{curvatures.size}, one for each curvature") \
        unless alphas.size == curvatures.size
      alpha = slowest_alpha(axes[about])
      most = most_per_km(curvatures, alphas, alpha)
      percent = needle_percent(axes.find(&:needle?), axes[about], [alpha, alphas.last].min)
      @values = { 'axis' => "#{about}U", 'points' => "#{curvatures.size}U", 'most_per_km' => "#{most}U", 'needle_percent' => "#{percent}U",
                  'curvature_per_km' => filled(curvatures), 'alpha_q16' => filled(alphas) }
    end

    # A whole turn, and beyond each end the ramp of a rotation that turns back, with some counts (core/mode/leg/steer.c).
    def refuse_short(node, axis)
      run_out = (Rational(axis['speed_ticks_per_s']**2, 2 * axis['acceleration_ticks_per_s2'])).ceil + MARGIN_TICKS
      least = (2 * Math::PI * axis['ticks_per_unit']).ceil + (2 * run_out)
      range = axis['maximum_ticks'] - axis['minimum_ticks']
      node.refuse("needs #{least} ticks of #{axis['name']}, which has #{range}; expected one turn and two ramps") if range < least
    end

    def points(node, range, scale)
      values = node.sequence.map { |one| (one.decimal(range) * scale).round }
      node.refuse("has #{values.size} points; expected 2 to #{MOST_POINTS}") unless values.size.between?(2, MOST_POINTS)
      rises = values.first.zero? && values.each_cons(2).all? { |one, after| after > one }
      node.refuse('does not rise from 0 on; expected each more than the one before') unless rises
      values
    end

    def filled(values)
      (values + ([0] * (MOST_POINTS - values.size))).map { |value| "#{value}U" }
    end

    # The most of the law.
    def most_speed(axis)
      Rational(axis['speed_ticks_per_s'] * Limit.of('steering_speed_percent'), FULL_PERCENT)
    end

    # The strength at which the axis has its slowest speed where it is slowest.
    def slowest_alpha(axis)
      curve = axis['speed_curve'].first
      share = curve.zero? ? Rational(Drive::SLOWEST_PERCENT, FULL_PERCENT) : Rational(curve, Drive::CURVE_FULL)
      slowest = share * axis['full_speed_ticks_per_s'] / most_speed(axis)
      [1 - slowest, 0].max * ONE_Q16
    end

    # Share of its speed with which the needle goes in by the advance of a turn, percent.
    def needle_percent(needle, axis, alpha)
      steps = (0...TURN_STEPS).sum do |step|
        away = ((step + 0.5) / TURN_STEPS * 2 * Math::PI) - Math::PI
        1 / (1 - (alpha / ONE_Q16.to_f * Math.exp(-(away**2) / (2 * (WIDTH_RAD**2)))))
      end
      turn_s = steps / TURN_STEPS * 2 * Math::PI * axis['ticks_per_unit'] / most_speed(axis)
      most_mm_per_s = Limit.of('steering_advance_um') / UM_PER_MM / turn_s
      (most_mm_per_s * needle['ticks_per_unit'] / needle['speed_ticks_per_s'] * FULL_PERCENT).floor.clamp(1, FULL_PERCENT)
    end

    # The largest curvature whose strength is not above `alpha`.
    def most_per_km(curvatures, alphas, alpha)
      above = alphas.index { |one| one > alpha } || (return curvatures.last)
      low, high = curvatures[above - 1], curvatures[above]
      share = (alpha - alphas[above - 1]) / (alphas[above] - alphas[above - 1])
      (low + ((high - low) * share)).floor
    end
  end
end
