# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'yaml'
require_relative 'trial'

module Faults
  SEEDS = File.join(__dir__, 'seeds')

  # says: what is wrong, in words. file: below tools/chartc/lib. from, to: its text, which stands there once, and what comes
  # in its place. charts: the names of those on which it must show.
  Fault = Struct.new(:says, :file, :from, :to, :charts, keyword_init: true) do
    def self.all
      Dir[File.join(SEEDS, '*.yml')].sort.flat_map { |list| YAML.safe_load_file(list).to_a }.flat_map do |file, rows|
        rows.map { |row| new(file: file, **row.transform_keys(&:to_sym), charts: [*row.fetch('charts')]) }
      end
    end

    # As a part of a test's name.
    def stem
      says.downcase.gsub(/[^a-z0-9]+/, '_').delete_prefix('_')
    end
  end

  # trials: "chart, shape" => verdicts. unfit: why there is none.
  Result = Struct.new(:fault, :trials, :unfit) do
    # Versions that no check rejects.
    def accepted
      trials.select { |_version, verdicts| verdicts.values.none? }.keys
    end

    def rejected?
      trials.any? && accepted.empty?
    end

    # In the order of the checks, those that reject.
    def rejected_by
      Trial::CHECKS.select { |check| trials.each_value.any? { |verdicts| verdicts[check] } }
    end

    # It compiles without a warning, and wherever it shows it behaves wrongly.
    def behaves_wrongly?
      trials.any? && trials.each_value.all? do |verdicts|
        verdicts['C compiler'].nil? && verdicts.values_at(*Trial::BEHAVIOUR).any?
      end
    end
  end
end
