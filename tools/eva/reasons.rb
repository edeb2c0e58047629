# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

module Eva
  # A reason why an alarm cannot happen names the lines that it rests on, each behind its file and between grave accents.
  # It is void once one of them has changed.
  class Reasons
    LINE = /(\S+) `([^`]+)`/.freeze

    def initialize(root = '.')
      @root = root
      @files = Hash.new { |known, file| known[file] = read(file) }
    end

    # One line each, of the reasons by the place of their alarm.
    #
    # @satisfies SWR-TOOL-500
    def problems(reasons)
      reasons.flat_map do |place, reason|
        lines = reason.scan(LINE)
        next ["reason without a line of a source: #{place}"] if lines.empty?

        lines.reject { |file, text| @files[file].include?(squeeze(text)) }
             .map { |file, text| "line of a reason is gone: #{place}: #{file} `#{text}`" }
      end
    end

    private

    def read(file)
      path = File.join(@root, file)
      File.file?(path) ? squeeze(File.read(path)) : ''
    end

    def squeeze(text)
      text.split.join(' ')
    end
  end
end
