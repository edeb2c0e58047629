# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'fileutils'
require 'open3'
require 'tmpdir'

# A copy of what a build reads, with what stays true of the last one, to add something to.
class ProjectCopy
  ROOT = File.expand_path('../..', __dir__)
  COPIED = %w[Makefile app bsp core requirements site statecharts tools verification build/gcc build/gen
              build/build-id build/robots build/board].freeze
  # Nothing that is built there reads it.
  LEFT_OUT = %w[node_modules build/gcc/tests].freeze
  LINKED = %w[.tools app/console/node_modules].freeze

  attr_reader :folder

  # With the times of the files, by which make knows what is up to date.
  def initialize
    @folder = Dir.mktmpdir
    left_out = LEFT_OUT.map { |name| "--exclude=#{name}" }
    text, status = Open3.capture2e("tar -C #{ROOT} #{left_out.join(' ')} -cf - #{COPIED.join(' ')} | tar -C #{@folder} -xf -")
    raise text unless status.success?

    LINKED.each { |name| File.symlink(File.join(ROOT, name), path(name)) }
  end

  def path(name)
    File.join(@folder, name)
  end

  # Output and whether make ended well.
  def make(*words)
    text, status = Open3.capture2e('make', '-C', @folder, "BUILD_ID=#{File.read(path('build/build-id')).strip}", '-j2', *words)
    [text, status.success?]
  end

  def remove
    FileUtils.rm_rf(@folder)
  end
end
