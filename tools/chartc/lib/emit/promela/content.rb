# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'text'
require_relative 'vector'

module Chart
  class Promela
    # Executable content as statements.
    class Content
      def initialize(document, names)
        @document = document
        @names = names
      end

      def statements(content)
        content.flat_map { |one| statement(one) }
      end

      # An event that nobody waits for is none.
      def raising(event)
        @document.events.include?(event) ? ["put(#{@names.event(event)})"] : []
      end

      private

      def statement(content)
        case content
        when Raise then raising(content.event)
        when Send then start(content.timer)
        when Cancel then stop(content.timer)
        when Assign then assign(content)
        when Act then [gather('actions', @document.actions.index(content.name))]
        end
      end

      # A timer that is started or stopped does not expire in this step.
      def start(timer)
        ["#{@names.armed(timer)} = 1", "#{@names.expiring(timer)} = 0",
         gather('started', @document.timers.index(timer))]
      end

      def stop(timer)
        ["#{@names.armed(timer)} = 0", "#{@names.expiring(timer)} = 0",
         forget('started', @document.timers.index(timer))]
      end

      def assign(content)
        variable = content.variable
        name = @names.data(variable)
        return ["#{name} = #{@names.term(content.expression)}"] if variable.kind == :boolean

        ["value = #{@names.term(content.expression)}",
         "assert(#{variable.minimum} <= value && value <= #{variable.maximum})", "#{name} = value"]
      end

      def gather(words, index)
        word, bit = index.divmod(Vector::WORD_BITS)
        "#{words}[#{word}] = #{words}[#{word}] | #{1 << bit}"
      end

      def forget(words, index)
        word, bit = index.divmod(Vector::WORD_BITS)
        "#{words}[#{word}] = #{words}[#{word}] & ~#{1 << bit}"
      end
    end
  end
end
