# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'c'

module Interface
  # The columns of the table of boresight-replay.
  #
  # @satisfies SWR-TOOL-011
  class Columns
    FROM = 'core/interface/snapshot.yml'
    SAYS = 'The columns of the table of recorded motion.'
    PRINT = {
      'number' => '(void)printf(",%%lld", (long long)%s);',
      'q8' => '(void)printf(",%%.1f", (double)%s / 256.0);'
    }.freeze

    def initialize(model)
      @model = model
    end

    def files
      @model.structure('snapshot') ? { 'columns.h' => header, 'columns.c' => source } : {}
    end

    private

    def columns(structure)
      @model.structure(structure)&.columns.to_a
    end

    def header
      C.file(SAYS, FROM) + C.guard('columns', <<~CODE)
        #include "interface/snapshot.h"
        #include "robot/robot.h"

        /** Prints the names of the columns, each after a comma. */
        void columns_print_names(const robot_t *robot);

        /** Prints what stands in them, each after a comma. */
        void columns_print(const robot_t *robot, const snapshot_t *snapshot);
      CODE
    end

    def source
      <<~CODE
        #{C.file(SAYS, FROM).chomp}
        #include "columns.h"

        #include "common/drive_terms.h"

        #include <stdio.h>

        void columns_print_names(const robot_t *robot)
        {
        #{columns('snapshot').map { |column| "    (void)printf(\",#{column.name}\");" }.join("\n")}
            for (uint32_t i = 0U; i < robot->axis_count; i++) {
                const char *axis = robot->axes[i].name;
        #{columns('snapshot_axis').map { |column| "        (void)printf(\",%s_#{column.name}\", axis);" }.join("\n")}
            }
        }

        void columns_print(const robot_t *robot, const snapshot_t *snapshot)
        {
        #{columns('snapshot').map { |column| "    #{print(column, 'snapshot')}" }.join("\n")}
            for (uint32_t i = 0U; i < robot->axis_count; i++) {
                const snapshot_axis_t *axis = &snapshot->axes[i];
        #{columns('snapshot_axis').map { |column| "        #{print(column, 'axis')}" }.join("\n")}
            }
        }
      CODE
        .gsub(/{\n\n/, "{\n")
    end

    def print(column, from)
      return '(void)printf(",%.1f", drive_terms_percent(&robot->axes[i], axis));' if column.form == 'output_percent'

      format(PRINT.fetch(column.form), "#{from}->#{column.field.name}")
    end
  end
end
