/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/data/table.h"

#include "common/event_text.h"
#include "interface/app/columns.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"

#include <stdio.h>

#define CYCLES_PER_S (1e6 / LIMIT_CYCLE_US)

void table_print_names(const robot_t *robot)
{
    (void)printf("time_s");
    columns_print_names(robot);
    (void)putchar('\n');
}

void table_print_row(const robot_t *robot, uint32_t cycle, const snapshot_t *snapshot)
{
    if ((cycle % TABLE_CYCLES) != 0U) {
        return;
    }
    (void)printf("%.3f", (double)cycle / CYCLES_PER_S);
    columns_print(robot, snapshot);
    (void)putchar('\n');
}

void table_print_interval_names(void)
{
    (void)printf("time_s,interval_us,longest_stage\n");
}

void table_print_interval(const cycle_record_t *record)
{
    const controller_inputs_t *inputs = &record->body.cycle.inputs;

    if (record->kind == (uint32_t)CYCLE_RECORD_CYCLE) {
        (void)printf("%.3f,%u,%s\n", (double)record->cycle / CYCLES_PER_S,
                     (unsigned)inputs->elapsed_us, loop_stage_name((int32_t)inputs->late_stage));
    }
}

void table_print_events(const robot_t *robot, const cycle_record_t *record)
{
    const controller_outputs_t *outputs = &record->body.cycle.outputs;
    char sentence[EVENT_TEXT_SIZE];

    if (record->kind != CYCLE_RECORD_CYCLE) {
        return;
    }
    for (uint32_t i = 0U; (i < outputs->event_count) && (i < CONTROLLER_EVENTS); i++) {
        const event_t *event = &outputs->events[i];
        event_text_sentence(robot, event, NULL, sentence, sizeof sentence);
        (void)printf("%.3f %u %s %s %s\n", (double)record->cycle / CYCLES_PER_S,
                     (unsigned)event->number, event_severity_name((int32_t)event->severity),
                     event_id_name((int32_t)event->id), sentence);
    }
}
