#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Makes the pictures of the documents as tools/documents/pictures.yml says, and finds what is wrong with them.
#
#   ruby tools/pictures.rb                  one line for each finding, exit 1 if there is any
#   ruby tools/pictures.rb --make [NAME]    makes all, or those of the source whose path contains NAME; "make pictures"

require 'fileutils'
require 'tmpdir'
require 'yaml'

# Pictures, and what makes them.
class Pictures
  FOLDER = 'docs/images'
  LIST = 'tools/documents/pictures.yml'
  SHOWN_IN = %w[README.md docs/*.md docs/decisions/*.md].freeze

  def initialize(root)
    @root = root
    @makers = YAML.safe_load_file(File.join(root, LIST))
  end

  # @satisfies SWR-TOOL-033
  def complaints
    sources = @makers.map { |maker| maker['by'] }
    gone = sources.reject { |file| File.exist?(File.join(@root, file)) }.map { |file| "#{LIST}: there is no #{file}" }
    gone + doubled + (files - made - sources).map { |file| "#{file}: nothing makes it, see #{LIST}" } +
      (made - files).map { |file| "#{LIST}: #{file} is not there" } + (made - shown).map { |file| "#{file}: no document shows it" }
  end

  # Only what a source has made whole takes the place of the old pictures.
  def make(name)
    @makers.select { |maker| maker['by'].include?(name) }.each do |maker|
      Dir.mktmpdir do |folder|
        words, environment = [maker['command'].split, maker['environment'].to_h.to_a.flatten].map { |texts| texts.map { |text| text.sub('FOLDER', folder) } }
        puts "#{maker['by']}: #{maker['pictures'].join(', ')}"
        system(Hash[*environment], *words, chdir: @root) || abort("#{maker['by']} has failed")
        FileUtils.cp(maker['pictures'].map { |picture| File.join(folder, picture) }, File.join(@root, FOLDER))
      end
    end
  end

  private

  def files
    Dir.glob("#{FOLDER}/*", base: @root).sort
  end

  def made
    @makers.flat_map { |maker| maker['pictures'] }.map { |picture| "#{FOLDER}/#{picture}" }
  end

  def doubled
    made.tally.select { |_file, count| count > 1 }.keys.map { |file| "#{LIST}: #{file} is made twice" }
  end

  def shown
    text = Dir.glob(SHOWN_IN, base: @root).map { |file| File.read(File.join(@root, file), encoding: 'UTF-8') }.join
    text.scan(%r{images/[\w-]+\.\w+}).map { |place| "docs/#{place}" }
  end
end

if $PROGRAM_NAME == __FILE__
  pictures = Pictures.new(File.expand_path('..', __dir__))
  if ARGV.first == '--make'
    pictures.make(ARGV.fetch(1, ''))
  else
    complaints = pictures.complaints
    puts complaints
    exit complaints.empty?
  end
end
