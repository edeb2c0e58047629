# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Emits charts. Each line of standard input is a request in JSON: the charts to emit, and a fault: a file of the emitter
# with the text that it has instead, or nothing. Each answer is a line: of each chart [header, source], or why there is
# none. Charts are read and walked once; the emitter, with its fault, is loaded into a process of its own.

require 'json'
require_relative '../lib/read/parser'
require_relative '../lib/walk/walk'

CHART = File.expand_path('../lib', __dir__)
WALKED = Hash.new do |all, request|
  text = File.read(request['file'], encoding: 'UTF-8')
  document = Chart::Parser.parse(request['file'], text, request['limits'], mode: request['mode'].to_sym,
                                                                           extra_events: request['events'])
  all[request] = [document, Chart::Walk.new(document).run]
end

def load_emitter(fault)
  RubyVM::InstructionSequence.define_singleton_method(:load_iseq) do |file|
    fault['file'] == file ? compile(fault['text'], file, file) : nil
  end
  %w[header source].each { |part| require File.join(CHART, 'emit/c', part) }
end

def emit(charts)
  charts.map { |document, walk| [Chart::C::Header.new(document, walk).emit, Chart::C::Source.new(document, walk).emit] }
end

$stdout.sync = true
$stdin.each_line do |line|
  request = JSON.parse(line)
  charts = request['charts'].map { |chart| WALKED[chart] }
  answer = IO.popen('-') do |child|
    next child.read if child

    load_emitter(request['fault'])
    puts JSON.generate(emit(charts))
  rescue ScriptError, StandardError => e
    puts JSON.generate(e.message.lines.first)
  end
  puts answer
end
