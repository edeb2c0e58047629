# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'lib/compiled'
require_relative 'lib/emit/promela'
require_relative 'lib/limits'

# The interface of the chart compiler: who uses it from Ruby requires this file, and nothing else of this folder. README.md
# says what stands behind it.
# @satisfies SWR-CHART-035
module Chart
  # A Compiled: document, walk, header, source, tests. Raises the Refusal of a chart that breaks a rule.
  #
  # limits: the path of their file, or Limits. mode: :engine for charts of conformance suites. tree: what to take for the
  # elements of the file. forgiven: numbers of rules that do not refuse the chart.
  def self.compile(file, limits, mode: :product, tree: self.tree(file), forgiven: [])
    limits = Limits.of(limits)
    Compiled.of(document(file, limits, mode: mode, tree: tree), limits.owners, forgiven: forgiven)
  end

  # The elements of a file as a tree that may be changed; text: what to take for its content.
  def self.tree(file, text = File.read(file, encoding: 'UTF-8'))
    XmlReader.read(file, text)
  end

  # What a chart says, neither checked nor walked.
  def self.document(file, limits, mode: :product, tree: self.tree(file))
    Parser.new(Context.new(file, mode, Limits.of(limits).values), []).parse(tree)
  end

  # A document as a model for SPIN, whose steps say what each does.
  def self.promela(document)
    Promela.new(document).emit
  end
end

# What judges compiled charts: compilers and processors, the interpreter's answers to every pair, SCION, SPIN, MISRA, the
# tests that were generated.
autoload :ChartMisra, File.join(__dir__, 'proof/chart_misra')
autoload :CompiledChart, File.join(__dir__, 'proof/compiled_chart')
autoload :GeneratedTest, File.join(__dir__, 'proof/generated_test')
autoload :Pairs, File.join(__dir__, 'proof/pairs')
autoload :Scion, File.join(__dir__, 'proof/scion')
autoload :SpinVerifier, File.join(__dir__, 'proof/spin_verifier')
