# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'page/section'

module Chart
  # One HTML page on all charts. It needs nothing beside it and no script.
  # @satisfies SWR-CHART-005
  class Page
    include Html

    PARTS = File.join(__dir__, 'page')

    # worst_case: content of verification/model/worst_case.yml, or nil.
    def initialize(charts, worst_case)
      @sections = charts.map { |chart| Section.new(chart, worst_case&.dig('charts', chart.document.name)) }
    end

    def emit
      <<~HTML
        <!DOCTYPE html>
        <html lang="en">
        <head>
        <meta charset="utf-8">
        <meta name="viewport" content="width=device-width, initial-scale=1">
        <title>Boresight: statecharts</title>
        <style>
        #{part('style.css')}</style>
        </head>
        <body>
        #{navigation}
        <main>
        #{introduction}
        #{@sections.map(&:emit).join}</main>
        </body>
        </html>
      HTML
    end

    private

    def part(name)
      File.read(File.join(PARTS, name), encoding: 'UTF-8')
    end

    def navigation
      entries = @sections.map do |section|
        inner = section.parts.keys.map { |title| "<li>#{link("##{section.anchor(title)}", title)}</li>" }
        "<li>#{link("#chart-#{section.name}", section.name)}\n<ul>#{inner.join}</ul></li>"
      end
      entries.unshift('<li><a href="#top">All charts</a></li>')
      "<nav aria-label=\"Contents\">\n<ul>\n#{entries.join("\n")}\n</ul>\n</nav>"
    end

    def introduction
      <<~HTML
        <h1 id="top">Statecharts</h1>
        <p>Every state, transition, timer and property of the charts in <code>statecharts/</code>. A configuration is
        a set of states that are active together. Each pair of a reached configuration and a stimulus has been stepped,
        with every valuation of the inputs, and each property decided on all of them.</p>
        #{overview}
        <h3 id="legend">How to read the drawings</h3>
        #{part('legend.html')}
      HTML
    end

    def overview
      heads = ['Chart', 'States', 'Transitions', 'Configurations', 'Pairs', 'Properties', 'Microsteps at most',
               *Section::WORST.values]
      table(heads, @sections.map(&:overview))
    end
  end
end
