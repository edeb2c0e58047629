# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'json'
require_relative 'refusal'

module Chart
  # The limits that delays may name. values: name => number; owners: name => id of the requirement that states it, or nil
  # where nobody knows.
  Limits = Struct.new(:values, :owners) do
    # Those of a file, a list of {"name", "value", "requirement"} in JSON.
    def self.read(file)
      raise Refusal.new(file, 1, 15, 'the file is missing; generate the limits first') unless File.exist?(file)

      rows = JSON.parse(File.read(file))
      return listless(file) unless rows.is_a?(Array) && rows.all?(Hash)

      rows.each { |limit| check(file, limit) }
      new(*%w[value requirement].map { |part| rows.to_h { |limit| [limit.fetch('name'), limit.fetch(part)] } })
    rescue JSON::ParserError
      raise Refusal.new(file, 1, 15, 'the file is no JSON; remove it, and generate the limits anew')
    rescue KeyError => e
      raise Refusal.new(file, 1, 15, "a limit has no \"#{e.key}\"; remove the file, and generate the limits anew")
    end

    def self.listless(file)
      raise Refusal.new(file, 1, 15, 'the file is no list of limits; remove it, and generate the limits anew')
    end

    def self.check(file, limit)
      return if limit.fetch('value').is_a?(Integer)

      raise Refusal.new(file, 1, 15, "the value of #{limit['name']} is no whole number; correct it")
    end
    private_class_method :listless, :check

    def self.of(limits)
      limits.is_a?(self) ? limits : read(limits)
    end
  end
end
