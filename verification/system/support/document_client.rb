# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'json'
require 'net/http'

# A client that knows of the server what its document says, and nothing else: operations by their names, where their parts go,
# and which answers there are. One page.
class DocumentClient
  Answer = Struct.new(:code, :body)

  # The document does not describe what was asked, or what came.
  class Undescribed < StandardError; end

  def initialize(url)
    @uri = URI(url)
    @marks = { 'X-Boresight-Page' => rand(1..0xFFFFFFFF).to_s }
    @document = JSON.parse(send_request(Net::HTTP::Get.new('/api/v1/openapi.json')).body)
    @id = 0
  end

  # Asks for the operation of this name. `values` fill its path, its query and, the rest, its body; an act gets its id.
  def call(name, **values)
    path, method, operation = find(name)
    values = { id: @id += 1 }.merge(values) if body_of(operation)&.dig('properties', 'id')
    answer(operation, send_request(request(path, method, operation, values.transform_keys(&:to_s))))
  end

  # The last id that was used.
  attr_reader :id

  # Sets the token that a login has given.
  def log_in(**values)
    call('login', **values).tap { |answer| @marks['X-Boresight-Token'] = answer.body['token'] }
  end

  private

  def find(name)
    @document['paths'].each do |path, methods|
      methods.each { |method, operation| return [path, method, operation] if operation['operationId'] == name }
    end
    raise Undescribed, "there is no operation #{name}"
  end

  def resolve(schema)
    schema && schema['$ref'] ? @document.dig(*schema['$ref'].delete_prefix('#/').split('/')) : schema
  end

  def body_of(operation)
    resolve(operation.dig('requestBody', 'content')&.values&.first&.fetch('schema'))
  end

  def request(path, method, operation, values)
    parameters = operation.fetch('parameters', [])
    filled = path.gsub(/\{(\w+)\}/) { values.delete(Regexp.last_match(1)) }
    message = Net::HTTP.const_get(method.capitalize).new(filled, headers(parameters))
    add_body(message, operation, values)
    message
  end

  def headers(parameters)
    needed = parameters.select { |one| one['in'] == 'header' && one['required'] }.map { |one| one['name'] }
    @marks.slice(*needed).merge('Cookie' => @cookie).compact
  end

  def add_body(message, operation, values)
    schema = body_of(operation)
    strange = values.keys - (schema ? schema['properties'].keys : [])
    raise Undescribed, "#{operation['operationId']} takes no #{strange.join(', ')}" unless strange.empty?
    return unless schema

    message.content_type = operation.dig('requestBody', 'content').keys.first.sub('*/*', 'application/json')
    message.body = JSON.generate(values)
  end

  def answer(operation, response)
    raise Undescribed, "#{operation['operationId']} answers #{response.code}" unless operation['responses'].key?(response.code)

    Answer.new(response.code.to_i, JSON.parse(response.body))
  end

  def send_request(message)
    Net::HTTP.start(@uri.host, @uri.port) { |http| http.request(message) }.tap do |response|
      @cookie = response['Set-Cookie'].split(';').first if response['Set-Cookie']
    end
  end
end
