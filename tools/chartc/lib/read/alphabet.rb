# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

module Chart
  # The events of a chart by their concrete names, in order of first appearance, and which of them a transition's
  # "event" means.
  class Alphabet
    attr_reader :names

    def initialize(context, chart, states, extra)
      @context = context
      @extra = extra
      @words = chart.all.flat_map { |element| words(element) }
      @done = states.all.select { |state| can_finish?(state) }.map { |state| "done.state.#{state.id}" }
      @names = (concrete | awaited_done | extra)
      @names = ['any'] if @names.empty? && @words.include?('*')
      @names.freeze
    end

    # What the descriptors of one transition mean.
    def matching(descriptors)
      descriptors.flat_map { |descriptor| @names.select { |name| match?(descriptor, name) } }.uniq
    end

    def include?(name)
      @names.include?(name)
    end

    # Events that only the chart itself causes.
    def internal(declared, timers)
      (@names & (declared + timers.map(&:event) + @done)) - @extra
    end

    private

    def words(element)
      return [] unless %w[transition raise send].include?(element.name)

      found = element.attributes.fetch('event', '').split
      found.each { |word| check(word, element) }
    end

    def check(word, element)
      return if word.match?(@context.lenient? ? Profile::LOOSE_EVENT : Profile::NAME) || word.match?(Profile::DONE)

      @context.refuse(element.line, 6, "\"#{word}\" is no event here; write lower-case words joined by underscores")
    end

    def concrete
      @words.reject { |word| word == '*' }.map { |word| base(word) }.uniq
    end

    def base(descriptor)
      descriptor.delete_suffix('*').delete_suffix('.')
    end

    def match?(descriptor, name)
      descriptor == '*' || base(descriptor) == name || name.start_with?("#{base(descriptor)}.")
    end

    def awaited_done
      @done.select { |name| @words.any? { |word| match?(word, name) } }
    end

    def can_finish?(state)
      case state.kind
      when :compound then state.children.any? { |child| child.kind == :final }
      when :parallel then state.substates.all? { |child| can_finish?(child) }
      end
    end
  end
end
