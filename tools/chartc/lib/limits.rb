# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'json'
require_relative 'read/profile'
require_relative 'refusal'

module Chart
  # The limits that delays may name. values: name => number; owners: name => id of the requirement that states it, or nil
  # where nobody knows.
  Limits = Struct.new(:values, :owners) do
    # Those of a file, a list of {"name", "value", "requirement"} in JSON.
    def self.read(file)
      raise Refusal.new(file, 1, 15, 'the file is missing; generate the limits first') unless File.exist?(file)

      text = File.read(file, encoding: 'UTF-8')
      raise JSON::ParserError unless text.valid_encoding?

      rows = JSON.parse(text)
      return listless(file) unless rows.is_a?(Array) && rows.all?(Hash)

      rows.each { |limit| check(file, limit) }
      check_once(file, rows.map { |limit| limit.fetch('name') })
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
      name, value, requirement = %w[name value requirement].map { |part| limit.fetch(part) }
      wrong = if !name.is_a?(String) || !name.match?(Profile::LOOSE_NAME) then "the name #{name.inspect} of a limit is none"
              elsif !value.is_a?(Integer) then "the value of #{name} is no whole number"
              elsif !requirement.is_a?(String) || !requirement.match?(Profile::ID)
                "the requirement of #{name} is no id, as AREA-NAME-nnn"
              end
      raise Refusal.new(file, 1, 15, "#{wrong}; correct it") if wrong
    end

    def self.check_once(file, names)
      twice = names.find { |name| names.count(name) > 1 } || return
      raise Refusal.new(file, 1, 15, "the limit #{twice} stands twice; remove one")
    end
    private_class_method :listless, :check, :check_once

    def self.of(limits)
      limits.is_a?(self) ? limits : read(limits)
    end
  end
end
