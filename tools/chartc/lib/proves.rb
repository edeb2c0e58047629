# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'optparse'
require_relative 'read/profile'

module Chart
  # Which requirement of the project the tests stand for that every chart gets: kind => id. Those of paths name the
  # requirements of their transitions.
  # @satisfies SWR-CHART-044
  module Proves
    KINDS = %w[behaviour invariants clock damage].freeze

    module_function

    # "KIND=ID,KIND=ID"
    def read(text)
      text.split(',').to_h do |row|
        kind, id = row.split('=', 2)
        raise OptionParser::InvalidArgument, "#{row}: write KIND=ID of #{KINDS.join(', ')}" unless fits?(kind, id)

        [kind.to_sym, id]
      end
    end

    def fits?(kind, id)
      KINDS.include?(kind) && id.to_s.match?(Profile::ID)
    end
    private_class_method :fits?
  end
end
