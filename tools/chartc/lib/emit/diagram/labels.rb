# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../words'
require_relative 'text'

module Chart
  class Diagram
    # What stands in the states and boxes of a drawing.
    class Labels
      # In characters.
      STATE_WIDTH = 68
      BOX_WIDTH = 30
      LIST_WIDTH = 50
      # Begins the id of a line inside a state.
      ROW = 'row-'

      def initialize(document, ways)
        @document = document
        @rows = ways.select(&:targetless?).group_by { |way| way.sources.first }
        @shared = ways.select { |way| way.sources.length > 1 }
      end

      def leaf(state)
        table([name(state), *happenings(state)])
      end

      # The title of a frame; what happens in it stands in a node of its own, which lines do not cross.
      def frame(state)
        table([name(state)])
      end

      # nil if there is nothing to report.
      def notes(state)
        cells = happenings(state)
        table([cell(Text.new(STATE_WIDTH).add(:quiet, ["anywhere in #{state.id}"])), *cells]) if cells.any?
      end

      # The text of a box between states.
      def way(way)
        lines = [phrases(way, BOX_WIDTH)]
        lines << Text.new(BOX_WIDTH).add(:quiet, ['from', 'anywhere', 'in', way.sources.first.id]) if way.around?
        lines << Text.new(BOX_WIDTH).add_list(:quiet, way.sources.map(&:id), 'from') if way.sources.length > 1
        "<#{lines.map { |line| "#{line}#{Text::BREAK}" }.join}>"
      end

      # What a default transition does.
      def default(default)
        default.content.empty? ? '""' : "<#{work(Text.new(BOX_WIDTH), default.content)}>"
      end

      # One line for each transition.
      def tooltip(way)
        lines = way.transitions.map { |one| [one.id, *one.req, *one.hazards, "line #{one.line}"].join(' ') }
        lines.map { |line| Text.escape(line) }.join('&#10;')
      end

      private

      def table(cells)
        "<<TABLE BORDER=\"0\" CELLSPACING=\"0\" CELLPADDING=\"2\">#{cells.join}</TABLE>>"
      end

      # All that happens without leaving the state, and what does not.
      def happenings(state)
        [*timers(state), content(state, 'entry', state.entry), content(state, 'exit', state.exit),
         *@rows.fetch(state, []).map { |way| row(way) }, list(onward(state), 'on to'),
         list(state.ignores, 'ignores')].compact
      end

      def name(state)
        text = Text.new(STATE_WIDTH).add(:strong, [state.id])
        text.add(:quiet, ['(safe)']) if @document.safe.include?(state)
        cell(text)
      end

      # A timer that runs as long as its state is active needs no words on its end.
      def timers(state)
        own_timers(state).map do |timer|
          cell(Text.new(STATE_WIDTH).add(:time, ["after #{Words.duration(timer.delay_us)}: #{timer.event}"]))
        end
      end

      def own_timers(state)
        state.entry.grep(Send).map(&:timer) & state.exit.grep(Cancel).map(&:timer)
      end

      def content(state, title, items)
        rest = items.reject { |item| item.respond_to?(:timer) && own_timers(state).include?(item.timer) }
        cell(work(Text.new(STATE_WIDTH).add(:quiet, [title]), rest)) if rest.any?
      end

      def row(way)
        cell(phrases(way, STATE_WIDTH),
             "ID=\"#{ROW}#{Text.escape(way.id)}\" TARGET=\"_self\" TITLE=\"#{tooltip(way)}\"")
      end

      # Where shared ways lead that no line connects with the state.
      def onward(state)
        ways = @shared.select { |way| way.sources.include?(state) && way.line_from != state }
        (ways.flat_map(&:targets).uniq - [state]).map(&:id)
      end

      def list(words, start)
        cell(Text.new(LIST_WIDTH).add_list(:quiet, words, start)) if words.any?
      end

      def phrases(way, width)
        text = Text.new(width)
        way.first.eventless? ? text.add(:quiet, ['at once']) : text.add_list(:strong, way.events)
        text.add(:guard, "[#{way.first.guard_text}]".split(/(?<=&&|\|\|) /)) if way.first.guard_text
        work(text, way.first.content)
      end

      def work(text, content)
        text.add_list(:work, Words.content(content), '/')
      end

      def cell(text, attributes = '')
        "<TR><TD ALIGN=\"LEFT\" BALIGN=\"LEFT\" #{attributes}>#{text}</TD></TR>"
      end
    end
  end
end
