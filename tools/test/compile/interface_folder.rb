# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'fileutils'
require 'json'
require 'open3'
require 'stringio'
require 'tmpdir'
require_relative '../../compile/interface_compiler'

# A small folder of the interface, and what the compiler makes of it when one of its files is another one.
module InterfaceFolder
  CHARTS = { 'charts' => [{ 'name' => 'lamp', 'regions' => [
    { 'name' => 'state', 'leaves' => [{ 'id' => 'bright', 'value' => 1 }, { 'id' => 'dark', 'value' => 0 }] }
  ] }] }.freeze

  COLOURS = <<~YAML
    header: colour
    says: Colours.
    enumerations:
      - name: colour
        says: Why something was refused.
        values:
          - {code: 0, name: OK, says: "Done."}
          - code: 1
            name: NOT_RED
            says: >-
              It is not "red", but
              another colour.
          - {code: 7, name: LAST, of: axis, says: "The last."}
    structures:
      - name: paint
        says: What is painted with.
        fields:
          - {name: colour, type: colour, says: "Of the paint."}
          - {name: lamp, type: chart lamp.state}
          - {name: rest_ml, type: uint32, says: "Left in the tin."}
          - {name: is_dry, type: flag}
  YAML

  MESSAGES = <<~YAML
    messages:
      - name: tin
        says: A tin of paint.
        members:
          - {name: maker, type: text, or_null: true}
  YAML

  EVENTS = <<~YAML
    header: event
    says: Events.
    enumerations:
      - name: event_severity
        says: How much.
        values:
          - {code: 0, name: LOW, says: "Low."}
          - {code: 1, name: CRITICAL, says: "High."}
      - name: event_cause
        says: Why.
        values:
          - {code: 0, name: NONE, says: "By itself."}
          - {code: 1, name: AXIS, peer: axis, says: "By axis {peer}."}
      - name: event_id
        prefix: EVENT
        says: What.
        count: true
        values:
          - {code: 0, name: SPILT, severity: critical, subject: colour, value: {way: ticks}, says: "{subject} by {value}."}
          - {code: 1, name: DRIED, severity: low, subject: axis, value: {time: [not_yet, at_last]}, says: "{subject} {value}."}
  YAML

  private

  def assert_refused(file, text, old, new, line, reason)
    changed = text.sub(old, new)
    refute_equal text, changed
    message = refusal(file => changed)
    assert_match(/#{file}:#{line}: /, message)
    assert_includes message, reason
  end

  def refusal(files)
    in_folder(files) do |folder, output|
      text, is_content = run_tool(folder, output)
      refute is_content
      text
    end
  end

  def with_output(files = {})
    in_folder(files) do |folder, output|
      text, is_content = run_tool(folder, output)
      assert is_content, text
      yield output
    end
  end

  def in_folder(files)
    Dir.mktmpdir do |core|
      folder = File.join(core, 'interface')
      { 'colours.yml' => COLOURS, 'messages.yml' => MESSAGES, 'events.yml' => EVENTS,
        'charts.json' => JSON.generate(CHARTS) }.merge(files).each do |name, text|
        FileUtils.mkdir_p(File.dirname(File.join(folder, name)))
        File.write(File.join(folder, name), text)
      end
      yield folder, File.join(folder, 'interface')
    end
  end

  # Its output, and whether it succeeds.
  def run_tool(folder, output, *headers)
    errors = StringIO.new
    status = Interface::Command.run([folder, File.join(folder, 'charts.json'), output,
                                     *headers.map { |header| File.join(folder, header) }], errors: errors)
    [errors.string, status.zero?]
  end

  # The number that all processes must have.
  def layout(files = {}, *headers)
    in_folder(files) do |folder, output|
      text, is_content = run_tool(folder, output, *headers)
      assert is_content, text
      File.read(File.join(output, 'interface_layout.h'))[/UINT64_C\(0x(\h{16})\)/, 1]
    end
  end

  def contents(folder)
    Dir[File.join(folder, '**/*.*')].to_h { |file| [file.delete_prefix(folder), File.read(file)] }
  end

  def output_of(folder, *sources)
    program = File.join(folder, 'main')
    output, status = Open3.capture2e('gcc', '-std=c99', '-pedantic', '-Wall', '-Wextra', '-Werror', '-Wconversion',
                                     '-Wmissing-prototypes', "-I#{folder}", "-I#{folder}/app", "-I#{File.dirname(folder)}", '-o',
                                     program,
                                     *sources.map { |source| File.join(folder, source) })
    assert status.success?, output
    `#{program}`
  end
end
