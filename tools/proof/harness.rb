# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'fileutils'
require 'psych'
require_relative 'cbmc'
require_relative 'wp'

module Proof
  class Refused < StandardError; end

  # A fault that the prover must refute: `before` stands in `file` once, and `after` in its place breaks a sentence of
  # the function `by`, or, where functions are proved against contracts, that of the function `in`.
  Mutant = Struct.new(:file, :before, :after, :by, :in, keyword_init: true) do
    # Writes it below `folder`, where it is found before the file itself.
    def write(folder)
      text = File.read(file)
      count = text.scan(before).size
      raise Refused, "#{file} has the text of a mutant #{count} times instead of once: #{before}" unless count == 1

      path = File.join(folder, file)
      FileUtils.mkdir_p(File.dirname(path))
      File.write(path, text.sub(before) { after })
      path
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
    LEMMA = /^static void (lemma_\w+)\(/.freeze
    INCLUDES = [FOLDER, 'core', 'build/gen'].freeze
    UNWIND = 12

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
      prover(@sources, function, @includes).run
    end

    # All functions of which it says something, whichever prover looks at them.
    def functions_proved
      @proves + @by_contract
    end

    # The prover, as the list of functions names it.
    def tool
      @by_contract.empty? ? 'cbmc' : 'wp'
    end

    # The same with a fault in it. A sentence is to be refuted, so nothing else is checked: that takes half of the time.
    def run_mutant(mutant, folder)
      FileUtils.rm_rf(folder)
      changed = mutant.write(folder)
      sources = @sources.map { |source| source == mutant.file ? changed : source }
      includes = [File.join(folder, 'core'), File.join(folder, 'build/gen'), *@includes]
      prover(sources, mutant.by, includes, broken: mutant.in, checks: false).run
    end

    private

    def prover(sources, function, includes, broken: nil, checks: true)
      return Cbmc.new(sources, function, includes: includes, unwind: @unwind, checks: checks) if tool == 'cbmc'

      Wp.new(@file, function, lemmas + @by_contract, includes: includes, broken: broken)
    end

    # Functions of the harness that show what a solver does not find on its own; others rely on their contracts.
    #
    # @satisfies SWR-TOOL-800
    def lemmas
      File.read(@file).scan(LEMMA).flatten
    end
  end
end
