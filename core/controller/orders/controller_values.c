/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/orders/controller_values.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"

#define COORDINATES 3U
#define MILLION 1000000
#define MILLIONTHS_OF_TURN INT64_C(360000000)
#define BAM_OF_TURN INT64_C(4294967296)
/* The first of nine, which lie as the rows do. */
#define ROTATION_OF_REGISTRATION ((uint32_t)PLAN_ROTATION_REGISTRATION_XX)
#define ROTATION_OF_TARGET ((uint32_t)PLAN_ROTATION_TARGET_XX)

/* `first`: its x. */
static void note_place(controller_t *self, const cycle_t *cycle, plan_place_t first,
                       const point_t *point)
{
    const int32_t values_nm[COORDINATES] = {point->x_nm, point->y_nm, point->z_nm};
    for (uint32_t i = 0U; i < COORDINATES; i++) {
        controller_note(self, cycle, EVENT_SENT_PLACE, (uint32_t)first + i, values_nm[i]);
    }
}

static void note_rotation(controller_t *self, const cycle_t *cycle, uint32_t first,
                          const rigid_t *pose)
{
    for (uint32_t row = 0U; row < COORDINATES; row++) {
        for (uint32_t column = 0U; column < COORDINATES; column++) {
            controller_note(self, cycle, EVENT_SENT_ROTATION, first + (row * COORDINATES) + column,
                            fixed_multiply_q30(MILLION, pose->rotation_q30[row][column]));
        }
    }
}

/* Lengths of a refused probe; those of an accepted one are noted with it. */
static void note_lengths(controller_t *self, const cycle_t *cycle, const command_t *command)
{
    const command_probe_t *const sent = command_as_probe(command);
    for (uint32_t i = 0U; (i < sent->count) && (i < ROBOT_PROBE_LENGTHS); i++) {
        controller_note(self, cycle, EVENT_REFUSED_LENGTH, i, sent->lengths_nm[i]);
    }
}

static void note_sent_values(controller_t *self, const cycle_t *cycle, const command_t *command,
                             const answer_t *answer)
{
    const bool is_refused = answer->kind == (uint32_t)ANSWER_REFUSED;
    switch (command->kind) {
    case (uint32_t)COMMAND_REGISTRATION:
        note_place(self, cycle, PLAN_PLACE_REGISTRATION_X,
                   &command_as_registration(command)->pose.translation);
        note_rotation(self, cycle, ROTATION_OF_REGISTRATION,
                      &command_as_registration(command)->pose);
        break;
    case (uint32_t)COMMAND_TARGET:
        note_place(self, cycle, PLAN_PLACE_TARGET_X, &command_as_pose(command)->pose.translation);
        note_rotation(self, cycle, ROTATION_OF_TARGET, &command_as_pose(command)->pose);
        break;
    case (uint32_t)COMMAND_ENTRY:
        note_place(self, cycle, PLAN_PLACE_ENTRY_X, &command_as_pose(command)->pose.translation);
        break;
    case (uint32_t)COMMAND_ACCEPT_ENTRY:
        if (self->plan.has_proposed_entry != 0U) {
            note_place(self, cycle, PLAN_PLACE_ENTRY_X, &self->plan.proposed_entry);
        }
        break;
    case (uint32_t)COMMAND_PROBE:
        if (is_refused) {
            note_lengths(self, cycle, command);
        }
        break;
    default:
        break;
    }
}

static void note_limit(controller_t *self, const cycle_t *cycle, const answer_t *answer)
{
    if (answer->status == (uint32_t)STATUS_AXIS_LIMIT) {
        const answer_limit_t *const limit = answer_as_limit(answer);
        const axis_config_t *axis = &cycle->robot->axes[limit->axis];
        const bool is_maximum = limit->is_maximum != 0U;
        controller_note(self, cycle, is_maximum ? EVENT_UPPER_LIMIT : EVENT_LOWER_LIMIT,
                        limit->axis, is_maximum ? axis->maximum_ticks : axis->minimum_ticks);
    }
}

/* In nm, or millionths of a degree. */
static int32_t value_of_end(const coupled_limit_t *limit, bool is_maximum)
{
    const int32_t end = is_maximum ? limit->maximum : limit->minimum;
    const bool is_angle = limit->unit != (uint8_t)AXIS_UNIT_MM;
    return is_angle ? (int32_t)(((int64_t)end * MILLIONTHS_OF_TURN) / BAM_OF_TURN) : end;
}

static void note_end(controller_t *self, const cycle_t *cycle, const coupled_limit_t *limit,
                     bool is_maximum)
{
    const bool is_length = limit->unit == (uint8_t)AXIS_UNIT_MM;
    const event_id_t upper = is_length ? EVENT_SHARED_UPPER_LIMIT : EVENT_SHARED_UPPER_ANGLE;
    const event_id_t lower = is_length ? EVENT_SHARED_LOWER_LIMIT : EVENT_SHARED_LOWER_ANGLE;
    controller_note(self, cycle, is_maximum ? upper : lower, limit->refusal,
                    value_of_end(limit, is_maximum));
}

/* A robot has fewer than there are places; those without one refuse with STATUS_OK. */
static void note_shared_limit(controller_t *self, const cycle_t *cycle, const answer_t *answer)
{
    if (answer_form(answer) != ANSWER_FORM_SHARED_LIMIT) {
        return;
    }
    const bool is_maximum = answer_as_shared_limit(answer)->is_maximum != 0U;
    for (uint32_t i = 0U; i < ROBOT_COUPLED_LIMITS; i++) {
        const coupled_limit_t *const limit = &cycle->robot->coupled_limits[i];
        if (answer->status == (uint32_t)limit->refusal) {
            note_end(self, cycle, limit, is_maximum);
        }
    }
}

/* Any peer may send numbers that are refused, as often as it likes. */
static bool is_time(controller_t *self)
{
    const bool is_one = (self->sealed.cycle - self->refused_cycle) >= LIMIT_REFUSED_VALUES_MS;
    self->refused_cycle = is_one ? self->sealed.cycle : self->refused_cycle;
    return is_one;
}

void controller_note_values(controller_t *self, const cycle_t *cycle, const command_t *command,
                            const answer_t *answer)
{
    if (answer->kind == (uint32_t)ANSWER_ACCEPTED) {
        note_sent_values(self, cycle, command, answer);
    } else if (is_time(self)) {
        note_sent_values(self, cycle, command, answer);
        note_limit(self, cycle, answer);
        note_shared_limit(self, cycle, answer);
    } else {
        /* Its refusal alone is noted. */
    }
}
