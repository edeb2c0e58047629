# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'fileutils'
require 'psych'
require_relative 'cbmc'
require_relative 'exhaustive'
require_relative 'wp'

module Proof
  class Refused < StandardError; end

  # `text` of `file` with `after` in place of `before`, which is in it once.
  def self.replace(text, file, before, after, what)
    count = text.scan(before).size
    raise Refused, "#{file} has the text of #{what} #{count} times instead of once: #{before}" unless count == 1

    text.sub(before) { after }
  end

  # Knowledge of a loop or a value that a solver does not find: `says`, lines for Frama-C, stand as comments in `file` before the
  # text `before`, which is there once. The code stays as it is.
  Annotation = Struct.new(:file, :before, :says, keyword_init: true) do
    # @satisfies SWR-TOOL-801
    def change(text)
      lines = says.map do |line|
        # Each of them is proved itself; others are believed.
        raise Refused, "an annotation of #{file} is no assert, lemma or loop: #{line}" unless line.match?(/\A(?:assert|ghost lemma_\w+\(|loop) ?/)
        raise Refused, "an annotation of #{file} ends its comment: #{line}" if line.include?('*/')

        "/*@ #{line} */\n"
      end
      Proof.replace(text, file, before, lines.join + before, 'an annotation')
    end
  end

  # A fault that the prover must refute: `before` stands in `file` once, and `after` in its place breaks a sentence of
  # the function `by`, or, where functions are proved against contracts, that of the function `in`.
  Mutant = Struct.new(:file, :before, :after, :by, :in, keyword_init: true) do
    # The text of `file` with the fault.
    def change(text)
      Proof.replace(text, file, before, after, 'a mutant')
    end

    def name
      "#{by} (#{file}: #{before.split.join(' ')} => #{after.split.join(' ')})"
    end
  end

  # A file of verification/proof with the functions that the prover runs, as proofs.yml lists it.
  class Harness
    LIST = 'verification/proof/proofs.yml'
    FOLDER = 'verification/proof'
    FUNCTION = /^void (prove_\w+)\(void\)$/
    # Of C, or for Frama-C alone.
    LEMMA = /^(?:static|  )? ?void (lemma_\w+)\(/.freeze
    INCLUDES = [FOLDER, 'core', 'build/gen'].freeze
    UNWIND = 12
    CHANGED = 'build/proof/annotated'

    attr_reader :file, :sources, :proves, :by_contract, :mutants

    def self.all(list = LIST)
      Psych.safe_load_file(list).map { |row| new(row) }
    end

    def initialize(row)
      @file = File.join(FOLDER, row.fetch('file'))
      @sources = [@file, *row.fetch('sources')]
      @proves = row.fetch('proves', [])
      @by_contract = row.fetch('by_contract', [])
      @unwind = row.fetch('unwind', UNWIND)
      @instead = row['instead']
      @includes = [*@instead, *INCLUDES]
      @night = row.fetch('night', [])
      @is_run = row.fetch('run', false)
      @seconds = row.fetch('seconds', Wp::GOAL_SECONDS)
      @annotations = row.fetch('annotations', []).map { |one| Annotation.new(**one.transform_keys(&:to_sym)) }
      @mutants = row.fetch('mutants').map { |mutant| Mutant.new(**mutant.transform_keys(&:to_sym)) }
    end

    # Files that stand in place of neighbours of what is proved.
    def contracts
      @sources.grep(%r{\A#{FOLDER}/contract/}) + (@instead ? Dir.glob("#{@instead}/**/*.h").sort : [])
    end

    # The functions to be run, and their lines; at night all of them.
    def functions(at_night:)
      lines = File.readlines(@file, chomp: true)
      found = lines.each_with_index.filter_map { |line, index| [line[FUNCTION, 1], index + 1] if line.match?(FUNCTION) }.to_h
      raise Refused, "#{LIST} sends to the night what #{@file} has not: #{(@night - found.keys).join(', ')}" unless (@night - found.keys).empty?

      at_night ? found : found.except(*@night)
    end

    def run(function)
      folder = File.join(CHANGED, function)
      write(folder, @annotations)
      prover(@sources, function, folder).run
    end

    # All functions of which it says something, whichever prover looks at them.
    def functions_proved
      @proves + @by_contract
    end

    # The prover, as the list of functions names it.
    def tool
      return 'run' if @is_run

      @by_contract.empty? ? 'cbmc' : 'wp'
    end

    # The same with a fault in it. A sentence is to be refuted, so nothing else is checked: that takes half of the time.
    def run_mutant(mutant, folder)
      write(folder, [*@annotations, mutant])
      sources = @sources.map { |source| source == mutant.file ? File.join(folder, source) : source }
      prover(sources, mutant.by, folder, broken: mutant.in, checks: false).run
    end

    private

    # Files with their changes below `folder`, where they are found before the files themselves.
    def write(folder, changes)
      FileUtils.rm_rf(folder)
      changes.group_by(&:file).each do |file, same|
        path = File.join(folder, file)
        FileUtils.mkdir_p(File.dirname(path))
        File.write(path, same.reduce(File.read(file)) { |text, change| change.change(text) })
      end
    end

    def within(folder)
      [File.join(folder, 'core'), File.join(folder, 'build/gen'), *@includes]
    end

    # folder: of the changed files.
    def prover(sources, function, folder, broken: nil, checks: true)
      includes = within(folder)
      case tool
      when 'run' then Exhaustive.new(@file, function, includes: includes, folder: folder)
      when 'cbmc' then Cbmc.new(sources, function, includes: includes, unwind: @unwind, checks: checks)
      else Wp.new(@file, function, lemmas + @by_contract, includes: includes, seconds: @seconds, broken: broken)
      end
    end

    # Functions of the harness that show what a solver does not find on its own; others rely on their contracts.
    #
    # @satisfies SWR-TOOL-800
    def lemmas
      File.read(@file).scan(LEMMA).flatten
    end
  end
end
