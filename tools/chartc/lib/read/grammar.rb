# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'profile'

module Chart
  # Compares the elements of a file with the forms of the profile.
  class Grammar
    def initialize(context)
      @context = context
      @forms = Profile::FORMS.fetch(context.mode)
    end

    def check(root)
      unless root.name == 'scxml'
        @context.refuse(root.line, 2, "<#{root.name}> is not a chart; write <scxml>, xmlns=\"#{XmlReader::SCXML}\"")
      end
      check_element(root, nil)
    end

    private

    def check_element(element, parent)
      form = @forms["#{parent&.name}/#{element.name}"] || @forms.fetch(element.name)
      drop_foreign(element) if @context.lenient?
      drop_unknown(element, form) if @context.mode == :difference
      check_attributes(element, form)
      check_values(element)
      check_children(element, form)
      check_text(element)
    end

    def check_text(element)
      return unless element.text_line

      @context.refuse(element.text_line, 1, "text inside <#{element.name}>; remove it, or make it a comment")
    end

    # Attributes of other namespaces mean nothing to conformance charts.
    def drop_foreign(element)
      element.attributes.reject! { |name, _value| name.include?(':') && !name.match?(/\A(?:bs|xmlns):/) }
      element.attributes.reject! { |name, _value| name.start_with?('xmlns:') && name != 'xmlns:bs' }
    end

    # A version of another time may have said what today's profile has no word for.
    def drop_unknown(element, form)
      element.attributes.select! { |name, _value| (form.required + form.optional).include?(name) }
    end

    def check_attributes(element, form)
      allowed = form.required + form.optional
      unknown = (element.attributes.keys - allowed).first
      if unknown
        list = allowed.empty? ? 'none' : allowed.join(', ')
        @context.refuse(element.line, 3, "<#{element.name}> has no attribute #{unknown}; write #{list}")
      end
      missing = (form.required - element.attributes.keys).first
      return unless missing

      @context.refuse(element.line, 4, "<#{element.name}> lacks #{missing}; add #{missing}=\"...\"")
    end

    def check_values(element)
      Profile::VALUES.fetch(element.name, {}).each do |name, values|
        found = element.attributes.fetch(name, values.first)
        next if values.include?(found)

        rule = element.name == 'scxml' ? 4 : 3
        @context.refuse(element.line, rule, "#{name}=\"#{found}\" is not in the profile; " \
                                            "write #{name}=\"#{values.join('" or "')}\"")
      end
    end

    def check_children(element, form)
      element.children.each do |child|
        check_place(element, child, form)
        check_element(child, element)
      end
    end

    def check_place(element, child, form)
      unless @forms.key?(child.name)
        known = @forms.keys.grep_v(%r{/}).join(', ')
        @context.refuse(child.line, 2, "<#{child.name}> is not in the profile; write one of: #{known}")
      end
      return if form.children.include?(child.name)

      allowed = form.children.empty? ? 'nothing' : form.children.join(', ')
      @context.refuse(child.line, 2, "<#{child.name}> may not stand in <#{element.name}>; write #{allowed} there")
    end
  end
end
