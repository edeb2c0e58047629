# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: a field of the snapshot is one line in core/interface/snapshot.yml, and the line that fills it.
# Nothing else is written, and it comes out of the C, the JSON, the console's types, the table of the replay, what it
# calls a field that differs, and the manual.

require 'fileutils'
require 'json'
require 'minitest/autorun'
require 'open3'
require 'tmpdir'

class TestInterfaceField < Minitest::Test
  ROOT = File.expand_path('../../..', __dir__)
  # The line, and where.
  LINE = '      - {name: shake_ticks, type: int32, says: "How far it trembles.", shown: axis, column: {place: 7}}'
  BEFORE = "      - {name: drive_direction,"
  # The line that fills it, and where.
  FILLED = '    shown->shake_ticks = (int32_t)index + 40;'
  AFTER = 'shown->power = (uint32_t)axis->chart.power;'

  MAIN = <<~CODE
    #include "base/contract.h"
    #include "controller/controller.h"
    #include "http/view/telemetry_json.h"
    #include "replay/verify/field_name.h"
    #include "replay/data/table.h"
    #include "robot/robot_neuro.h"
    #include <stdio.h>
    #include <stdlib.h>
    void contract_broken(const char *module, uint32_t id)
    {
        (void)printf("contract %s %u\\n", module, (unsigned)id);
        abort();
    }
    int main(void)
    {
        static controller_t controller;
        static controller_inputs_t inputs;
        static cycle_record_t record = {.kind = CYCLE_RECORD_CYCLE};
        static telemetry_view_t view = {.robot = &robot_neuro};
        controller_init(&controller, &robot_neuro);
        controller_step(&controller, &robot_neuro, &inputs, &record.body.cycle.outputs);
        view.snapshot = record.body.cycle.outputs.snapshot;
        char *json = cJSON_PrintUnformatted(telemetry_json_motors(&view));
        (void)puts(json);
        table_print_names(&robot_neuro);
        table_print_row(&robot_neuro, record.cycle, &record.body.cycle.outputs.snapshot);
        char name[64];
        field_name(fields_snapshot, offsetof(snapshot_t, axes[3].shake_ticks) + 1U, name, sizeof name);
        (void)puts(name);
        return 0;
    }
  CODE

  # Sources that see a snapshot; the rest of the core is in the library.
  SOURCES = %w[core/controller/*.c core/controller/*/*.c app/http/view/{alarm_json,alarms,card_alarms,json_forms,shown,telemetry_json,telemetry_units}.c
               app/common/{axis_terms,clock,drive_terms,event_text,utc_text}.c app/replay/{data/table,verify/field_name}.c
               build/gen/assets/chart_names.c].freeze
  GENERATED = %w[event app/names app/event_words app/messages app/columns app/fields].freeze
  FOLDERS = %w[core app bsp/include build/gen].freeze
  LIBRARY = 'build/gcc/libcore.a'

  def setup
    @folder = Dir.mktmpdir
    copy('core/interface', 'core/robot', 'core/controller', 'requirements', 'docs/user-manual.md')
    change('core/interface/snapshot.yml', BEFORE, "#{LINE}\n#{BEFORE}")
    change('core/controller/show/controller_show.c', AFTER, "#{AFTER}\n#{FILLED}")
    call('ruby', "#{ROOT}/tools/compile/interface_compiler.rb", path('core/interface'),
         "#{ROOT}/build/gen/charts/charts.json", path('interface'))
  end

  def teardown
    FileUtils.rm_rf(@folder)
  end

  def test_SWR_TOOL_011_a_snapshot_field_is_one_line_and_the_line_that_fills_it
    json, names, row, field = run_controller
    shakes = JSON.parse(json).fetch('axes').map { |axis| axis.fetch('shake_ticks') }
    assert_equal (40..46).to_a, shakes
    assert_equal 'axes[3].shake_ticks', field
    values = names.split(',').zip(row.split(','))
    assert_equal shakes.map(&:to_s), values.select { |name, _| name.end_with?('_shake_ticks') }.map(&:last)
    types = read('interface/app/api.ts')[/interface Axis {[^}]*}/]
    assert_includes types, "  /** How far it trembles. */\n  shake_ticks: number;\n"
    assert_includes read('interface/snapshot.h'), "    /** How far it trembles. */\n    int32_t shake_ticks;\n"
    call('ruby', "#{ROOT}/tools/tables.rb", '--root', @folder)
    assert_includes read('docs/user-manual.md'),
                    '| `shake_ticks` | int32_t | How far it trembles. | `axis.shake_ticks` | `shake_ticks` |'
  end

  private

  # Its lines.
  def run_controller
    File.write(path('main.c'), MAIN)
    own = Dir.glob(SOURCES, base: ROOT).map { |file| File.exist?(path(file)) ? path(file) : "#{ROOT}/#{file}" }
    sources = [path('main.c'), *own, *GENERATED.map { |name| path("interface/#{name}.c") }]
    includes = [@folder, *FOLDERS.map { |name| "#{ROOT}/#{name}" }]
    call('make', '--no-print-directory', '-C', ROOT, LIBRARY)
    call('gcc', '-std=c99', '-O0', '-D_GNU_SOURCE', *includes.map { |folder| "-I#{folder}" }, *sources,
         "#{ROOT}/#{LIBRARY}", '-lcjson', '-lm', '-o', path('main'))
    call(path('main')).lines(chomp: true)
  end

  def copy(*files)
    files.each do |file|
      FileUtils.mkdir_p(File.dirname(path(file)))
      FileUtils.cp_r("#{ROOT}/#{file}", path(file))
    end
  end

  def change(file, old, new)
    assert_includes read(file), old
    File.write(path(file), read(file).sub(old) { new })
  end

  def call(*command)
    output, status = Open3.capture2e(*command)
    assert status.success?, output
    output
  end

  def path(file)
    File.join(@folder, file)
  end

  def read(file)
    File.read(path(file), encoding: 'UTF-8')
  end
end
