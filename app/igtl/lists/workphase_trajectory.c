/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/lists/workphase_trajectory.h"

#include "common/list_terms.h"
#include "igtl/dialect/igtl_units.h"
#include "igtl/lists/workphase_text.h"
#include "limits/requirement_limits.h"

/* `time_ms` of a row that is OK otherwise. */
static status_t put_time(int32_t time_ms, trajectory_row_t *row)
{
    row->time_ms = (uint32_t)time_ms;
    return (time_ms >= 0) ? STATUS_OK : STATUS_OUT_OF_RANGE;
}

static status_t read_unit(char **text, const char *unit)
{
    return workphase_text_is(workphase_text_next(text), unit) ? STATUS_OK : STATUS_WRONG_UNIT;
}

/* A whole number of each axis, then what they are. */
static status_t read_axes(const robot_t *robot, char **text, const char *unit, int32_t *numbers)
{
    bool is_one = true;

    for (uint32_t i = 0U; (i < robot->axis_count) && is_one; i++) {
        is_one = workphase_text_whole(workphase_text_next(text), &numbers[i]);
    }
    return is_one ? read_unit(text, unit) : STATUS_OUT_OF_RANGE;
}

static status_t read_words(const robot_t *robot, char **text, workphase_item_t *item)
{
    trajectory_row_t *row = &item->row;
    int32_t time_ms = 0;
    status_t status =
        workphase_text_whole(workphase_text_next(text), &time_ms) ? STATUS_OK : STATUS_OUT_OF_RANGE;

    *row = (trajectory_row_t){.time_ms = 0U};
    status = (status == STATUS_OK) ? read_unit(text, "ms") : status;
    status = (status == STATUS_OK) ? read_axes(robot, text, "ticks", row->ticks) : status;
    status =
        (status == STATUS_OK) ? read_axes(robot, text, "ticks/s", row->speeds_ticks_per_s) : status;
    return (status == STATUS_OK) ? put_time(time_ms, row) : status;
}

static const char *form(const robot_t *robot)
{
    (void)robot;
    return "TRAJECTORY ROW 0 1500 ms, a position for each axis, ticks, a speed for each axis, "
           "ticks/s";
}

static uint32_t columns(const robot_t *robot)
{
    return 1U + (2U * robot->axis_count);
}

static status_t read_row(const robot_t *robot, const igtl_message_t *message, uint32_t index,
                         workphase_item_t *item)
{
    const uint32_t axes = robot->axis_count;
    const uint32_t first = index * message->columns;
    trajectory_row_t *row = &item->row;
    int32_t time_ms = 0;
    status_t status = igtl_units_read_whole(message, first, &time_ms);

    *row = (trajectory_row_t){.time_ms = 0U};
    if (status == STATUS_OK) {
        status = put_time(time_ms, row);
    }
    for (uint32_t i = 0U; (i < axes) && (status == STATUS_OK); i++) {
        status = igtl_units_read_whole(message, first + 1U + i, &row->ticks[i]);
        if (status == STATUS_OK) {
            status =
                igtl_units_read_whole(message, first + 1U + axes + i, &row->speeds_ticks_per_s[i]);
        }
    }
    return status;
}

static command_t command_of(const robot_t *robot, uint32_t index, const workphase_item_t *item)
{
    (void)robot;
    return list_terms_row_command(index, &item->row);
}

static uint32_t index_of(const command_t *command)
{
    return command_as_row(command)->index;
}

static uint32_t sum_with(uint32_t sum, const workphase_item_t *item)
{
    return trajectory_list_crc(sum, &item->row);
}

const workphase_list_t workphase_trajectory = {.number = 0U,
                                               .word = "TRAJECTORY",
                                               .item = "ROW",
                                               .title = "Row",
                                               .most = LIMIT_TRAJECTORY_ROWS,
                                               .begin = COMMAND_LIST_BEGIN,
                                               .add = COMMAND_LIST_ROW,
                                               .end = COMMAND_LIST_END,
                                               .run = COMMAND_RUN_TRAJECTORY,
                                               .form = form,
                                               .read_words = read_words,
                                               .columns = columns,
                                               .read_row = read_row,
                                               .command = command_of,
                                               .index = index_of,
                                               .sum = sum_with};
