# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'requirements'

module Trace
  # Something that claims to fulfil a requirement: a declaration or a chart's element.
  Element = Struct.new(:requirement, :name, :place, keyword_init: true)

  # A hazard that a chart's element says it controls, with the requirements of that element.
  Control = Struct.new(:hazard, :requirements, :name, :place, keyword_init: true)

  # A test as it stands in the sources. `is_empty` is nil where that cannot be seen in the text.
  Declaration = Struct.new(:name, :is_empty, :place, keyword_init: true)

  # Finds `@satisfies`, `bs:req`, `bs:hazard` and tests below a project's root.
  class Sources
    CODE = '{{core,bsp,app,site,tools}/**/*.{h,c,rb,ts,tsx,yml},verification/bound/*.rb,tools/{bootstrap,run_long}}'
    CHARTS = 'statecharts/*.scxml'
    C_TESTS = '{verification/unit,verification/integration,core/robot/*/test,build/gen/tests}/**/test_*.c'
    PROOFS = 'verification/proof/**/prove_*.c'
    PROOF_LIST = 'verification/proof/proofs.yml'
    # A sentence of a proof by contract; another comment says nothing.
    CHECK = %r{/\*@\s*check\b}.freeze
    RUBY_TESTS = '{verification,tools/test,tools/chartc}/**/test_*.rb'
    SUPPORT = 'verification/unit/support/*.{h,c}'
    PART = /^#include "([^"]+\.inc)"$/.freeze
    LEFT_OUT = %r{node_modules/|/dist/|tools/test/|tools/chartc/(?:conformance|faults|proof|test)/|\.test\.tsx?\z|\.spec\.ts\z}

    SATISFIES = %r{\A\s*(?:/\*\*|\*|\#|//+)\s*@satisfies\s+(.+?)\s*(?:\*/\s*)?\z}
    COMMENT = %r{\A\s*(?:/\*|\*|\#|//|\z)}
    TAG = /<([\w:]+)((?:\s+[\w:]+\s*=\s*"[^"]*")+)\s*\/?>/m

    def initialize(root)
      @root = root
    end

    def elements
      @elements ||= code_elements + chart_elements
    end

    def controls
      chart_tags.flat_map do |tag|
        ids(tag, 'bs:hazard').map do |id|
          Control.new(hazard: id, requirements: ids(tag, 'bs:req'), name: tag[:name], place: tag[:place])
        end
      end
    end

    def tests
      @tests ||= c_tests + ruby_tests + proofs
    end

    private

    def glob(pattern)
      Dir.glob(pattern, base: @root).sort
    end

    def read(file)
      File.read(File.join(@root, file), encoding: 'UTF-8')
    end

    def code_elements
      glob(CODE).grep_v(LEFT_OUT).flat_map do |file|
        lines = read(file).lines
        lines.each_with_index.filter_map do |line, index|
          next unless (id = line[SATISFIES, 1])

          Element.new(requirement: id, name: declared_after(lines, index) || File.basename(file),
                      place: Place.new(file, index + 1))
        end
      end
    end

    # The name of what the comment at `index` stands before; nil for a comment on the whole file.
    def declared_after(lines, index)
      rest = lines.drop(index + 1).drop_while { |line| line.match?(COMMENT) }.first(8).join
      rest = rest[/\A(?:(?:private_class_method|export|default|async|extern|static|const|inline)\s+)*(.*)/m, 1]
      case rest
      when /\A#/ then nil
      when /\Atypedef\s[^;{]*(?:\{.*?\})?\s*(\w+)\s*;/m,
           /\A\s*(?:def(?:\s+self\.)?|class|module|function|const|let|interface|type)\s*([\w.?!]+)/,
           /\A[^;={(]*?(\w+)\s*(?:\(|\[|=|;)/m
        Regexp.last_match(1)
      end
    end

    def chart_elements
      chart_tags.flat_map do |tag|
        ids(tag, 'bs:req').map { |id| Element.new(requirement: id, name: tag[:name], place: tag[:place]) }
      end
    end

    # The attributes of every element of a chart, with its name and place.
    def chart_tags
      @chart_tags ||= glob(CHARTS).flat_map do |file|
        text = read(file)
        text.enum_for(:scan, TAG).map do
          match = Regexp.last_match
          attributes = match[2].scan(/([\w:]+)\s*=\s*"([^"]*)"/).to_h
          { attributes: attributes, place: Place.new(file, text[0...match.begin(0)].count("\n") + 1),
            name: "#{File.basename(file, '.scxml')} #{attributes['bs:id'] || attributes['id'] || match[1]}" }
        end
      end
    end

    def ids(tag, attribute)
      tag[:attributes].fetch(attribute, '').split(/[\s,]+/)
    end

    def c_tests
      helpers = glob(SUPPORT).flat_map { |file| callables(file) }
      glob(C_TESTS).flat_map do |file|
        functions = CFunctions.new(read(file))
        asserting = functions.asserting(helpers + included(file).flat_map { |part| callables(part) })
        functions.all.select { |function| function.name.start_with?('test_') }.map do |function|
          Declaration.new(name: function.name, is_empty: !asserting.include?(function.name),
                          place: Place.new(file, function.line))
        end
      end
    end

    def callables(file)
      CFunctions.new(read(file)).callables
    end

    # Parts that a test shares with another one.
    def included(file)
      read(file).scan(PART).flatten.flat_map { |part| glob("{verification/#{part},#{part},core/#{part}}") }
    end

    # What a harness of the prover proves in every run of the gate; what is for the night has no result by day.
    def proofs
      file = File.join(@root, PROOF_LIST)
      at_night = File.exist?(file) ? Psych.safe_load_file(file).flat_map { |row| row.fetch('night', []) } : []
      glob(PROOFS).flat_map do |harness|
        functions = CFunctions.new(read(harness).gsub(CHECK, 'PROVE'))
        proving = functions.asserting
        functions.all.select { |function| function.name.start_with?('prove_SWR') && !at_night.include?(function.name) }.map do |function|
          Declaration.new(name: function.name, is_empty: !proving.include?(function.name), place: Place.new(harness, function.line))
        end
      end
    end

    # Assertions of Ruby tests are counted when they run.
    def ruby_tests
      glob(RUBY_TESTS).flat_map do |file|
        read(file).lines.each_with_index.filter_map do |line, index|
          name = line[/\A\s*def\s+(test_\w+)/, 1]
          Declaration.new(name: name, place: Place.new(file, index + 1)) if name
        end
      end
    end
  end

  # The functions a C file defines, found by their braces in text without comments and strings.
  class CFunctions
    Function = Struct.new(:name, :line, :body, keyword_init: true)

    NOISE = %r{/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'}m
    HEAD = /^[A-Za-z_][\w \t*]*?\b(\w+)\s*\([^;{}]*\)\s*\{/
    ASSERTION = /\b(?:TEST_ASSERT\w*|TEST_FAIL\w*|EXPECT_CONTRACT|UNITY_TEST_\w+|TEST_IGNORE\w*|PROVE)\b/

    attr_reader :all

    def initialize(text)
      @text = text.gsub(NOISE) { |noise| noise.gsub(/[^\n]/, ' ') }
      @all = @text.enum_for(:scan, HEAD).map do
        match = Regexp.last_match
        Function.new(name: match[1], line: @text[0...match.begin(0)].count("\n") + 1,
                     body: body(match.end(0) - 1))
      end
      @macros = macros
    end

    # Functions and macros.
    def callables
      all + @macros
    end

    # Names of all functions and macros that assert, by themselves or through one they call.
    def asserting(helpers = [])
      known = callables + helpers
      words = known.to_h { |callable| [callable, callable.body.scan(/\w+/).uniq] }
      names = known.select { |callable| callable.body.match?(ASSERTION) }.map(&:name)
      loop do
        more = known.reject { |callable| names.include?(callable.name) }
                    .select { |callable| words[callable].intersect?(names) }
        return names if more.empty?

        names |= more.map(&:name)
      end
    end

    private

    def body(start)
      depth = 0
      position = start
      while (position = @text.index(/[{}]/, position))
        depth += @text[position] == '{' ? 1 : -1
        return @text[start..position] if depth.zero?

        position += 1
      end
      @text[start..]
    end

    def macros
      @text.scan(/^\s*#\s*define\s+(\w+)\([^)]*\)((?:[^\n]*\\\n)*[^\n]*)/).map do |name, text|
        Function.new(name: name, line: 0, body: text)
      end
    end
  end
end
