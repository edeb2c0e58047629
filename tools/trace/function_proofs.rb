# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative '../proof/harness'
require_relative '../proof/proved_list'

module Trace
  # A row for each function of the core and of the charts: how it is proved, by which harnesses under which contracts, and
  # which of its requirements are proved.
  class FunctionProofs
    Row = Struct.new(:file, :function, :proof, :harnesses, :contracts, :proved, :not_proved, keyword_init: true)

    PROVED = /\Aprove_/.freeze

    def initialize(project)
      @project = project
      @list = Proof::ProvedList.read(File.join(project.root, Proof::ProvedList::FILE))
      list = File.join(project.root, Proof::Harness::LIST)
      @harnesses = File.exist?(list) ? Proof::Harness.all(list) : []
    end

    # @satisfies SWR-TOOL-283
    def rows
      @rows ||= @list.states.map { |(file, function), proof| row(file, function, proof) }
    end

    def summary
      @list.summary
    end

    private

    def row(file, function, proof)
      harnesses = harnesses_of(file, function).select { |harness| proof.split.include?(harness.tool) }
      proved, other = requirements_of(file, function).partition { |id| proved_requirements.include?(id) }
      Row.new(file: file, function: function, proof: proof, harnesses: harnesses.map(&:file),
              contracts: harnesses.flat_map(&:contracts).uniq, proved: proved, not_proved: other)
    end

    # A function of a header may be included by any source of a harness.
    def harnesses_of(file, function)
      @harnesses.select { |one| one.functions_proved.include?(function) && (file.end_with?('.h') || one.sources.include?(file)) }
    end

    # Those that stand at its definition or at its declaration in the header of the same name.
    def requirements_of(file, function)
      elements.fetch([stem(file), function], []).map(&:requirement).uniq.sort
    end

    def elements
      @elements ||= @project.sources.elements.group_by { |element| [stem(element.place.file), element.name] }
    end

    def stem(file)
      file.delete_suffix(File.extname(file))
    end

    def proved_requirements
      @proved_requirements ||= @project.sources.tests.map(&:name).grep(PROVED).flat_map { |name| Trace.ids_in(name) }.uniq
    end
  end
end
