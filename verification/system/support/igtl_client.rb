# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'json'
require 'open3'
require_relative 'boresight'

# `boresight-client`, driven line by line.
class IgtlClient
  # It ended with a sentence.
  class Failed < StandardError; end

  def self.open(port)
    client = new(port)
    yield client
  ensure
    client&.close
  end

  def initialize(port)
    @input, @output, @errors, @thread = Open3.popen3(Boresight.program('boresight-client'), '--port', port.to_s)
    @seen = []
  end

  # Carries out one command; returns the messages that came meanwhile.
  def run(command)
    @input.puts(command)
    messages = []
    until (message = next_line).key?('done')
      messages << message
    end
    @seen.concat(messages)
    messages
  rescue Errno::EPIPE
    raise Failed, @errors.read
  end

  # Sends a workphase and waits for its acknowledgement, in ms.
  def phase(name)
    run("phase #{name}").find { |message| message['type'] == 'ACK' }.fetch('ack_ms')
  end

  # Waits for the next message of this type and name; it may have come before it was waited for.
  def await(type, name)
    run("wait #{type} #{name}")
    @seen.reverse.find { |message| message.values_at('type', 'name') == [type, name] }
  end

  def status(name)
    await('STATUS', name)
  end

  def pid
    @thread.pid
  end

  def close
    @input.close
    @thread.join
  rescue Errno::EPIPE
    nil
  end

  private

  def next_line
    line = @output.gets
    raise Failed, @errors.read unless line

    JSON.parse(line)
  end
end

# Messages made by hand, for peers that the library would not let us play.
module RawIgtl
  module_function

  def message(type, name, body, version: 1, length: body.bytesize, crc: WorkphasePeer.crc64(body))
    [version, type, name, 0, length, crc].pack('na12a20Q>Q>Q>') + body
  end

  def string(name, text)
    message('STRING', name, [3, text.bytesize, text].pack('nna*'))
  end

  def transform(name)
    message('TRANSFORM', name, [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0].pack('g*'))
  end
end
