# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# Emits charts with the compiler that stands in a folder: ruby emit.rb FOLDER, from and to JSON. Each chart comes as
# [header, source] in the shape that the emitter prefers and in the staged one.

require 'json'

%w[read/parser walk/walk emit/c/header emit/c/source].each { |part| require File.join(ARGV.fetch(0), part) }

answers = JSON.parse($stdin.read).map do |chart|
  text = File.read(chart['file'], encoding: 'UTF-8')
  document = Chart::Parser.parse(chart['file'], text, chart['limits'], mode: chart['mode'].to_sym,
                                                                       extra_events: chart['events'])
  walk = Chart::Walk.new(document).run
  [nil, :staged].map do |shape|
    [Chart::C::Header.new(document, walk).emit, Chart::C::Source.new(document, walk, shape: shape).emit]
  end
end
puts JSON.generate(answers)
