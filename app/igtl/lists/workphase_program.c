/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/lists/workphase_program.h"

#include "common/list_terms.h"
#include "igtl/dialect/igtl_units.h"
#include "igtl/lists/workphase_text.h"
#include "limits/requirement_limits.h"
#include "igtl/wire/igtl_packet.h"

#include <float.h>
#include <stddef.h>
#include <string.h>

static bool has_angle(const robot_t *robot)
{
    return program_step_turning_axis(robot) < robot->axis_count;
}

/* A number and its unit. */
static status_t read_number(char **text, const char *unit, double *number)
{
    if (!workphase_text_number(workphase_text_next(text), DBL_MAX, number)) {
        return STATUS_OUT_OF_RANGE;
    }
    return workphase_text_is(workphase_text_next(text), unit) ? STATUS_OK : STATUS_WRONG_UNIT;
}

static status_t read_words(const robot_t *robot, char **text, workphase_item_t *item)
{
    reported_step_t reported = {.has_angle = has_angle(robot)};
    status_t status = read_number(text, "mm", &reported.depth_mm);

    if ((status == STATUS_OK) && reported.has_angle) {
        status = read_number(text, "deg", &reported.angle_deg);
    }
    if (status == STATUS_OK) {
        status = read_number(text, "s", &reported.dwell_s);
    }
    if (status != STATUS_OK) {
        return status;
    }
    const char *gate = workphase_text_next(text);
    reported.is_gated = workphase_text_is(gate, "GATE");
    return (reported.is_gated == (gate != NULL)) ? list_terms_step(robot, &reported, &item->step)
                                                 : STATUS_OUT_OF_RANGE;
}

static const char *form(const robot_t *robot)
{
    return has_angle(robot) ? "PROGRAM STEP 0 12 mm 90 deg 30 s" : "PROGRAM STEP 0 12 mm 30 s";
}

static uint32_t columns(const robot_t *robot)
{
    return has_angle(robot) ? 4U : 3U;
}

static status_t read_row(const robot_t *robot, const igtl_message_t *message, uint32_t index,
                         workphase_item_t *item)
{
    reported_step_t reported = {.has_angle = has_angle(robot)};
    double *const numbers[] = {&reported.depth_mm, &reported.angle_deg, &reported.dwell_s};
    uint32_t at = index * message->columns;
    int32_t gate = 0;
    status_t status = STATUS_OK;

    for (uint32_t i = 0U; (i < 3U) && (status == STATUS_OK); i++) {
        if ((numbers[i] != &reported.angle_deg) || reported.has_angle) {
            status = igtl_units_read_double(message, at, numbers[i]);
            at++;
        }
    }
    if (status == STATUS_OK) {
        status = igtl_units_read_whole(message, at, &gate);
    }
    if ((status == STATUS_OK) && ((gate < 0) || (gate > 1))) {
        status = STATUS_OUT_OF_RANGE;
    }
    reported.is_gated = gate == 1;
    return (status == STATUS_OK) ? list_terms_step(robot, &reported, &item->step) : status;
}

static command_t command_of(const robot_t *robot, uint32_t index, const workphase_item_t *item)
{
    return list_terms_step_command(robot, index, &item->step);
}

static uint32_t index_of(const command_t *command)
{
    return command_as_step(command)->index;
}

static uint32_t sum_with(uint32_t sum, const workphase_item_t *item)
{
    return program_list_crc(sum, &item->step);
}

const workphase_list_t workphase_program = {.number = 1U,
                                            .word = "PROGRAM",
                                            .item = "STEP",
                                            .title = "Step",
                                            .most = LIMIT_PROGRAM_STEPS,
                                            .begin = COMMAND_PROGRAM_BEGIN,
                                            .add = COMMAND_PROGRAM_STEP,
                                            .end = COMMAND_PROGRAM_END,
                                            .run = COMMAND_RUN_PROGRAM,
                                            .form = form,
                                            .read_words = read_words,
                                            .columns = columns,
                                            .read_row = read_row,
                                            .command = command_of,
                                            .index = index_of,
                                            .sum = sum_with};
