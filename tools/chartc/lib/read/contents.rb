# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative '../model'
require_relative 'timers'

module Chart
  # What transitions, entries, exits and defaults do, in the order of execution: the actions of bs:do, then the
  # children.
  class Contents
    def initialize(context, timers, data, conditions)
      @context = context
      @timers = timers
      @data = data
      @conditions = conditions
    end

    def read(element)
      actions = @context.names(element.attributes['bs:do'], element.line)
      actions.map { |name| Act.new(name, element.line) } + element.children.filter_map { |child| step(child) }
    end

    private

    def step(element)
      case element.name
      when 'raise' then raised(element)
      when 'send' then Timers.delayed?(element) ? Send.new(@timers.of(element), element.line) : internal(element)
      when 'cancel' then Cancel.new(timer(element), element.line)
      when 'assign' then assign(element)
      end
    end

    def raised(element)
      Raise.new(@context.name(element.attributes['event'], element.line), element.line)
    end

    def internal(element)
      stray = (element.attributes.keys & %w[delay delayexpr id bs:limit bs:kind]).first
      @context.refuse(element.line, 3, "a send to #_internal has no #{stray}; remove it") if stray
      raised(element)
    end

    def timer(element)
      id = element.attributes['sendid']
      @timers.find(id) || @context.refuse(element.line, 12, "nothing sends \"#{id}\"; " \
                                                            "#{@context.choice(@timers.all.map(&:id))}")
    end

    def assign(element)
      name = element.attributes['location']
      variable = @data.find(name)
      unless variable && variable.kind != :input
        @context.refuse(element.line, 14, "\"#{name}\" is no data of the chart; #{@context.choice(@data.names)}")
      end
      Assign.new(variable, @conditions.assigned(element.attributes['expr'], element.line, variable), element.line)
    end
  end
end
