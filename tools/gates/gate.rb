# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'yaml'

module Gates
  # A file of gates, or a wish for one, that cannot be followed.
  class Refused < StandardError; end

  # One line of verification/gates.yml; its head says what the fields mean.
  Gate = Struct.new(:name, :says, :run, :seconds, :needs, :cores, :waits, :alone, keyword_init: true) do
    def self.read(file)
      gates = YAML.safe_load_file(file).map do |row|
        new(needs: [], cores: 1, waits: false, alone: false, **row.transform_keys(&:to_sym))
      end
      known = gates.map(&:name)
      gates.each { |gate| refuse(gate.needs - known, known) }
    end

    # Those that are asked for and all that they need, in the order of the file; without a wish, all.
    def self.choose(gates, wanted)
      refuse(wanted - gates.map(&:name), gates.map(&:name))
      return gates if wanted.empty?

      chosen = gates.select { |gate| wanted.include?(gate.name) }
      needed = chosen.flat_map(&:needs) - wanted
      needed.empty? ? chosen : choose(gates, wanted | needed)
    end

    # make refuses an unknown gate too, before there is any ruby.
    #
    # @satisfies SWR-GATE-005
    def self.refuse(unknown, known)
      raise Refused, "unknown gate #{unknown.join(', ')}; there are: #{known.join(', ')}" if unknown.any?
    end

    def log
      "build/log/#{name}.log"
    end
  end
end
