/* SPDX-License-Identifier: Apache-2.0 */
#include "table.h"

#include "event_text.h"
#include "names.h"
#include "servo.h"

#include <inttypes.h>
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
        (void)printf(",%s_output_percent,%s_permit_reasons", name, name);
    }
    (void)putchar('\n');
}

/* Of the largest drive word, with the sign of the way. */
static double output_percent(const axis_config_t *config, const snapshot_axis_t *axis)
{
    const card_drive_t drive = {axis->drive_mode, axis->drive_direction, axis->drive_duty};
    double percent = 100.0;

    if (drive.mode == (uint32_t)CARD_DRIVE_OFF) {
        return 0.0;
    }
    if (drive.mode == (uint32_t)CARD_DRIVE_PWM) {
        percent = (100.0 * (double)drive.duty) / (double)config->maximum_duty;
    }
    return servo_is_upwards(config, &drive) ? percent : -percent;
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
        (void)printf(",%.1f,%" PRIu32, output_percent(&robot->axes[i], axis), axis->permit_reasons);
    }
    (void)putchar('\n');
}

void table_print_events(const cycle_record_t *record)
{
    const controller_outputs_t *outputs = &record->body.cycle.outputs;
    char sentence[EVENT_TEXT_SIZE];

    if (record->kind != CYCLE_RECORD_CYCLE) {
        return;
    }
    for (uint32_t i = 0U; (i < outputs->event_count) && (i < CONTROLLER_EVENTS); i++) {
        const event_t *event = &outputs->events[i];
        event_text_sentence(event, sentence, sizeof(sentence));
        (void)printf("%.3f %u %s %s %s\n", (double)record->cycle / CYCLES_PER_S,
                     (unsigned)event->number, event_severity_name((int32_t)event->severity),
                     event_id_name((int32_t)event->id), sentence);
    }
}
