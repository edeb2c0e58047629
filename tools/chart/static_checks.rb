# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'expression'
require_relative 'refusal'

module Chart
  # The rules that need the whole chart, but no walk.
  class StaticChecks
    MOST_ACTIONS = 32
    MOST_TIMERS = 32
    MOST_INPUTS = 6

    def self.run(document)
      new(document).run
    end

    def initialize(document)
      @document = document
    end

    def run
      check_regions
      check_events
      check_raise_cycles
      check_sizes
      check_inputs_read
    end

    private

    def refuse(line, rule, message)
      raise Refusal.new(@document.file, line, rule, message)
    end

    def check_regions
      @document.transitions.select(&:target).each do |transition|
        region = @document.region_of(transition.source)
        check_target(transition, region)
        check_type(transition, region)
      end
    end

    def check_target(transition, region)
      return if region.leaves.include?(transition.target) || transition.target.inside?(region.state)

      refuse(transition.line, 17, "#{transition.id} leads out of region \"#{region.name}\"; raise an event that " \
                                  'the other region takes')
    end

    def check_type(transition, region)
      return if transition.source != region.state || transition.internal

      refuse(transition.line, 17, "#{transition.id} starts at region \"#{region.name}\" and would leave every " \
                                  'region; add type="internal"')
    end

    def check_events
      known = @document.events
      @document.transitions.each do |transition|
        stray = (transition.raises - known).first
        refuse(transition.line, 7, "nothing waits for \"#{stray}\"; raise one of: #{known.join(', ')}") if stray
      end
      @document.timers.each do |timer|
        next if known.include?(timer.event)

        refuse(timer.line, 7, "nothing waits for \"#{timer.event}\"; send one of: #{known.join(', ')}")
      end
    end

    # Depth-first over "a transition on this event raises that event".
    def check_raise_cycles
      @finished = []
      @document.events.each { |event| follow(event, []) }
    end

    def follow(event, path)
      return if @finished.include?(event)

      if path.include?(event)
        circle = (path.drop_while { |step| step != event } + [event]).join(' -> ')
        culprit = @document.transitions.find { |one| one.event == path.last && one.raises.include?(event) }
        refuse(culprit.line, 11, "events raise each other for ever: #{circle}; remove one <raise>")
      end
      raised = @document.transitions.select { |one| one.event == event }.flat_map(&:raises).uniq
      raised.each { |following| follow(following, path + [event]) }
      @finished << event
    end

    def check_sizes
      line = @document.root.line
      { 'actions' => [@document.actions, MOST_ACTIONS], 'timers' => [@document.timers, MOST_TIMERS],
        'inputs' => [@document.inputs, MOST_INPUTS] }.each do |what, (found, most)|
        next if found.length <= most

        refuse(line, 19, "the chart has #{found.length} #{what}; at most #{most} fit, split the chart")
      end
    end

    def check_inputs_read
      read = @document.transitions.filter_map(&:guard).flat_map { |guard| Expression.atoms(guard) }
      unread = @document.inputs.find { |input| !read.include?([:input, input.name]) }
      return unless unread

      refuse(unread.line, 24, "no guard reads \"#{unread.name}\"; remove the <data>, or use it")
    end
  end
end
