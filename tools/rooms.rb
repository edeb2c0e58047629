#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Holds the includes of the product against tools/rooms.yml: an include names the room that it enters, each room enters
# those alone that it may, no two rooms enter each other, no two files of one room do (a source and its header are one),
# and the refusals of a robot stay in its folder. Neither core nor app names a board or a program of one. No folder holds
# more files than one overlooks.
#
#   ruby tools/rooms.rb [--root FOLDER]     one line for each include or name that must not be, exit 1 if there is any

require 'optparse'
require 'tsort'
require 'yaml'

# The rooms, and which arrows between them are allowed.
#
# @satisfies SWR-TOOL-014
# @satisfies SWR-TOOL-016
# @satisfies SWR-TOOL-075
# @satisfies SWR-TOOL-076
class Rooms
  include TSort

  Room = Struct.new(:folder, :holds, :sees, keyword_init: true) do
    # Beginning of an include of its headers.
    def name
      folder.sub(%r{\A(?:core|app|bsp)/}, '')
    end

    # A header of a folder that it sees, or a single one.
    def sees?(header)
      sees.include?(File.dirname(header)) || sees.include?(header)
    end
  end

  FILE = 'tools/rooms.yml'
  # However it is written: whatever else stands there is not what a room may see.
  BETWEEN = %r{(?:\s|/\*.*?\*/)*}
  INCLUDE = /^#{BETWEEN}(?:\#|%:|\?\?=)#{BETWEEN}include\w*(?<rest>.*)/
  NAMED = /\A\s+"(?<header>[\w\/]+\.h)"/
  OF_THE_SYSTEM = /\A\s+<(?<header>[\w\/.]+)>/

  # Where an include begins.
  ROOTS = %w[core app bsp bsp/include .].freeze

  # Number of files that a reader can overlook, and the places that are counted.
  MOST_FILES = 30
  COUNTED = '{app,bsp,core,docs,requirements,site,statecharts,tools,verification}/**/*'

  # Files that may not name a board.
  TEXTS = '{core,app}/**/*.{c,h,inc,yml}'

  def initialize(root)
    @root = root
    rooms, crowded = YAML.load_stream(File.read(File.join(root, FILE), encoding: 'UTF-8'))
    @crowded = crowded.to_h
    @rooms = rooms.map do |folder, about|
      Room.new(folder: folder, holds: about.fetch('holds'), sees: about.fetch('sees'))
    end
  end

  attr_reader :rooms

  # One line for each thing that is not as it must be.
  def problems
    unknown_folders + circles + circles_of_files + crowded_folders + named_boards +
      files.flat_map { |room, file| wrong_includes(room, file) + strays(file) }
  end

  private

  # The deepest room that holds the file; a robot's tests are none.
  def files
    Dir.glob('{core,bsp,app,site}/**/*.{c,h,inc}', base: @root).grep_v(%r{node_modules/|\Acore/robot/\w+/test/}).sort.map do |file|
      [all_rooms.select { |room| file.start_with?("#{room.folder}/") }.max_by { |room| room.folder.size }, file]
    end
  end

  def all_rooms
    @rooms + unlisted_boards
  end

  # The deepest room whose header it is, or whose folder with a slash.
  def owner(header)
    all_rooms.select { |room| header.start_with?("#{room.name}/") }.max_by { |room| room.name.size }
  end

  def crowded_folders
    counts = Dir.glob(COUNTED, base: @root).grep_v(/node_modules/).select { |file| File.file?(File.join(@root, file)) }
                .map { |file| File.dirname(file) }.tally
    over = counts.select { |_, count| count > MOST_FILES }
    (over.keys - @crowded.keys).sort.map { |folder| "#{folder}: holds #{over[folder]} files, more than #{MOST_FILES}" } +
      (@crowded.keys - over.keys).select { |folder|
        File.directory?(File.join(@root, folder))
      }.sort.map { |folder| "#{FILE}: #{folder} holds at most #{MOST_FILES} files and needs no reason" }
  end

  # A board that needs no more than any board is no entry of the list.
  def unlisted_boards
    @unlisted_boards ||= Dir.glob('bsp/*/board.mk', base: @root).map { |file| File.dirname(file) }.sort
                            .reject { |folder| @rooms.any? { |room| room.folder == folder } }
                            .map { |folder| Room.new(folder: folder, holds: 'a board', sees: ['bsp.h', *@rooms.find { |room| room.folder == 'bsp' }.sees]) }
  end

  def unknown_folders
    files.reject(&:first).map { |_, file| "#{file}: its folder is no room of #{FILE}" }
  end

  def wrong_includes(room, file)
    return [] unless room

    File.foreach(File.join(@root, file)).with_index(1).filter_map do |line, number|
      rest = line[INCLUDE, :rest]
      next if rest.nil? || fine?(room, rest)

      header = rest[NAMED, :header]
      "#{file}:#{number}: #{room.folder} must not include#{rest.chomp}#{' without its room' if header && !header.include?('/')}"
    end
  end

  def fine?(room, rest)
    header = rest[OF_THE_SYSTEM, :header]
    return @rooms.none? { |one| one.name.split('/').first == header.split('/').first } && !header.include?('..') if header

    header = rest[NAMED, :header]
    !header.nil? && (owner(header) == room || room.sees?(header))
  end

  # Each refusal that belongs to one robot alone, with its folder.
  def refusals
    @refusals ||= Dir.glob('core/robot/*/kinematics.yml', base: @root).flat_map do |path|
      own = YAML.safe_load_file(File.join(@root, path))['refusals'] || []
      own.map { |refusal| ["STATUS_#{refusal['name']}", "#{File.dirname(path)}/"] }
    end.to_h
  end

  def strays(file)
    File.foreach(File.join(@root, file), encoding: 'UTF-8').with_index(1).flat_map do |line, number|
      line.scan(/\bSTATUS_\w+/).uniq.filter_map do |status|
        folder = refusals[status]
        "#{file}:#{number}: #{status} belongs to #{folder} alone" if folder && !file.start_with?(folder)
      end
    end
  end

  def named_boards
    names = Regexp.union(boards)
    Dir.glob(TEXTS, base: @root).grep_v(/node_modules/).sort.flat_map do |file|
      File.foreach(File.join(@root, file)).with_index(1).filter_map do |line, number|
        "#{file}:#{number}: names #{line[names]}, which is of a board" if line.match?(names)
      end
    end
  end

  # Their folders, files and names as texts, and their programs.
  def boards
    Dir.glob('bsp/*/board.mk', base: @root).sort.flat_map do |file|
      name = File.basename(File.dirname(file))
      ["bsp/#{name}", "bsp_#{name}", "\"#{name}/", "\"#{name}\"",
       *File.read(File.join(@root, file))[/^BOARD_PROGRAMS\s*:?=(.*)/, 1].to_s.split].map { |word| /#{word}(?!\w)/ }
    end
  end

  def circles
    each_strongly_connected_component.select { |group| group.size > 1 }.map do |group|
      "#{FILE}: #{group.map(&:folder).sort.join(' and ')} see each other"
    end
  end

  def circles_of_files
    each_node = ->(&block) { modules.each_key(&block) }
    each_child = ->(file, &block) { modules[file].each(&block) }
    TSort.each_strongly_connected_component(each_node, each_child).select { |group| group.size > 1 }.map do |group|
      "#{group.min}: includes itself by #{(group - [group.min]).sort.join(' and ')}"
    end
  end

  # Each file without its extension, with those that it includes.
  def modules
    @modules ||= files.map(&:last).group_by { |file| stem(file) }.transform_values do |parts|
      included(parts).uniq - [stem(parts.first)]
    end
  end

  def included(parts)
    parts.flat_map do |file|
      File.foreach(File.join(@root, file)).filter_map { |line| line[INCLUDE, :rest]&.then { |rest| rest[NAMED, :header] } }
    end.filter_map { |header| found(header) }
  end

  def found(header)
    path = ROOTS.map { |folder| folder == '.' ? header : File.join(folder, header) }.find { |one| known[one] }
    path && stem(path)
  end

  def known
    @known ||= files.to_h { |_, file| [file, true] }
  end

  def stem(file)
    file.delete_suffix(File.extname(file))
  end

  def tsort_each_node(&)
    @rooms.each(&)
  end

  def tsort_each_child(room)
    room.sees.each do |seen|
      other = owner(seen.end_with?('.h') ? seen : "#{seen}/")
      yield other if other && other != room
    end
  end
end

if $PROGRAM_NAME == __FILE__
  root = File.expand_path('..', __dir__)
  OptionParser.new { |options| options.on('--root FOLDER') { |folder| root = folder } }.parse!
  problems = Rooms.new(root).problems
  puts problems
  puts 'The rooms see what they may see.' if problems.empty?
  exit(problems.empty? ? 0 : 1)
end
