# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'c'
require_relative 'node'

module Interface
  # The words by which a peer of the workphase protocol gives a command, of the command's row: a table for the OpenIGTLink
  # process. The text after a word is read by workphase_read_PAYLOAD(); nothing does where the command has none, or `as` says it.
  #
  # @satisfies SWR-TOOL-083
  class IgtlWords
    FROM = 'core/interface'

    def initialize(model)
      @model = model
      @kinds = model.enumeration('command_kind')
    end

    def files
      rows.empty? ? {} : { 'igtl_words.c' => source }
    end

    private

    def rows
      @rows ||= @kinds&.values.to_a.flat_map { |value| value.more['words']&.sequence.to_a.map { |node| row(value, node) } }
    end

    def row(value, node)
      nodes = node.mapping(%w[word], %w[as form])
      payload = @model.commands&.payloads&.of(value)
      node.refuse('has as or form, but its command says nothing more') if payload.nil? && nodes.size > 1
      fields = ["word = #{C.string(nodes['word'].identifier(capitals: true))}", "kind = #{@kinds.constant(value)}"]
      fields << "as.#{payload.name} = {#{said(payload, nodes['as'])}}" if nodes.key?('as')
      fields << "reader = workphase_read_#{payload.name}" if payload && !nodes.key?('as')
      fields << "form = #{C.string(nodes['form'].text)}" if nodes.key?('form')
      "    {.#{fields.join(",\n     .")}},\n"
    end

    def said(payload, node)
      node.all.map { |name, one| ".#{name} = #{constant(payload, name, one)}" }.join(', ')
    end

    def constant(payload, name, node)
      field = payload.structure.fields.find { |one| one.name == name }
      enumeration = field&.type&.enumeration || node.refuse("is no word of #{payload.structure.name}")
      value = enumeration.values.find { |one| one.name == node.choice(enumeration.values.map(&:name)) }
      "(uint32_t)#{enumeration.constant(value)}"
    end

    def source
      <<~CODE
        #{C.file('The words of the workphase protocol that are commands.', FROM).chomp}
        #include "igtl/workphase/workphase_commands.h"

        #include <stddef.h>

        const workphase_command_t workphase_commands[] = {
        #{rows.join}};

        const size_t workphase_command_count = sizeof workphase_commands / sizeof workphase_commands[0];
      CODE
    end
  end
end
