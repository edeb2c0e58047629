# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'open3'

module Chart
  # The chart as a Graphviz drawing. States carry the id CHART-STATE, transitions their bs:id, so that a
  # page can light them by style sheet.
  class Diagram
    FONT = 'fontname="Helvetica,Arial,sans-serif" fontsize=11'

    # Graphviz is not there, or did not draw.
    class Failed < StandardError; end

    def self.svg_id(document, state)
      "#{document.name}-#{state.id}"
    end

    # Only the drawing is kept: the prologue and the comments name the version of Graphviz.
    def self.svg(dot)
      output, errors, status = Open3.capture3('dot', '-Tsvg', stdin_data: dot)
      raise Failed, "dot refused the drawing: #{errors}" unless status.success?

      output.sub(/\A.*?(?=<svg )/m, '').gsub(/<!--.*?-->\n?/m, '')
    rescue Errno::ENOENT
      raise Failed, 'dot is missing; install the package graphviz'
    end

    def initialize(document)
      @document = document
    end

    def dot
      @lines = ["digraph #{@document.name} {",
                "    graph [id=\"#{@document.name}\" compound=true rankdir=TB nodesep=0.4 ranksep=0.6 " \
                "bgcolor=\"transparent\" #{FONT}];",
                "    node [shape=box style=rounded #{FONT}];", "    edge [arrowsize=0.7 #{FONT}];"]
      inside(@document.root, '    ')
      @document.transitions.select(&:target).each { |transition| draw_transition(transition) }
      "#{(@lines << '}').join("\n")}\n"
    end

    private

    def inside(state, indent)
      draw_start(state, indent) if state.initial && state.initial.kind != :parallel
      draw_any(state, indent) if from_any(state).any?
      state.children.each { |child| draw_state(child, indent) }
    end

    def draw_state(state, indent)
      return draw_leaf(state, indent) if state.leaf?

      @lines << "#{indent}subgraph cluster_#{state.id} {"
      @lines << "#{indent}    graph [id=\"#{Diagram.svg_id(@document, state)}\" style=rounded labeljust=l " \
                "label=#{label(state)}];"
      inside(state, "#{indent}    ")
      @lines << "#{indent}}"
    end

    def draw_leaf(state, indent)
      @lines << "#{indent}#{node(state)} [id=\"#{Diagram.svg_id(@document, state)}\" label=#{label(state)}];"
    end

    # The name, the timer, and the transitions that lead nowhere else.
    def label(state)
      timers = state.timers.map { |timer| "after #{duration(timer.delay_us)}: #{timer.event}" }
      reactions = state.transitions.reject(&:target).map { |transition| words(transition) }
      quoted([state.id, *timers, *reactions])
    end

    def duration(microseconds)
      (microseconds % 1_000_000).zero? ? "#{microseconds / 1_000_000} s" : "#{microseconds / 1000} ms"
    end

    def words(transition)
      parts(transition).join(' ')
    end

    # The event, the guard, and the work, as far as there are.
    def parts(transition)
      work = transition.actions + transition.raises.map { |event| "raise #{event}" }
      [transition.event, transition.guard_text && "[#{transition.guard_text}]",
       work.any? ? "/ #{work.join(', ')}" : nil].compact
    end

    def quoted(lines, ending = '\l')
      return "\"#{lines.first}\"" if lines.length == 1

      "\"#{lines.map { |line| "#{line}#{ending}" }.join}\""
    end

    def node(state)
      "\"#{state.id}\""
    end

    def draw_start(state, indent)
      name = "\"start of #{state.id || @document.name}\""
      @lines << "#{indent}#{name} [shape=point width=0.12 label=\"\"];"
      @lines << "#{indent}#{name} -> #{node(leaf_of(state.initial))}#{head(state.initial)};"
    end

    def head(state)
      state.leaf? ? '' : " [lhead=cluster_#{state.id}]"
    end

    def from_any(state)
      return [] if state.leaf?

      state.transitions.select { |transition| transition.target&.inside?(state) }
    end

    def draw_any(state, indent)
      @lines << "#{indent}#{any(state)} [shape=plaintext];"
    end

    def any(state)
      "\"any of #{state.id}\""
    end

    def leaf_of(state)
      state = state.initial || state.children.first until state.leaf?
      state
    end

    def draw_transition(transition)
      source = transition.source
      attributes = ["id=\"#{transition.id}\"", "label=#{quoted(parts(transition), '\n')}"]
      attributes << "ltail=cluster_#{source.id}" unless source.leaf? || from_any(source).include?(transition)
      attributes << "lhead=cluster_#{transition.target.id}" unless transition.target.leaf?
      @lines << "    #{tail(transition)} -> #{node(leaf_of(transition.target))} [#{attributes.join(' ')}];"
    end

    def tail(transition)
      source = transition.source
      from_any(source).include?(transition) ? any(source) : node(leaf_of(source))
    end
  end
end
