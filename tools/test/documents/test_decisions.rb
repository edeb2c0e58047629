# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: a decision of the architecture is a numbered record, and a file, right, table or test that it names and that
# has changed is named.

require 'fileutils'
require 'minitest/autorun'
require 'tmpdir'
require_relative '../../decisions'

class TestDecisions < Minitest::Test
  ROOT = File.expand_path('../../..', __dir__)
  RECORD = <<~MARKDOWN
    # 001: A jog drives its axis only

    **Context.** The others would be corrected (`deadband_ticks`).

    **Decision.** A jog drives no other axis.

    **Consequence.** Motion while off is watched.

    ## Held by

    - `core/mode/jog.c`
    - Rights of IGTL alone: `TARGET`
    - Rights of both: `JOG`,
      `RETRACT`
    - Row `core/interface/modes.yml` `JOG`: `workphases: MANUAL, STOP`
  MARKDOWN
  FILES = {
    'docs/decisions/001-jog.md' => RECORD,
    'docs/architecture.md' => "Jogs are in `core/mode/jog.c`.\n",
    'core/mode/jog.c' => "int deadband_ticks;\n",
    'core/interface/modes.yml' => "values:\n  - {name: JOG, workphases: [MANUAL, STOP]}\n",
    'core/interface/commands.yml' => <<~YAML
      enumerations:
        - name: command_kind
          values:
            - {name: JOG, from: [IGTL, HTTP]}
            - {name: RETRACT, from: [IGTL, HTTP]}
            - {name: TARGET, from: [IGTL]}
    YAML
  }.freeze

  def test_SWR_TOOL_026_the_records_are_true
    assert_empty Decisions.new(ROOT).complaints
  end

  def test_SWR_TOOL_026_a_project_that_is_as_its_records_say_has_no_finding
    assert_empty complaints
  end

  def test_SWR_TOOL_026_a_renamed_file_is_named_in_record_and_page
    assert_equal ['docs/decisions/001-jog.md: there is no core/mode/jog.c', 'docs/architecture.md: line 1: there is no core/mode/jog.c'],
                 complaints('core/mode/jog.c' => nil, 'core/mode/hop.c' => 'int deadband_ticks;')
  end

  def test_SWR_TOOL_026_a_changed_right_is_named_where_it_is_and_where_it_was
    rights = FILES['core/interface/commands.yml'].sub('TARGET, from: [IGTL]', 'TARGET, from: [IGTL, HTTP]')
    assert_equal ['the rights of IGTL alone differ by TARGET', 'the rights of both differ by TARGET'],
                 reasons('core/interface/commands.yml' => rights)
  end

  def test_SWR_TOOL_026_a_changed_row_is_named
    assert_equal ['workphases of JOG in core/interface/modes.yml is MANUAL'],
                 reasons('core/interface/modes.yml' => "- {name: JOG, workphases: [MANUAL]}\n")
    assert_equal ['workphases of JOG in core/interface/modes.yml is not there'], reasons('core/interface/modes.yml' => "- {name: HOP}\n")
  end

  def test_SWR_TOOL_026_a_word_that_no_source_has_is_named_with_its_line
    assert_equal ['line 3: there is no deadband_ticks'], reasons('core/mode/jog.c' => 'int band;')
  end

  def test_SWR_TOOL_026_a_record_is_whole_numbered_and_held
    assert_equal ['it does not consist of Context, Decision, Consequence'],
                 reasons('docs/decisions/001-jog.md' => RECORD.sub('**Decision.**', 'So'))
    assert_equal ['nothing would show that it has changed'], reasons('docs/decisions/001-jog.md' => RECORD[/\A.*?(?=## Held)/m])
    assert_includes complaints('docs/decisions/003-more.md' => RECORD.sub('001', '003')).first, 'numbers are not 001 to 002'
    assert_includes reasons('docs/decisions/001-jog.md' => RECORD.sub('001', '002')), 'its first line is not its number and title'
  end

  private

  def complaints(changes = {})
    Dir.mktmpdir do |root|
      FILES.merge(changes).compact.each do |file, text|
        FileUtils.mkdir_p(File.dirname("#{root}/#{file}"))
        File.write("#{root}/#{file}", text)
      end
      Decisions.new(root).complaints
    end
  end

  def reasons(changes)
    complaints(changes).map { |line| line[/: (.*)/, 1] }
  end
end
