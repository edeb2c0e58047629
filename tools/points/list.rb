# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

module Points
  # Where the robot should have been and where it was measured, in one frame, mm.
  Point = Struct.new(:target, :measured) do
    def error
      measured - target
    end
  end

  # A file that is not a list of points; the message begins with file and line.
  class Refused < StandardError; end

  # Reads a CSV file of points: the HEAD, then a line for each. Empty lines, and those that begin with #, are left out.
  class List
    HEAD = %w[target_x target_y target_z measured_x measured_y measured_z].freeze
    # Plain decimals below a kilometre: what is greater, in another notation or with a unit is not meant.
    NUMBER = /\A[+-]?\d{1,6}(\.\d{1,12})?\z/

    def self.read(file)
      new(file, File.binread(file)).points
    rescue SystemCallError => e
      raise Refused, "#{file}: #{e.message[/\A[^@]+/].strip}"
    end

    def initialize(file, bytes)
      @file = file
      @text = bytes.force_encoding('UTF-8').delete_prefix("\uFEFF")
    end

    # @satisfies SWR-POINTS-001
    def points
      refuse(1, 'this is not text in UTF-8') unless @text.valid_encoding?
      head, *rows = lines
      refuse(1, "the first line has to be #{HEAD.join(',')}") unless head && head.first == HEAD
      refuse(head.last, 'there is no point below') if rows.empty?
      rows.map { |fields, line| point(fields, line) }
    end

    private

    # The fields of each line that counts, with its number.
    def lines
      @text.lines(chomp: true).each.with_index(1).filter_map do |text, line|
        [text.split(',', -1).map(&:strip), line] unless text.match?(/\A\s*(#|\z)/)
      end
    end

    def point(fields, line)
      refuse(line, "#{fields.size} fields instead of #{HEAD.size}; decimals have a point") if fields.size != HEAD.size
      HEAD.zip(fields) do |name, field|
        refuse(line, "#{name} is #{field.inspect}, no number of mm") unless field.match?(NUMBER)
      end
      Point.new(*fields.map(&:to_f).each_slice(3).map { |values| Vector[*values] })
    end

    def refuse(line, reason)
      raise Refused, "#{@file}:#{line}: #{reason}"
    end
  end
end
