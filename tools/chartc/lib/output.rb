# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'fileutils'
require 'tmpdir'

module Chart
  # Files that come together or not at all: each is written beside its place first.
  module Output
    module_function

    # files: path inside the folder => content. Raises a SystemCallError, and has changed nothing then.
    def write(folder, files)
      places = files.transform_keys { |path| File.join(folder, path) }
      places.each_key { |place| check(place) }
      FileUtils.mkdir_p(folder)
      Dir.mktmpdir('.unfinished-', folder) do |beside|
        written = places.map { |place, content| [written(beside, place, content), place] }
        FileUtils.mkdir_p(places.keys.map { |place| File.dirname(place) })
        written.each { |file, place| File.rename(file, place) }
      end
    end

    # What would stop a rename halfway.
    def check(place)
      raise Errno::EISDIR, place if File.directory?(place)

      around = File.dirname(place)
      around = File.dirname(around) until File.exist?(around)
      raise Errno::ENOTDIR, around unless File.directory?(around)
      raise Errno::EACCES, around unless File.writable?(around)
    end

    def written(beside, place, content)
      file = File.join(beside, File.basename(place))
      File.write(file, content)
      file
    end
    private_class_method :check, :written
  end
end
