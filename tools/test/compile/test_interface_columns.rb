# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: the processes do with a value as its columns state, and a wrong column is refused
# with its line.

require 'fileutils'
require 'json'
require 'minitest/autorun'
require 'open3'
require 'stringio'
require 'tmpdir'
require_relative '../../compile/interface_compiler'

class TestInterfaceColumns < Minitest::Test
  STATUS = <<~YAML
    header: status
    says: Why not.
    enumerations:
      - name: status
        says: Why not.
        robots: refusals
        values:
          - {code: 0, name: OK, igtl_code: OK, says: "Done."}
          - {code: 1, name: WET, igtl_code: BUSY, names_axis: any, says: "It is wet."}
          - {code: 2, name: OLD, igtl_code: NOT_READY, names_axis: [WASH], says: "It is old."}
          - {code: 3, name: DRY, igtl_code: BUSY, says: "It is dry."}
  YAML
  COMMAND = <<~YAML
    header: command
    says: What.
    enumerations:
      - name: command_kind
        prefix: COMMAND
        says: What.
        values:
          - {code: 4, name: PAINT, says: "Paint."}
          - {code: 5, name: WASH, says: "Wash."}
  YAML
  ANT = %(refusals:\n  - {code: 9, name: TOO_STEEP, igtl_code: CONFIG_ERROR, names_axis: any, says: "No."}\n)

  # The protocol's numbers, as app/igtl/wire has them.
  CODEC = <<~C
    enum { IGTL_STATUS_OK = 1, IGTL_STATUS_BUSY = 6, IGTL_STATUS_CONFIG_ERROR = 10, IGTL_STATUS_NOT_READY = 13 };
  C

  def test_SWR_TOOL_071_a_status_is_reported_by_the_code_of_its_row
    with_output do |folder|
      assert_equal "13 1 6 13 6 13 10\n", output_of(folder, 'app/igtl_codes.c', <<~C)
        #include "interface/app/igtl_codes.h"
        #include <stdio.h>
        int main(void)
        {
            const int statuses[] = {-1, 0, 1, 2, 3, 4, 9};
            for (int i = 0; i < 7; i++) {
                (void)printf("%u%s", (unsigned)igtl_reason_code((status_t)statuses[i]), (i < 6) ? " " : "\\n");
            }
            return 0;
        }
      C
    end
  end

  def test_SWR_TOOL_071_a_refused_command_names_an_axis_where_the_row_of_the_status_says_so
    in_folder({}) do |folder|
      model = Interface::Model.new(File.join(folder, 'core/interface'))
      named = model.enumeration('status').values.to_h { |status| [status.code, model.statuses.named(status)] }
      assert_equal({ 1 => 'any', 2 => ['WASH'], 9 => 'any' }, named.compact)
    end
  end

  def test_SWR_TOOL_071_a_status_without_code_a_code_and_a_command_that_there_is_not_are_refused
    { [', igtl_code: NOT_READY', ''] => 'has no igtl_code', ['code: NOT_READY', 'code: TIRED'] => 'is TIRED; expected OK',
      ['[WASH]', '[WIPE]'] => 'is WIPE; expected PAINT or WASH', ['[WASH]', 'some'] => 'is some; expected any' }.each do |(old, new), reason|
      message = refusal('status.yml' => STATUS.sub(old, new))
      assert_match(/status\.yml:10: /, message)
      assert_includes message, reason
    end
  end

  def test_SWR_TOOL_071_what_is_no_status_has_no_code
    message = refusal('command.yml' => COMMAND.sub('name: WASH, ', 'name: WASH, igtl_code: OK, '))
    assert_match(/command\.yml:9: /, message)
    assert_includes message, 'has igtl_code, but is no status'
  end

  private

  def with_output(files = {})
    in_folder(files) do |folder|
      text, is_content = run_tool(folder)
      assert is_content, text
      yield File.join(folder, 'out/interface')
    end
  end

  def refusal(files)
    in_folder(files) do |folder|
      text, is_content = run_tool(folder)
      refute is_content
      text
    end
  end

  def in_folder(files)
    Dir.mktmpdir do |folder|
      { 'core/interface/status.yml' => STATUS, 'core/interface/command.yml' => COMMAND,
        'core/robot/ant/kinematics.yml' => ANT, 'charts.json' => JSON.generate('charts' => []),
        'out/igtl/wire/igtl_codec.h' => CODEC }
        .merge(files.transform_keys { |name| "core/interface/#{name}" }).each do |name, text|
        file = File.join(folder, name)
        FileUtils.mkdir_p(File.dirname(file))
        File.write(file, text)
      end
      yield folder
    end
  end

  # Its output, and whether it succeeds.
  def run_tool(folder)
    errors = StringIO.new
    status = Interface::Command.run([File.join(folder, 'core/interface'), File.join(folder, 'charts.json'),
                                     File.join(folder, 'out/interface')], errors: errors)
    [errors.string, status.zero?]
  end

  def output_of(folder, source, main)
    File.write(File.join(folder, 'main.c'), main)
    program = File.join(folder, 'main')
    output, status = Open3.capture2e('gcc', '-std=c99', '-pedantic', '-Wall', '-Wextra', '-Werror', '-Wconversion', '-Wswitch-enum',
                                     '-Wmissing-prototypes', "-I#{File.dirname(folder)}", "-I#{folder}", '-o', program,
                                     *['main.c', source].map { |file| File.join(folder, file) })
    assert status.success?, output
    `#{program}`
  end
end
