# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'c'
require_relative 'node'

module Interface
  # The columns of a status: the code by which OpenIGTLink reports it, and of which refused commands it names the axis.
  #
  # @satisfies SWR-TOOL-071
  class Statuses
    KEYS = %w[igtl_code names_axis refuses ends given_by].freeze
    # Those of the protocol that a refusal may have.
    CODES = %w[OK ACCESS_DENIED BUSY TIME_OUT CONFIG_ERROR UNKNOWN_INSTRUCTION NOT_READY].freeze
    # That of a number which is no status.
    UNKNOWN = 'NOT_READY'
    # Those that give a status which the core does not give.
    GIVERS = %w[processes].freeze
    # Instead of a list of commands.
    ANY = 'any'
    FROM = 'core/interface/status.yml'
    NAME = 'status'

    # `commands`: names of command kinds; ANY; nil: no axis is named.
    Row = Struct.new(:value, :code, :commands, keyword_init: true)

    def initialize(model)
      @model = model
      @statuses = model.enumeration(NAME)
      refuse_elsewhere
      @rows = @statuses.values.map { |value| row(value) }
    end

    # For the processes.
    class Files
      def initialize(model)
        @statuses = model.statuses
      end

      def files
        @statuses ? @statuses.files : {}
      end
    end

    def files
      { 'igtl_codes.h' => codes_header, 'igtl_codes.c' => codes_source }
    end

    # The commands of which a refusal with `status` names the axis: their names; ANY; nil: none.
    def named(status)
      @rows.find { |row| row.value == status }.commands
    end

    # Whether the core gives it.
    #
    # @satisfies SWR-TOOL-481
    def of_core?(status)
      status.more['given_by']&.choice(GIVERS).nil?
    end

    private

    def refuse_elsewhere
      @model.enumerations.reject { |one| one.name == NAME }.flat_map(&:values).each do |value|
        key = (value.more.keys & KEYS).first
        value.node.refuse("has #{key}, but is no status") if key
      end
    end

    def row(value)
      nodes = value.more
      value.node.refuse('has no igtl_code') unless nodes.key?('igtl_code')
      Row.new(value: value, code: nodes['igtl_code'].choice(CODES), commands: commands(nodes['names_axis']))
    end

    def commands(node)
      return unless node
      return node.choice([ANY]) unless node.list?

      kinds = @model.enumeration('command_kind')&.values.to_a.map(&:name)
      node.sequence.map { |one| one.choice(kinds) }
    end

    def codes_header
      C.file('The codes by which OpenIGTLink reports refusals.', FROM) + C.guard('igtl_codes', <<~CODE)
        #include "interface/status.h"

        #include <stdint.h>

        /** The igtl_status_code_t of a status; that of #{UNKNOWN} if it is none. */
        uint32_t igtl_reason_code(status_t status);
      CODE
    end

    def codes_source
      cases = @rows.reject { |row| row.code == UNKNOWN }.group_by(&:code)
                   .map { |code, rows| "#{labels(rows)}        return IGTL_STATUS_#{code};\n" }
      <<~CODE
        #{C.file('The codes by which OpenIGTLink reports refusals.', FROM).chomp}
        #include "igtl_codes.h"

        #include "igtl/wire/igtl_codec.h"

        uint32_t igtl_reason_code(status_t status)
        {
            switch ((int)status) {
        #{cases.join}    default:
                return IGTL_STATUS_#{UNKNOWN};
            }
        }
      CODE
    end

    def labels(rows)
      rows.map { |row| "    case #{@statuses.constant(row.value)}:\n" }.join
    end
  end
end
