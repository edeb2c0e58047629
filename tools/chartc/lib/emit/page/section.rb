# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../../check/properties'
require_relative '../../flatten/regions'
require_relative '../diagram'
require_relative '../words'
require_relative 'decision_table'
require_relative 'html'

module Chart
  # One chart on the page: its drawing, and tables of all it consists of.
  class Section
    include Html

    CHECKED = { response: 'step', only: 'step' }.freeze

    WORST = { 'x86_instructions' => 'x86-64 instructions', 'arm_instructions' => 'ARM instructions',
              'stack_bytes' => 'Stack bytes', 'ram_bytes' => 'RAM bytes' }.freeze

    # Stated of the chart as a whole; the check runs once a cycle.
    CHECK = { 'x86_check_instructions' => 'x86-64 instructions of the check',
              'arm_check_instructions' => 'ARM instructions of the check' }.freeze

    DECIDED = '<p class="quiet">What each state does with each event. An empty field is nothing: the event cannot ' \
              "come there, or another region takes it.</p>\n"

    # worst: the row of this chart in the worst-case table, or nil.
    def initialize(chart, worst)
      @document = chart.document
      @walk = chart.walk
      @worst = worst
      @diagram = Diagram.new(@document)
    end

    def name
      @document.name
    end

    # Title => content; parts that the chart has not are left out.
    def parts
      @parts ||= { 'Drawing' => drawing, 'Decisions' => decisions, 'States' => states, 'Transitions' => transitions,
                   'Inputs' => inputs, 'Events' => events, 'Timers' => timers, 'Properties' => properties,
                   'Requirements and hazards' => traced, 'Size and bounds' => bounds }.compact
    end

    def anchor(title)
      "chart-#{name}-#{title.downcase.tr(' ', '-')}"
    end

    def emit
      body = parts.map { |title, content| "<h3 id=\"#{anchor(title)}\">#{title}</h3>\n#{content}" }
      "<section id=\"chart-#{name}\">\n<h2>#{name}</h2>\n<p>#{escape(@document.comment)}</p>\n<p class=\"quiet\">" \
        "#{facts}</p>\n#{body.join}</section>\n"
    end

    def verdicts
      @verdicts ||= PropertyChecks.verdicts(@document, @walk)
    end

    # The row of the table of contents.
    def overview
      [link("#chart-#{name}", name), @document.states.count { |state| !state.history? }, @document.transitions.length,
       @walk.reached.length, @walk.pair_count, verdicts.length, @walk.most_microsteps,
       *WORST.keys.map { |key| @worst && @worst[key] }]
    end

    private

    def facts
      join([tag('span', "statecharts/#{name}.scxml"), "begins in #{@walk.start.after.leaves.join(' + ')}",
            "safe in #{@document.safe.map(&:id).join(' + ')}"], ' · ')
    end

    # Wide drawings shrink to the page, but no further than can be read.
    def drawing
      svg = Diagram.svg(@diagram.dot)
      width = svg[/width="(\d+)pt"/, 1]
      "<figure style=\"--width: #{width}\">\n<div class=\"scroll\">#{svg}</div>\n" \
        "<figcaption>#{link("#{name}.svg", 'the drawing alone')}</figcaption></figure>\n"
    end

    def decisions
      found = Regions.of(@document).map { |region| DecisionTable.new(@document, region) }
      found = found.reject { |decisions| decisions.events.empty? }
      "#{DECIDED}#{found.map { |decisions| decisions.table.to_s }.join}" if found.any?
    end

    def states
      rows = @document.states.map { |state| state_row(state) }
      table(%w[State In Kind Entry Exit Ignores Requirements Hazards Line], rows)
    end

    def state_row(state)
      [link("##{Diagram.svg_id(@document, state)}", state.id), state.parent.id || '', kind(state),
       work(state.entry), work(state.exit), code(state.ignores), *claims(state)]
    end

    def kind(state)
      safe = @document.safe.include?(state) ? ', safe' : ''
      start = state.initial ? ", begins in #{state.initial.targets.map(&:id).join(' + ')}" : ''
      [state.depth, "#{state.kind}#{start}#{safe}"].compact.join(' ')
    end

    def claims(one)
      [code(one.req), code(one.hazards), one.line]
    end

    def work(content)
      Words.content(content).join(', ')
    end

    def transitions
      marks = @diagram.marks
      rows = @document.transitions.map { |transition| transition_row(transition, marks.fetch(transition.id).first) }
      table(['Transition', 'No.', 'From', 'Event', 'Guard', 'To', 'Actions and raised events', 'Requirements',
             'Hazards', 'Line'], rows)
    end

    def transition_row(transition, mark)
      target = transition.targetless? ? tag('span', 'stays', 'quiet') : transition.targets.map(&:id).join(', ')
      event = transition.eventless? ? tag('span', 'at once', 'quiet') : transition.events.join(', ')
      guard = transition.guard_text ? tag('span', transition.guard_text, 'guard') : ''
      [link("##{mark}", transition.id), transition.number, transition.source.id, event, guard, target,
       work(transition.content), *claims(transition)]
    end

    def inputs
      rows = @document.variables.map { |one| [one.name, range(one), one.comment, one.line] }
      table(%w[Name Kind Meaning Line], rows) if rows.any?
    end

    def range(variable)
      variable.kind == :integer ? "#{variable.minimum} to #{variable.maximum}" : variable.kind
    end

    def events
      rows = @document.events.map { |event| [event, causes(event)] }
      table(['Event', 'Caused by'], rows)
    end

    def causes(event)
      timers = @document.timers.select { |timer| timer.event == event }.map { |timer| "timer #{timer.id}" }
      raised = @document.contents.grep(Raise).any? { |raise| raise.event == event } ? ['the chart'] : []
      done = event.start_with?('done.state.') ? ['the chart'] : []
      outside = @document.internal_events.include?(event) ? [] : ['outside']
      (outside + timers + raised + done).join(', ')
    end

    def timers
      rows = @document.timers.map { |timer| timer_row(timer) }
      table(%w[Timer Event Runs\ in Delay Limit Rounds Ticks Line], rows) if rows.any?
    end

    def timer_row(timer)
      rounding = { down: 'down (watchdog)', up: 'up (hold-off)' }.fetch(timer.rounding)
      [timer.id, timer.event, Words.starters(@document, timer).map(&:id).join(', '), Words.duration(timer.delay_us),
       code(timer.limit), rounding, timer.threshold_us / @document.tick_us, timer.line]
    end

    def properties
      rows = verdicts.map do |verdict|
        property = verdict.property
        [property.id, property.text, tag('span', verdict.verdict, 'holds'),
         checked(verdict), *claims(property)]
      end
      table(%w[Property Says Verdict Checked\ on Requirements Hazards Line], rows) if rows.any?
    end

    def checked(verdict)
      what = CHECKED.fetch(verdict.property.kind, 'configuration')
      "#{grouped(verdict.checked)} #{what}#{'s' unless verdict.checked == 1}"
    end

    # Which elements stand for each requirement and each hazard.
    def traced
      ids = %i[req hazards].flat_map { |kind| claimants.flat_map { |one| one.public_send(kind) }.uniq.sort }
      rows = ids.map do |id|
        [code(id), *[@document.states, @document.transitions, @document.properties].map { |all| naming(all, id) }]
      end
      table(%w[Id States Transitions Properties], rows)
    end

    def claimants
      @document.states + @document.transitions + @document.properties
    end

    def naming(elements, id)
      elements.select { |one| (one.req + one.hazards).include?(id) }.map(&:id).join(', ')
    end

    def bounds
      rows = [['Configurations reached', @walk.reached.length],
              ['Pairs of configuration and stimulus', @walk.pair_count],
              ['Microsteps of one macrostep, at most', @walk.most_microsteps],
              ['Events raised in one macrostep, at most', @walk.most_raised]]
      table(['Measure', 'Value', 'Where'], (rows + worst_rows).map { |name, value, where| [name, value, where.to_s] })
    end

    def worst_rows
      return [] unless @worst

      WORST.merge(CHECK).filter_map do |key, title|
        witness = @worst[key.sub(/instructions\z/, 'witness')] if WORST.key?(key) && key.end_with?('instructions')
        [title, @worst[key], witness] if @worst[key]
      end
    end
  end
end
