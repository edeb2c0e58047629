# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

module Gates
  # Why a gate is red: a test with its place, or what stands in the log, and the first lines of what it says.
  class Complaint
    LINES = 12
    # Lines that explain it best: those of compilers, checkers and the trace about a place; then lines that call themselves
    # an error. The lines of make are noise.
    TELLING = [/\A(?:TRACE-E\d+ )?[^\s:]+:\d+:.*\S/, /\b(?:error|fatal|abort|cannot|could not)\b|[a-z]Error\b/i].freeze
    NOISE = /\A\s*\z|\Amake(?:\[\d+\])?: |\A\s+from /
    COLOUR = /\e\[[\d;]*m/

    attr_reader :lines

    class << self
      def of_test(test)
        place = [test['file'], test['line']].compact.join(':')
        said = test['message'] || "its result is #{test['result']}"
        new("#{test['test']} (#{place})", said.lines(chomp: true).grep(/\S/))
      end

      def of_log(log)
        lines = File.readlines(log, chomp: true).map { |line| line.scrub.gsub(COLOUR, '') }.grep_v(NOISE)
        new(log, TELLING.map { |pattern| lines.grep(pattern) }.find(&:any?) || lines.last(1))
      end
    end

    def initialize(title, lines)
      @title = title
      @lines = lines
    end

    def to_s
      more = @lines.size - LINES
      rest = more.positive? ? ["(#{more} more lines)"] : []
      [@title, *(@lines.first(LINES) + rest).map { |line| "    #{line}" }].join("\n")
    end
  end
end
