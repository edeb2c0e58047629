# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'refusal'

module Chart
  # What may stand in a chart file: elements, attributes, nesting, names.
  module Profile
    Form = Struct.new(:required, :optional, :children)

    FORMS = {
      'scxml' => Form.new(%w[xmlns xmlns:bs version datamodel name initial bs:safe], %w[bs:internal],
                          %w[state parallel datamodel bs:invariant]),
      'parallel' => Form.new(%w[id], [], %w[state]),
      'state' => Form.new(%w[id], %w[initial bs:req], %w[state transition onentry onexit]),
      'transition' => Form.new([], %w[bs:id event target cond type bs:do bs:req], %w[raise]),
      'onentry' => Form.new([], [], %w[send]),
      'onexit' => Form.new([], [], %w[cancel]),
      'raise' => Form.new(%w[event], [], []),
      'send' => Form.new(%w[id event delay bs:limit], [], []),
      'cancel' => Form.new(%w[sendid], [], []),
      'datamodel' => Form.new([], [], %w[data]),
      'data' => Form.new(%w[id expr], [], []),
      'bs:invariant' => Form.new(%w[expr], %w[id bs:req], [])
    }.freeze

    FIXED = {
      'xmlns' => 'http://www.w3.org/2005/07/scxml', 'xmlns:bs' => 'urn:boresight:chart',
      'version' => '1.0', 'datamodel' => 'ecmascript'
    }.freeze

    NAME = /\A[a-z][a-z0-9]*(?:_[a-z0-9]+)*\z/.freeze
    TRANSITION_ID = /\A[A-Z][A-Z0-9]*(?:-[A-Z0-9]+)+\z/.freeze
    REQUIREMENT = /\A[A-Z]+(?:-[A-Z0-9]+)+\z/.freeze

    module_function

    def check(file, element)
      form = FORMS[element.name]
      unless form
        raise Refusal.new(file, element.line, 2,
                          "<#{element.name}> is not in the profile; write one of: #{FORMS.keys.join(', ')}")
      end
      check_attributes(file, element, form)
      check_fixed(file, element) if element.name == 'scxml'
      check_children(file, element, form)
    end

    def check_attributes(file, element, form)
      unknown = element.attributes.keys - form.required - form.optional
      allowed = form.required + form.optional
      unless unknown.empty?
        raise Refusal.new(file, element.line, 3, "<#{element.name}> has no attribute #{unknown.first}; " \
                                                 "write #{allowed.empty? ? 'none' : allowed.join(', ')}")
      end
      missing = form.required - element.attributes.keys
      return if missing.empty?

      raise Refusal.new(file, element.line, 4, "<#{element.name}> lacks #{missing.first}; add #{missing.first}=\"...\"")
    end

    def check_fixed(file, element)
      FIXED.each do |name, value|
        next if element.attributes[name] == value

        raise Refusal.new(file, element.line, 4, "#{name} differs; write #{name}=\"#{value}\"")
      end
    end

    def check_children(file, element, form)
      element.children.each do |child|
        if FORMS.key?(child.name) && !form.children.include?(child.name)
          allowed = form.children.empty? ? 'nothing' : form.children.join(', ')
          raise Refusal.new(file, child.line, 2,
                            "<#{child.name}> may not stand in <#{element.name}>; write #{allowed} there")
        end
        check(file, child)
      end
    end
  end
end
