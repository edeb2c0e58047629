# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'fileutils'
require 'tmpdir'
require_relative '../../misra'

# What cppcheck and its MISRA addon find in the C of one chart, which is a project of its own.
module ChartMisra
  ROOT = File.expand_path('../../..', __dir__)
  COPIED = %w[core/base/*.h verification/misra/*.cfg].freeze
  CHARTS = 'build/gen/charts'
  # The code that has the chart under seal uses a name that the chart's own code does not.
  OWNER = 'core/base/owner.c'

  # name: that of the chart in C.
  def self.findings(name, header, source)
    Dir.mktmpdir('misra') do |folder|
      COPIED.each { |files| copy(files, folder) }
      FileUtils.mkdir_p(File.join(folder, CHARTS))
      File.write(File.join(folder, CHARTS, "#{name}_chart.h"), header)
      File.write(File.join(folder, CHARTS, "#{name}_chart.c"), source)
      File.write(File.join(folder, OWNER), owner(name, header))
      Cppcheck.new(folder).findings.select { |finding| finding.file.start_with?(CHARTS) }
    end
  end

  def self.owner(name, header)
    bytes = header[/#define (\w+_CHART_BYTES)/, 1]
    "#include \"charts/#{name}_chart.h\"\n#include <stddef.h>\nsize_t owner_bytes(void);\nsize_t owner_bytes(void)\n{\n    return #{bytes || 0};\n}\n"
  end
  private_class_method :owner

  def self.copy(files, folder)
    into = File.join(folder, File.dirname(files))
    FileUtils.mkdir_p(into)
    FileUtils.cp(Dir[File.join(ROOT, files)], into)
  end
  private_class_method :copy
end
