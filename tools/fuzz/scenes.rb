#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Makes of verification/fuzz what the fuzzing targets need: the words as C, and the seeds as bytes.
#
#   ruby tools/fuzz/scenes.rb words WORDS.yml OUT.h
#   ruby tools/fuzz/scenes.rb seeds WORDS.yml SCENES.yml FOLDER
#   ruby tools/fuzz/scenes.rb show WORDS.yml FILE      a scene that was found, in words

require 'fileutils'
require 'shellwords'
require 'yaml'

module Fuzz
  # A sentence for people.
  class Refused < StandardError; end

  # The lists of words.yml: a word is the number of its place.
  class Words
    LISTS = %w[language version checksum name text type order beginning].freeze

    attr_reader :operations, :matrices

    def initialize(file)
      @lists = YAML.safe_load_file(file)
      @operations = @lists.fetch('operations')
      @matrices = @lists.fetch('matrix')
    end

    def list(name)
      @lists.fetch(name)
    end

    def code(list, word)
      return @matrices.keys.index(word) if list == 'matrix'
      return Integer(word, 10) unless LISTS.include?(list)

      list(list).index(word)
    rescue ArgumentError
      nil
    end

    # Word of the list for a byte, as the targets take it.
    def word(list, byte)
      return matrices.keys[byte % matrices.length] if list == 'matrix'

      LISTS.include?(list) ? list(list)[byte % list(list).length].to_s : byte.to_s
    end

    def header
      lines = ['/* Made by tools/fuzz/scenes.rb. */', '#ifndef BORESIGHT_FUZZ_WORDS_H', '#define BORESIGHT_FUZZ_WORDS_H',
               '', '#include <stdint.h>', '']
      lines += enumeration('fuzz_operation', operations.keys) + enumeration('fuzz_beginning', list('beginning'))
      lines += %w[name text type order].flat_map { |name| strings(name, list(name)) }
      [*lines, *floats, '', '#endif', ''].join("\n")
    end

    private

    def enumeration(name, words)
      prefix = name.upcase
      values = words.each_with_index.map { |word, i| "    #{prefix}_#{word.upcase} = #{i}," }
      ['typedef enum {', *values, "} #{name}_t;", "#define #{prefix}S #{words.length}U", '']
    end

    def strings(name, words)
      ["static const char *const fuzz_#{name}s[] = {", *words.map { |word| "    #{word.dump}," }, '};',
       "#define FUZZ_#{name.upcase}S #{words.length}U", '']
    end

    def floats
      rows = matrices.values.map { |row| "    {#{row.map { |number| format('0x%08XU', bits(number)) }.join(', ')}}," }
      ["static const uint32_t fuzz_matrices[][12] = {", *rows, '};', "#define FUZZ_MATRICES #{rows.length}U"]
    end

    def bits(number)
      [number.to_f].pack('g').unpack1('N')
    end
  end

  # One scene as bytes.
  class Scene
    def initialize(words, name, lines)
      @words = words
      @name = name
      @lines = lines
    end

    # @satisfies SWR-TOOL-018
    def bytes
      beginning, *operations = @lines
      [code('beginning', beginning.to_s, beginning), *operations.flat_map { |line| operation(line.to_s) }].pack('C*')
    end

    private

    def operation(line)
      verb, *given = line.start_with?('box ') ? line.split(' ', 2) : Shellwords.split(line)
      wanted = @words.operations[verb] or refuse("has no operation #{verb}", line)
      refuse("lacks #{wanted.drop(given.length).join(', ')}", line) if given.length < wanted.length
      refuse("has more than #{wanted.join(', ')}", line) if given.length > wanted.length && verb != 'bytes'

      rest = given.drop(wanted.length).map { |byte| code('number', byte, line) }
      refuse('does not have as many bytes as it says', line) if verb == 'bytes' && rest.length != given[1].to_i
      [@words.operations.keys.index(verb), *wanted.zip(given).map { |list, word| code(list, word, line) }, *rest]
    end

    def code(list, word, line)
      code = @words.code(list, word)
      refuse("does not know the #{list} #{word.inspect}", line) unless code&.between?(0, 255)
      code
    end

    def refuse(what, line)
      raise Refused, "scene \"#{@name}\": #{what} (#{line})"
    end
  end

  # Bytes as a scene, line by line.
  def self.show(words, bytes)
    lines = [words.word('beginning', bytes.shift || 0)]
    until bytes.empty?
      verb, lists = words.operations.to_a[bytes.shift % words.operations.length]
      given = lists.map { |list| words.word(list, bytes.shift || 0) }
      given += bytes.shift(given.last.to_i).map(&:to_s) if verb == 'bytes'
      lines << [verb, *given.map { |word| verb == 'box' ? word : quoted(word) }].join(' ')
    end
    lines
  end

  # As a scene of words has it: one word, whatever is in it.
  def self.quoted(word)
    Shellwords.split(word) == [word] ? word : "'#{word}'"
  end

  # Streams for the codec: the first byte says whether the checksums are put right, the second how the stream is cut.
  module Streams
    module_function

    def all
      good = [string('CMD_0001', 'START_UP'), transform('CLB_0002'), status, message('GET_STATUS', '', '')]
      { 'messages' => [1, 0] + good.join.bytes, 'pieces' => [1, 37] + good.join.bytes,
        'version_2' => [1, 7] + extended('STRING', 'CMD_0003', text('STOP')).bytes + transform('TGT_0004').bytes,
        'skipped' => [1, 200] + message('IMAGE', 'volume', 'x' * 300).bytes + good.first.bytes,
        'tracking' => [1, 0] + message('STT_TDATA', '', [10].pack('N') + "\0" * 32).bytes +
          message('COMMAND', 'command', [1, 'Status', 3, 6].pack('Na128nN') + 'Status').bytes,
        'point' => [1, 0] + message('POINT', 'target', "\0" * 136).bytes,
        'wrong_checksum' => [0, 0] + good[1].bytes,
        'too_long' => [1, 0] + message('STRING', 'x', text('y' * 5000)).bytes }
    end

    def message(type, name, body, version: 1)
      [version, type, name, 0, body.bytesize, 0].pack('na12a20Q>Q>Q>') + body
    end

    def extended(type, name, content)
      around = [12, 10, 10, 7].pack('nnNN')
      message(type, name, "#{around}#{content}#{[1, 5, 3, 5].pack('nnnN')}dummydummy", version: 2)
    end

    def text(text)
      [3, text.bytesize, text].pack('nna*')
    end

    def string(name, value)
      message('STRING', name, text(value))
    end

    def transform(name)
      message('TRANSFORM', name, [1, 0, 0, 0, 1, 0, 0, 0, 1, 5, 190, 60].pack('g*'))
    end

    def status
      message('STATUS', 'robot', [1, 0, 'OK', ''].pack('nQ>a20a*x'))
    end
  end

  # Files of ports.
  PORTS = { 'listens' => "[slicer]\ndialect = brp-2021\nlisten = 192.168.1.2:18944\nallow = 192.168.1.10, 192.168.7.0/24\n",
            'calls' => "# calls\n[out]\ndialect = brp-2013\nconnect = 127.0.0.1:18945\nentry-prefix = ENTRY_\n",
            'two' => "[a]\ndialect=crtk\nlisten=127.0.0.1:1\n\n[b]\ndialect = crtk\nlisten = 127.0.0.1:65535\n" }.freeze

  # Bodies and queries of requests.
  REQUESTS = { 'body' => '{"name": "a", "workphase": "PLANNING", "point": [1, 2, 3], "rows": [{"depth_mm": 1.5}]}',
               'query' => 'after=3&level=WARNING' }.freeze

  module_function

  def write_seeds(words, scenes, folder)
    FileUtils.mkdir_p(%w[dialect codec ports request].map { |target| "#{folder}/#{target}" })
    PORTS.each { |name, text| File.binwrite("#{folder}/ports/#{name}", text) }
    REQUESTS.each { |name, text| File.binwrite("#{folder}/request/#{name}", text) }
    scenes.each do |name, lines|
      File.binwrite("#{folder}/dialect/#{name.gsub(/\W+/, '_')}", Scene.new(words, name, lines).bytes)
    end
    Streams.all.each { |name, bytes| File.binwrite("#{folder}/codec/#{name}", bytes.pack('C*')) }
  end
end

if $PROGRAM_NAME == __FILE__
  begin
    what, file, *rest = ARGV
    words = Fuzz::Words.new(file)
    case what
    when 'words' then FileUtils.mkdir_p(File.dirname(rest.first)) && File.write(rest.first, words.header)
    when 'show' then puts Fuzz.show(words, File.binread(rest.first).bytes)
    when 'seeds' then Fuzz.write_seeds(words, YAML.safe_load_file(rest.first), rest.last)
    else abort 'usage: scenes.rb words WORDS.yml OUT.h | seeds WORDS.yml SCENES.yml FOLDER'
    end
  rescue Fuzz::Refused => e
    abort e.message
  end
end
