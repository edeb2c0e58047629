# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative '../trace/requirements'

module Robot
  # The limits of the requirements, which robots must keep.
  module Limit
    REQUIREMENTS = File.expand_path('../../requirements', __dir__)

    def self.of(name)
      @values ||= Trace::Requirements.load(REQUIREMENTS).limits.to_h { |limit| [limit.name, Integer(limit.value, 10)] }
      @values.fetch(name)
    end
  end
end
