# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'psych'

module Proof
  # The functions with their proofs, as Coverage finds them, in a file: a proof that is in it must not be lost.
  class ProvedList
    FILE = 'verification/proof/proved.yml'
    # Eva follows this robot for the list.
    ROBOT = 'neuro'
    PROOFS = %w[cbmc wp eva].freeze
    HEAD = <<~TEXT
      # SPDX-License-Identifier: Apache-2.0
      # Every function of the core and of the charts: `cbmc`, a harness of proofs.yml names it; `wp`, one names it by its contract;
      # `eva`, Eva has reached it and no alarm in it is open; `open`, one is; `unreached`, Eva has not come to it. Written by
      # `make eva-list`, which adds proofs and removes none: where a proof is given up, its word is removed by hand.
    TEXT

    attr_reader :states

    def self.read(file = FILE)
      content = File.exist?(file) ? Psych.safe_load_file(file) : {}
      new(file, content.flat_map { |source, rows| rows.map { |name, state| [[source, name], state] } }.to_h)
    end

    # states: by [file, name]
    def initialize(file, states)
      @file = file
      @states = states
    end

    # One line each; none if the proofs are those of the list.
    #
    # @satisfies SWR-TOOL-280
    # @satisfies SWR-TOOL-281
    def problems(found)
      (found.keys - @states.keys).map { |function| "function that is not listed: #{function.join(': ')}" } +
        (@states.keys - found.keys).map { |function| "listed function that is gone: #{function.join(': ')}" } +
        (@states.keys & found.keys).flat_map { |function| changed(function, @states[function], found[function]) }
    end

    # What is found becomes the list; a function that is still there keeps its proofs.
    #
    # @satisfies SWR-TOOL-282
    def replace(found)
      @states = found.to_h do |function, state|
        proofs = PROOFS & (proofs_of(@states[function]) + proofs_of(state))
        [function, proofs.empty? ? state : proofs.join(' ')]
      end
    end

    def save
      tree = @states.sort.each_with_object({}) { |((file, name), state), files| (files[file] ||= {})[name] = state }
      File.write(@file, HEAD + Psych.dump(tree, line_width: -1))
    end

    # In one sentence.
    def summary
      kinds = @states.values
      proved, other = kinds.partition { |state| proofs_of(state).any? }
      counts = PROOFS.map { |proof| proved.count { |state| proofs_of(state).include?(proof) } }
      "Under the assumptions, contracts and limits of SOUNDNESS.md, #{proved.size} of #{kinds.size} functions of the core and of the " \
        "charts are free of run-time errors: #{counts[0]} by CBMC, #{counts[1]} by WP, #{counts[2]} by Eva for the robot #{ROBOT}. " \
        "#{other.count('open')} have open alarms, #{other.count('unreached')} are not reached by Eva."
    end

    private

    def changed(function, listed, found)
      return [] if listed == found

      place = function.join(': ')
      lost = proofs_of(listed) - proofs_of(found)
      gained = proofs_of(found) - proofs_of(listed)
      lines = lost.map { |proof| "no longer proved by #{proof}: #{place} (now #{found})" } +
              gained.map { |proof| "proved by #{proof}, but not listed so: #{place}" }
      lines.empty? ? ["listed as #{listed}, but #{found}: #{place}"] : lines
    end

    def proofs_of(state)
      state.to_s.split & PROOFS
    end
  end
end
