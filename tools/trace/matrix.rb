# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'csv'
require 'erb'
require 'fileutils'
require 'json'
require_relative 'check'
require_relative 'function_proofs'

module Trace
  # Each requirement with what it comes from, what fulfils it and what its tests say.
  class Matrix
    # The page that plays a scene, seen from the matrix.
    PAGE = 'site/page/index.html'
    TEMPLATE = File.join(__dir__, 'matrix.html.erb')

    # A requirement as it is printed, written and shown.
    # why: reason for which results do not count.
    Row = Struct.new(:id, :title, :text, :place, :source, :method, :level, :parents, :limits, :elements, :tests,
                     :verdict, :why, keyword_init: true)

    def initialize(project)
      @project = project
      @functions = FunctionProofs.new(project)
      @rows = project.requirements.of_kind('SWR').sort_by(&:id).map { |item| row(item) }
    end

    def text
      lines = @rows.flat_map do |row|
        ["#{row.id}  #{row.verdict.upcase}  #{row.title}",
         *row.why.map { |reason| "    but    #{reason}" },
         "    from   #{row.parents.map { |parent| parent[:id] }.join(', ')}",
         *row.elements.map { |element| "    by     #{element[:name]} (#{element[:place]})" },
         *row.tests.map { |test| "    #{verb(test)} #{test[:result].ljust(6)} #{test[:test]} (#{test[:file]})" }]
      end
      "#{[*head, '', *lines].join("\n")}\n\n#{summary}"
    end

    def head
      @project.evidence.head
    end

    def summary
      counts = @rows.map(&:verdict).tally
      parts = ['pass', 'fail', 'not verified'].map { |verdict| "#{counts.fetch(verdict, 0)} #{verdict}" }
      "#{@rows.size} requirements: #{parts.join(', ')}"
    end

    def write(folder)
      FileUtils.mkdir_p(folder)
      File.write(File.join(folder, 'trace.json'), "#{JSON.pretty_generate(document)}\n")
      File.write(File.join(folder, 'trace.csv'), csv)
      File.write(File.join(folder, 'trace.html'), html)
      File.write(File.join(folder, 'proved.csv'), proved_csv)
    end

    def html
      ERB.new(File.read(TEMPLATE), trim_mode: '-').result(binding)
    end

    private

    def row(item)
      requirements = @project.requirements
      Row.new(id: item.id, title: item.title, text: requirements.sentence(item), place: item.place.to_s,
              source: item['source'].to_s, method: item['verification'].to_h['method'].to_s,
              level: item['verification'].to_h['level'].to_s,
              parents: Array(item['parents']).map { |parent| parent_row(parent) },
              limits: item.limits.map { |limit| limit.to_h.slice(:name, :value, :unit, :status) },
              elements: @project.elements_of(item.id).map { |e| { name: e.name, place: e.place.to_s } }.uniq,
              tests: tests(item.id), verdict: @project.verdict(item.id), why: why(item.id))
    end

    # A risk control with its hazards, or the reason of a derived requirement.
    def parent_row(parent)
      item = by_id[parent]
      return { id: parent, title: '', hazards: [] } unless item

      hazards = item.parents.map { |id| { id: id, title: by_id[id]&.title.to_s } }
      { id: item.id, title: item.title, hazards: hazards }
    end

    def by_id
      @by_id ||= @project.requirements.items.to_h { |item| [item.id, item] }
    end

    def verb(test)
      test[:test].start_with?('prove_') ? 'proved' : 'tested'
    end

    # One row for each test, with all gates that ran it.
    def tests(id)
      rows = @project.results_of(id).group_by { |result| [result.file, result.test, word(result)] }.map do |key, same|
        { test: key[1], file: key[0], result: key[2], assertions: same.first.assertions, from: same.map(&:source) }
      end
      rows.sort_by { |test| [test[:file], test[:test]] }
    end

    def word(result)
      return 'not counted' if result.doubt

      result.empty? ? 'empty' : result.result
    end

    def why(id)
      @project.results_of(id).select(&:doubt).map { |result| "#{result.source} does not count, #{result.doubt}" }.uniq
    end

    def document
      { origin: @project.evidence.origin, not_counted: @project.evidence.doubts, requirements: @rows.map(&:to_h),
        risk_controls: @project.requirements.of_kind('RC').map { |item| item_row(item, 'SWR') },
        hazards: hazards.map { |item| item_row(item, 'RC').merge('link' => link(item)) } }
    end

    def hazards
      @project.requirements.of_kind('HAZ').sort_by(&:id)
    end

    # Opens the scene in which the control of a hazard is seen to act.
    def link(item)
      "#{PAGE}##{item.scene}" if item.scene
    end

    def item_row(item, child_kind)
      children = @project.requirements.of_kind(child_kind).select { |child| child.parents.include?(item.id) }
      item.fields.merge('id' => item.id, 'children' => children.map(&:id), 'place' => item.place.to_s)
    end

    def csv
      CSV.generate do |out|
        head.each { |line| out << [line] }
        out << %w[id title text parents elements tests verdict]
        @rows.each do |row|
          out << [row.id, row.title, row.text, row.parents.map { |parent| parent[:id] }.join(' '),
                  row.elements.map { |element| "#{element[:name]} (#{element[:place]})" }.join("\n"),
                  row.tests.map { |test| "#{test[:result]}: #{test[:test]} (#{test[:file]})" }.join("\n"),
                  row.verdict]
        end
      end
    end

    def proved_csv
      CSV.generate do |out|
        out << FunctionProofs::Row.members
        @functions.rows.each { |row| out << row.to_a.map { |cell| Array(cell).join(' ') } }
      end
    end

    def h(text)
      ERB::Util.html_escape(text)
    end
  end
end
