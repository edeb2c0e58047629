/* SPDX-License-Identifier: Apache-2.0 */
#include "table.h"

#include <stdio.h>

#define CYCLES_PER_S 1000.0
#define SPEED_ONE 256.0 /* q8 */

void table_print_names(const robot_t *robot)
{
    (void)printf("time_s");
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const char *name = robot->axes[i].name;
        (void)printf(",%s_setpoint_ticks,%s_position_ticks,%s_setpoint_ticks_per_s,%s_ticks_per_s",
                     name, name, name, name);
    }
    (void)putchar('\n');
}

void table_print_row(const robot_t *robot, const cycle_record_t *record)
{
    const snapshot_t *snapshot = &record->body.cycle.outputs.snapshot;

    if ((record->kind != CYCLE_RECORD_CYCLE) || ((record->cycle % TABLE_CYCLES) != 0U)) {
        return;
    }
    (void)printf("%.3f", (double)record->cycle / CYCLES_PER_S);
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const snapshot_axis_t *axis = &snapshot->axes[i];
        (void)printf(",%d,%d,%.1f,%.1f", (int)axis->setpoint_ticks, (int)axis->position_ticks,
                     (double)axis->setpoint_speed_ticks_per_s_q8 / SPEED_ONE,
                     (double)axis->speed_ticks_per_s_q8 / SPEED_ONE);
    }
    (void)putchar('\n');
}
