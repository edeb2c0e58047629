# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'json'
require 'open3'

module Proof
  # One run of the prover over one function of a harness, and what it says of each property.
  class Cbmc
    ROOT = '.tools/prover/root'
    LIBRARIES = %w[usr/lib/x86_64-linux-gnu usr/lib].map { |folder| File.join(ROOT, folder) }.join(':')
    # Run by its own loader: nothing of it is installed.
    PROGRAM = [File.join(ROOT, 'usr/lib64/ld-linux-x86-64.so.2'), '--library-path', LIBRARIES,
               File.join(ROOT, 'usr/bin/cbmc')].freeze
    # Bounds, pointers, signed overflow, shifts, divisions and ends of loops are checked unless switched off.
    OPTIONS = %w[--c99 --drop-unused-functions --slice-formula --json-ui].freeze
    # Of processor time: a machine that has more to do makes no proof red.
    MOST_SECONDS = 300
    # Ends with its parent, however that ends.
    BOUND = %w[setpriv --pdeathsig KILL].freeze
    LIMIT = ['prlimit', "--cpu=#{MOST_SECONDS}", *BOUND].freeze

    # What holds is a sentence, or a check of its own; what it begins with by which prove.h has made it.
    Property = Struct.new(:text, :place, :function, :holds, keyword_init: true) do
      def possible?
        text.start_with?('possible: ')
      end

      def sentence?
        text.match?(/\A(SWR-|contract of )/)
      end

      # The function that is called here, and has neither a body nor a contract.
      def missing
        text[/\Ano body for callee (\w+)\z/, 1] unless holds
      end
    end

    # properties: nil without an answer, which `trouble` explains.
    Answer = Struct.new(:properties, :trouble, :seconds, keyword_init: true)

    # Sentences alone.
    SENTENCES = %w[--no-standard-checks].freeze

    # includes: folders, the first one is looked into first; checks: beside the sentences, what may not happen in any C program.
    def initialize(sources, function, includes:, unwind:, checks: true)
      @command = [*PROGRAM, *OPTIONS, *(SENTENCES unless checks), '--function', function, '--unwind', unwind.to_s,
                  *includes.flat_map { |folder| ['-I', folder] }, *sources]
    end

    # @satisfies SWR-TOOL-510
    def run
      began = Process.clock_gettime(Process::CLOCK_MONOTONIC)
      text, = Open3.capture2e(*BOUND, *LIMIT, *@command)
      seconds = Process.clock_gettime(Process::CLOCK_MONOTONIC) - began
      Answer.new(**read(text), seconds: seconds)
    end

    private

    def read(text)
      document = JSON.parse(text)
      rows = document.filter_map { |part| part['result'] }.first
      return { properties: rows.map { |row| property(row) } } if rows

      said = document.filter_map { |part| part['messageText'] if part['messageType'] == 'ERROR' }
      { trouble: said.empty? ? 'it gave no verdict' : said.join(' ') }
    rescue JSON::ParserError
      { trouble: "no answer within #{MOST_SECONDS} s" }
    end

    def property(row)
      place = row.fetch('sourceLocation', {}).values_at('file', 'line').compact.join(':')
      Property.new(text: row['description'], place: place, function: row.dig('sourceLocation', 'function'),
                   holds: row['status'] == 'SUCCESS')
    end
  end
end
