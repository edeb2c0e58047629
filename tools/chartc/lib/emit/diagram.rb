# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'open3'
require_relative 'diagram/arrows'
require_relative 'diagram/labels'
require_relative 'diagram/places'
require_relative 'diagram/states'
require_relative 'diagram/ways'

module Chart
  # The chart as a Graphviz drawing. States carry the id CHART-STATE. What is drawn for transitions (an arrow, a
  # gate, a line inside a state) carries the id of the first of them; #marks reports where each is.
  class Diagram
    FONT = 'fontname="DejaVu Sans,Verdana,sans-serif" fontsize=11'
    STYLE = <<~DOT.freeze
      graph [class=chart compound=true nodesep=0.3 ranksep=0.3 bgcolor="#ffffff" #{FONT}];
      node [shape=box height=0.3 width=0.5 margin="0.1,0.05" #{FONT}];
      node [color="#52606d" style="rounded,filled" fillcolor="#ffffff"];
      edge [arrowsize=0.7 color="#52606d" #{FONT}];
    DOT

    LINK = /<a xlink:title="([^"]*)"[^>]*>/.freeze

    # Graphviz is not there, or did not draw.
    class Failed < StandardError; end

    def self.svg_id(document, state)
      "#{document.name}-#{state.id}"
    end

    # The bare drawing. Prologue and comments would name the version of Graphviz, its titles and ids are those of
    # nodes; the links that it makes of tooltips become titles, which every browser shows.
    def self.svg(dot)
      output, errors, status = Open3.capture3('dot', '-Tsvg', stdin_data: dot)
      raise Failed, "dot refused the drawing: #{errors}" unless status.success?

      output.sub(/\A.*?(?=<svg )/m, '').gsub(/<!--.*?-->\n?/m, '').gsub(%r{<title>.*?</title>\n}m, '')
            .gsub(/ id="(?:graph|clust|node|edge)\d+"/, '').gsub('&#45;', '-')
            .gsub(/<g id="a_#{Labels::ROW}([^"]*)">#{LINK}/, '<g id="\1" class="way row"><title>\2</title>')
            .gsub(/<g id="a_[^"]*">#{LINK}/, '<g><title>\1</title>').gsub("</a>\n", '')
    rescue Errno::ENOENT
      raise Failed, 'dot is missing; install the package graphviz'
    end

    def initialize(document)
      @document = document
      @ways = Ways.of(document)
    end

    def dot
      places = Places.new(@document)
      labels = Labels.new(@document, @ways)
      arrows = Arrows.new(places, labels, @ways)
      states = States.new(@document, places, labels, arrows)
      "digraph \"#{@document.name}\" {\n#{STYLE}#{states.lines.join("\n")}\n#{arrows.lines.join("\n")}\n}\n"
    end

    # Transition id => ids of the elements of the drawing that stand for it.
    def marks
      @ways.each_with_object({}) do |way, marks|
        way.transitions.each { |transition| marks[transition.id] = way.marks }
      end
    end
  end
end
