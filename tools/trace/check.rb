# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'evidence'
require_relative 'requirements'
require_relative 'sources'

module Trace
  # Everything a check or a matrix looks at.
  class Project
    attr_reader :root, :requirements, :sources, :evidence

    def initialize(root, with_results: true)
      @root = root
      @requirements = Requirements.load('requirements', root)
      @sources = Sources.new(root)
      @evidence = Evidence.new(root, with_results ? Dir.glob('build/results/*.json', base: root).sort : [])
      mark_empty_tests
    end

    def results
      @evidence.results
    end

    # `pass`, `fail` or `not verified`, the worst of all results that name the requirement.
    def verdict(id)
      mine = results_of(id)
      return 'not verified' if mine.empty?
      return 'fail' if mine.any? { |result| result.result == 'fail' && !result.doubt }

      mine.all?(&:good?) ? 'pass' : 'not verified'
    end

    def results_of(id)
      @results_by_id ||= results.each_with_object(Hash.new { |hash, key| hash[key] = [] }) do |result, map|
        result.requirements.uniq.each { |requirement| map[requirement] << result }
      end
      @results_by_id.fetch(id, [])
    end

    def elements_of(id)
      sources.elements.select { |element| element.requirement == id }
    end

    private

    # Unity does not count assertions; the text stands in for the count.
    def mark_empty_tests
      empty = sources.tests.select(&:is_empty).map { |test| [test.place.file, test.name] }
      results.each do |result|
        result.assertions ||= 0 if empty.include?([result.file, result.function])
      end
    end
  end

  # A finding, printed as one line.
  Finding = Struct.new(:code, :place, :text) do
    def to_s
      "TRACE-#{code} #{place}: #{text}"
    end
  end

  # Looks for everything that is wrong in a project.
  #
  # @satisfies SWR-TRACE-001
  class Check
    FIELDS = { 'SWR' => %w[title text parents source verification], 'RC' => %w[title text kind parents],
               'HAZ' => %w[title severity situation harm], 'LIM' => %w[title text shown_by] }.freeze
    METHODS = %w[test proof].freeze
    LEVELS = %w[unit integration system console tool].freeze
    KINDS = %w[design protective information].freeze
    SCENE = /\Arobot=\w+&seed=\d+&inputs=\d+:[\w,=\/;:-]+\z/
    OPENING = /\A(?:While|When|If|Where|The)\b/

    def initialize(project)
      @project = project
      @findings = []
    end

    def static
      check_items
      check_parents
      check_children
      check_elements
      check_controls
      check_declarations
      check_shown
      sorted
    end

    def all
      static
      check_origin
      check_results
      check_executed
      check_verdicts
      sorted
    end

    private

    def sorted
      @findings.uniq.sort_by { |finding| [finding.code, finding.place.file, finding.place.line, finding.text] }
    end

    def complain(code, place, text)
      @findings << Finding.new(code, place, text)
    end

    def items
      @project.requirements.items
    end

    def known
      @known ||= items.to_h { |item| [item.id, item] }
    end

    def check_items
      items.group_by(&:id).each_value do |same|
        same.drop(1).each do |item|
          complain('E08', item.place, "#{item.id} is already used at #{same.first.place}")
        end
      end
      items.each do |item|
        check_fields(item)
        check_scene(item)
        check_sentence(item) if item.kind == 'SWR'
      end
    end

    def check_fields(item)
      fields = FIELDS[item.kind]
      return complain('E15', item.place, "#{item.id} is neither HAZ-, RC-, SWR- nor LIM-") unless fields

      missing = fields.select { |field| item[field].nil? || item[field].empty? }
      complain('E15', item.place, "#{item.id} lacks #{missing.join(', ')}") unless missing.empty?
      check_word(item, 'kind', item['kind'], KINDS) if item.kind == 'RC'
      return unless item.kind == 'SWR'

      check_word(item, 'level', item['verification'].to_h['level'], LEVELS)
      check_word(item, 'method', item['verification'].to_h['method'], METHODS)
    end

    # The reaction of the robot to it is tested by verification/site/test_scenes.rb.
    #
    # @satisfies SWR-SITE-019
    def check_scene(item)
      return unless %w[scene expects no_scene].any? { |field| item[field] }

      whole = item.scene&.match?(SCENE) && Array(item['expects']).any? && !item['no_scene']
      reason = item['no_scene'] && !item['scene'] && !item['expects']
      return if item.kind == 'HAZ' && (whole || reason)

      complain('E15', item.place, "#{item.id} has neither a scene and what it expects nor a reason why it has none")
    end

    def check_word(item, field, word, known_words)
      return if known_words.include?(word)

      complain('E15', item.place, "#{item.id} has the unknown #{field} #{word.inspect}")
    end

    def check_sentence(item)
      text = item['text'].to_s
      count = text.scan(/\bshall\b/i).size
      complain('E10', item.place, "#{item.id} says shall #{count} times instead of once") unless count == 1
      opens = text.match?(OPENING)
      complain('E15', item.place, "#{item.id} does not begin with While, When, If, Where or The") unless opens
      text.scan(/\{(\w+)\}/).flatten.each do |name|
        next if @project.requirements.limits_by_name.key?(name)

        complain('E15', item.place, "#{item.id} speaks of the unknown limit #{name}")
      end
    end

    def check_parents
      items.each do |item|
        item.parents.each do |parent|
          complain('E09', item.place, "#{item.id} has the unknown parent #{parent}") unless known.key?(parent)
        end
        next unless item.kind == 'SWR' && item.parents.empty? && !item.derived?

        complain('E14', item.place, "#{item.id} has neither a parent nor a `derived: reason`")
      end
    end

    def check_children
      used = items.flat_map { |item| item.parents.map { |parent| [item.kind, parent] } }
      { 'RC' => ['SWR', 'E11', 'is carried out by no requirement'], 'HAZ' => ['RC', 'E12', 'has no risk control'] }
        .each do |kind, (child_kind, code, text)|
          @project.requirements.of_kind(kind).each do |item|
            complain(code, item.place, "#{item.id} #{text}") unless used.include?([child_kind, item.id])
          end
        end
    end

    def check_elements
      elements = @project.sources.elements
      elements.each do |element|
        next if known.key?(element.requirement)

        complain('E01', element.place, "#{element.name} names the unknown id #{element.requirement}")
      end
      satisfied = elements.map(&:requirement)
      @project.requirements.of_kind('SWR').each do |item|
        next if satisfied.include?(item.id)

        complain('E07', item.place, "#{item.id} is fulfilled by no function or chart")
      end
    end

    # The control of a chart's element must follow from its requirements.
    def check_controls
      @project.sources.controls.each do |control|
        next complain('E01', control.place, "#{control.name} names the unknown hazard #{control.hazard}") \
          unless known.key?(control.hazard)
        next if control.requirements.any? { |id| hazards_of(id).include?(control.hazard) }

        complain('E17', control.place, "#{control.name} names #{control.hazard}, which no requirement of it controls")
      end
    end

    def hazards_of(requirement)
      controls = known[requirement]&.parents || []
      controls.flat_map { |id| known[id]&.parents || [] }
    end

    def check_declarations
      @project.sources.tests.each do |test|
        check_name(test.name, test.place)
        complain('E06', test.place, "#{test.name} asserts nothing") if test.is_empty
      end
    end

    # A limit that no test shows may have gone.
    #
    # @satisfies SWR-TOOL-031
    def check_shown
      there = @project.sources.tests.map(&:name)
      @project.requirements.of_kind('LIM').each do |item|
        (Array(item['shown_by']) - there).each { |name| complain('E19', item.place, "#{item.id} is shown by #{name}, which is not there") }
      end
    end

    def check_name(name, place)
      ids = Trace.ids_in(name)
      complain('E02', place, "#{name} names no requirement") if ids.empty?
      ids.reject { |id| known.key?(id) }.each { |id| complain('E01', place, "#{name} names the unknown id #{id}") }
    end

    # Results from elsewhere prove nothing about the present tree.
    #
    # @satisfies SWR-TRACE-003
    def check_origin
      @project.evidence.doubts.each do |file, doubt|
        complain('E18', Place.new(file, 1), "its results do not count, #{doubt}")
      end
    end

    def check_results
      @project.results.each do |result|
        place = place_of(result)
        check_name(result.test, place)
        case result.result
        when 'pass' then complain('E06', place, "#{result.function} asserts nothing") if result.empty?
        when 'fail' then complain('E04', place, "#{result.test} failed")
        when 'ignore' then complain('E05', place, "#{result.test} was ignored")
        else complain('E04', place, "#{result.test} has the unknown result #{result.result.inspect}")
        end
      end
    end

    def place_of(result)
      @places ||= @project.sources.tests.to_h { |test| [[test.place.file, test.name], test.place] }
      @places.fetch([result.file, result.function], Place.new(result.file, 1))
    end

    # Stale results are those of tests that are gone; forgotten tests have no results.
    def check_executed
      ran = @project.results.map { |result| [result.file, result.function] }
      @project.sources.tests.each do |test|
        complain('E13', test.place, "#{test.name} was not executed") unless ran.include?([test.place.file, test.name])
      end
      check_gone(ran.uniq)
    end

    def check_gone(ran)
      declared = @project.sources.tests.map { |test| [test.place.file, test.name] }
      (ran - declared).select { |file, _| file.match?(/\.(?:c|rb)\z/) }.each do |file, name|
        next if defined_at_run_time?(file, name)

        complain('E13', Place.new(file, 1), "#{name} has a result but is not there")
      end
    end

    # A Ruby test may be made by define_method("test_..._#{case}"), or be named by a literal.
    def defined_at_run_time?(file, name)
      path = File.join(@project.root, file)
      return false unless file.end_with?('.rb') && File.exist?(path)

      text = File.read(path)
      beginnings = text.scan(/define_method\("(test_[^#"]*)#\{/).flatten
      beginnings.any? { |beginning| name.start_with?(beginning) } || text.include?("'#{name}'")
    end

    def check_verdicts
      @project.requirements.of_kind('SWR').each do |item|
        passed = @project.results_of(item.id).select(&:passed?)
        next complain('E03', item.place, "#{item.id} has no passed test") if passed.empty?

        levels = passed.map(&:level).compact.uniq
        next check_proof(item, levels) if item['verification'].to_h['method'] == 'proof'

        check_level(item, item['verification'].to_h['level'], levels)
      end
    end

    # No test stands in for a proof.
    #
    # @satisfies SWR-TRACE-200
    def check_proof(item, levels)
      complain('E20', item.place, "#{item.id} is to be proved, and no proof of it has passed") unless levels.include?('proof')
    end

    # A test of the whole stands in for one of a part, not the other way round.
    def check_level(item, wanted, levels)
      larger = %w[unit integration system].drop_while { |level| level != wanted }
      return if levels.include?(wanted) || (levels & larger).any?

      complain('E16', item.place, "#{item.id} is to be tested at level #{wanted}, it is at #{levels.join(', ')}")
    end
  end
end
