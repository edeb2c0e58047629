# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'json'
require 'json_schemer'

# The document that describes the HTTP server, and answers held against it. A member that a schema does not name is not there.
class Openapi
  attr_reader :document

  def initialize(text)
    @document = JSON.parse(text)
    @strict = close(JSON.parse(text))
  end

  def paths
    document.fetch('paths')
  end

  # Faults of an answer, in words; nil: none.
  def fault(path, method, status, type, body)
    answer = paths.dig(path, method.downcase, 'responses', status.to_s)
    return "#{method} #{path} may not answer #{status}" unless answer
    return if answer['content'].nil? && body.to_s.empty?

    media = type.to_s.split(';').first
    return "#{method} #{path} #{status} is of #{media}" unless answer.fetch('content', {}).key?(media)

    schema_fault(answer.dig('content', media, 'schema'), JSON.parse(body)) || code_fault(path, method, status, body)
  end

  # The same for a value of a schema, by its name.
  def message_fault(name, value)
    schema_fault({ '$ref' => "#/components/schemas/#{name}" }, value)
  end

  private

  # A refusal by control has one of the names that the document lists; others stand in its sentences, before a colon.
  def code_fault(path, method, status, body)
    operation = paths.dig(path, method.downcase)
    return unless operation.key?('x-refused') && status.to_s == '409'

    code = JSON.parse(body).fetch('code')
    said = operation.dig('responses', '409', 'description').scan(/\b([A-Z][A-Z_]+):/).flatten
    "#{method} #{path} may not be refused with #{code}" unless (operation['x-refused'] + said).include?(code)
  end

  def schema_fault(schema, value)
    found = JSONSchemer.schema(schema.merge('components' => @strict.fetch('components'))).validate(value).first
    found && "#{found['data_pointer']}: #{found['error']}"
  end

  def close(node)
    case node
    when Hash
      closed = node.transform_values { |value| close(value) }
      node['type'] == 'object' && node['properties'].is_a?(Hash) ? closed.merge('additionalProperties' => false) : closed
    when Array then node.map { |value| close(value) }
    else node
    end
  end
end
