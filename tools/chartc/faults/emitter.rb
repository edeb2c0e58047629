# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'json'
require 'rbconfig'
require_relative 'fault'

module Faults
  # A fault of the list that cannot be judged: it fits no longer, changes nothing, or ends the emitter.
  class Unfit < StandardError; end

  # The C of one chart.
  Code = Struct.new(:header, :source) do
    def shape
      source.include?('_claim(') ? :staged : :direct
    end
  end

  # The emitter as it stands, or with a fault in it.
  class Emitter
    FOLDER = File.expand_path('../lib', __dir__)
    PROGRAM = File.join(__dir__, 'emit.rb')
    # What makes C. The rest reads charts and interprets them; it is what the emitter is measured by.
    PARTS = %w[flatten/ emit/c/].freeze

    # Runs until close.
    def initialize
      @pipe = IO.popen([RbConfig.ruby, PROGRAM], 'r+')
      @lock = Mutex.new
    end

    def close
      @pipe.close
    end

    # The C of each chart.
    def emit(charts, fault = nil)
      request = JSON.generate('charts' => charts.map(&:request), 'fault' => fault ? seeded(fault) : {})
      answer = JSON.parse(@lock.synchronize { @pipe.puts(request) || @pipe.gets })
      raise Unfit, "it ends the emitter: #{answer}" if answer.is_a?(String)

      charts.zip(answer).to_h { |chart, code| [chart, Code.new(*code)] }
    end

    private

    def seeded(fault)
      raise Unfit, "#{fault.file} is no part of the emitter" unless fault.file.start_with?(*PARTS)

      file = File.join(FOLDER, fault.file)
      text = File.read(file, encoding: 'UTF-8')
      found = text.scan(fault.from).length
      raise Unfit, "its place stands #{found} times in #{fault.file}" unless found == 1

      { 'file' => file, 'text' => text.sub(fault.from) { fault.to } }
    end
  end
end
