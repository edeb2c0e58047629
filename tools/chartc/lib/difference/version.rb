# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'psych'
require_relative '../compiled'

module Chart
  # One version of the charts, a folder or one file. What today's profile refuses is read as far as it can be: a
  # difference to a version of another time is worth most where the rules have changed as well.
  class Version
    WORST_CASE = '../verification/model/worst_case.yml'

    # refusals: those of today's profile, at most one of each chart.
    attr_reader :charts, :refusals

    # The charts of a folder, or the one file.
    def self.files(path)
      File.file?(path) ? [path] : Dir[File.join(path, '*.scxml')].sort
    end

    # Content of the table beside a chart folder, nil if there is none.
    def self.worst_case(path)
      folder = File.file?(path) ? File.dirname(path) : path
      file = File.join(folder, WORST_CASE)
      Psych.safe_load_file(file) if File.exist?(file)
    end

    def initialize(path, limits)
      @path = path
      @limits = limits
      @refusals = []
      @charts = Version.files(path).map { |file| read(file) }
    end

    def file?
      File.file?(@path)
    end

    def names
      @charts.map { |chart| chart.document.name }
    end

    # For the comparison with one file.
    def keep(names)
      @charts.select! { |chart| names.include?(chart.document.name) }
    end

    def worst_case
      Version.worst_case(@path)
    end

    private

    def read(file)
      text = File.read(file, encoding: 'UTF-8')
      begin
        Compiled.from(file, text, @limits)
      rescue Refusal => e
        @refusals << e
        Compiled.leniently(file, text, @limits)
      end
    end
  end
end
