# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'fileutils'
require 'json'
require 'open3'
require 'rbconfig'
require 'tmpdir'

module Faults
  # A fault of the list that cannot be judged: it fits no longer, changes nothing, or ends the emitter.
  class Unfit < StandardError; end

  # The C of one chart in one shape.
  Code = Struct.new(:header, :source) do
    def shape
      source.include?('_claim(') ? :staged : :direct
    end
  end

  # The emitter as it stands, or a copy with a fault in it, run in a process of its own.
  class Emitter
    FOLDER = File.expand_path('../../tools/chart', __dir__)
    PROGRAM = File.join(__dir__, 'emit.rb')
    # What makes C. The rest reads charts and interprets them; it is what the emitter is measured by.
    PARTS = %w[flatten/ emit/c/].freeze

    def self.with(fault)
      Dir.mktmpdir('fault') do |folder|
        FileUtils.cp_r(File.join(FOLDER, '.'), folder)
        seed(folder, fault)
        yield new(folder)
      end
    end

    def self.seed(folder, fault)
      raise Unfit, "#{fault.file} is no part of the emitter" unless fault.file.start_with?(*PARTS)

      file = File.join(folder, fault.file)
      text = File.read(file, encoding: 'UTF-8')
      found = text.scan(fault.from).length
      raise Unfit, "its place stands #{found} times in #{fault.file}" unless found == 1

      File.write(file, text.sub(fault.from) { fault.to })
    end
    private_class_method :seed

    def initialize(folder = FOLDER)
      @folder = folder
    end

    # The different versions of each chart.
    def emit(charts)
      output, errors, status = Open3.capture3(RbConfig.ruby, PROGRAM, @folder,
                                              stdin_data: JSON.generate(charts.map(&:request)))
      raise Unfit, "it ends the emitter: #{errors.lines.first}" unless status.success?

      charts.zip(JSON.parse(output)).to_h { |chart, codes| [chart, codes.map { |code| Code.new(*code) }.uniq] }
    end
  end
end
