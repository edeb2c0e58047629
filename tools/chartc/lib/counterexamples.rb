# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require 'fileutils'
require_relative 'compiled'
require_relative 'output'

module Chart
  # The folder of the counterexample of a refused chart, beside what is made of accepted ones.
  module Counterexamples
    NAME = 'counterexamples'

    module_function

    # The block reads charts and writes into the folder; what a refusal has to show is kept there, until the next time.
    def keep(folder)
      FileUtils.rm_rf(File.join(folder, NAME))
      yield
    rescue Refusal => e
      write(File.join(folder, NAME), e.counterexample) if e.counterexample
      raise
    end

    # Beside the message, which reports the same in words.
    def write(folder, shown)
      files = Compiled.new(shown.document, shown.walk).files
      Output.write(folder, files.merge(shown.file_name => shown.test))
      warn "#{File.join(folder, shown.file_name)}: the list of events as a test of the code beside it, " \
           'which fails as long as that path is open'
    end
  end
end
