/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/mode.h"

/* Which axes must not be driven across a needle that is in. */
typedef enum {
    NEEDLE_HEEDED_BY_NONE = 0,   /* The mode itself takes the needle out first. */
    NEEDLE_HEEDED_BY_ACROSS = 1, /* Those that move it sideways, when they are to be driven. */
    NEEDLE_HEEDED_BY_JOGGED = 2  /* The jogged one, from its arming on. */
} needle_heed_t;

#define IN(workphase) ((uint32_t)1U << (uint32_t)(workphase))

/* What is special about each mode. */
typedef struct {
    uint32_t workphases;  /* Where it runs: IN() bits. */
    bool is_of_workphase; /* A command for that workphase arms it. */
    bool may_be_unhomed;
    needle_heed_t needle;
} mode_row_t;

static const mode_row_t table[MODE_COUNT] = {
    [MODE_NONE] = {0U, false, true, NEEDLE_HEEDED_BY_NONE},
    [MODE_HOMING] = {IN(WORKPHASE_START_UP), true, true, NEEDLE_HEEDED_BY_ACROSS},
    [MODE_MOVE] = {IN(WORKPHASE_MOVE_TO_TARGET), true, false, NEEDLE_HEEDED_BY_NONE},
    [MODE_JOG] = {IN(WORKPHASE_MANUAL), false, true, NEEDLE_HEEDED_BY_JOGGED},
    [MODE_RETRACT] = {IN(WORKPHASE_MOVE_TO_TARGET), false, false, NEEDLE_HEEDED_BY_NONE},
    [MODE_HOME_AXIS] = {IN(WORKPHASE_MANUAL), false, true, NEEDLE_HEEDED_BY_ACROSS},
};

static bool runs_in(uint32_t kind, workphase_t workphase)
{
    return (table[kind].workphases & IN(workphase)) != 0U;
}

mode_kind_t mode_of(workphase_t workphase)
{
    mode_kind_t kind = MODE_NONE;
    for (uint32_t i = 0U; i < MODE_COUNT; i++) {
        if (table[i].is_of_workphase && runs_in(i, workphase)) {
            kind = (mode_kind_t)i;
        }
    }
    return kind;
}

mode_kind_t mode_in(const mode_state_t *self, workphase_t workphase)
{
    const bool is_of_it = (self->kind < MODE_COUNT) && runs_in(self->kind, workphase);
    return is_of_it ? (mode_kind_t)self->kind : MODE_NONE;
}

solution_t mode_judge(mode_kind_t kind, const mode_request_t *request, const robot_t *robot,
                      const axis_t axes[ROBOT_AXIS_MAX])
{
    solution_t result = {.status = STATUS_OK, .axis = 0U, .is_maximum = 0U};
    if (kind == MODE_JOG) {
        result = jog_mode_judge(&request->jog, robot, axes);
    } else if (kind == MODE_HOME_AXIS) {
        result = homing_mode_judge(request->jog.axis, robot, axes);
    } else {
        /* Nothing but the workphase refuses it. */
    }
    return result;
}

void mode_begin(mode_state_t *self, mode_kind_t kind, const mode_request_t *request)
{
    self->kind = (uint32_t)kind;
    self->move = request->move;
    self->jog = request->jog;
    leg_stop(&self->leg);
}

static void run(mode_state_t *self, mode_kind_t kind, const mode_frame_t *frame,
                mode_result_t *result)
{
    switch (kind) {
    case MODE_HOMING:
        homing_mode_step(&self->leg, frame, result);
        break;
    case MODE_MOVE:
        move_mode_step(&self->move, &self->leg, frame, result);
        break;
    case MODE_JOG:
        jog_mode_step(&self->jog, &self->leg, frame, result);
        break;
    case MODE_RETRACT:
        retract_mode_step(&self->leg, frame, result);
        break;
    case MODE_HOME_AXIS:
        homing_mode_step_axis(self->jog.axis, frame, result);
        break;
    case MODE_NONE:
    default:
        /* What was armed is not known any more. */
        mode_rest(frame, result);
        result->progress = MODE_FAILED;
        result->status = STATUS_FAULT_PRESENT;
        break;
    }
}

/* What needs no motion any more is done with or without the pedal. */
static bool is_done_already(const mode_state_t *self, mode_kind_t kind, const mode_frame_t *frame)
{
    return ((kind == MODE_HOMING) && homing_mode_is_done(&self->leg, frame)) ||
           ((kind == MODE_RETRACT) && retract_mode_is_done(frame)) ||
           ((kind == MODE_HOME_AXIS) && homing_mode_is_axis_done(self->jog.axis, frame));
}

void mode_step(mode_state_t *self, const mode_frame_t *frame, mode_result_t *result)
{
    const mode_kind_t kind = mode_in(self, frame->workphase);
    const bool is_done = is_done_already(self, kind, frame);
    mode_clear(result);
    if (frame->is_moving && !is_done) {
        run(self, kind, frame, result);
    } else {
        leg_stop(&self->leg);
        mode_rest(frame, result);
        result->progress = is_done ? MODE_DONE : MODE_RUNNING;
    }
}

void mode_stop(mode_state_t *self, axis_t axes[ROBOT_AXIS_MAX], uint32_t axis_count)
{
    leg_stop(&self->leg);
    for (uint32_t i = 0U; i < axis_count; i++) {
        axis_stop_homing(&axes[i]);
    }
}

bool mode_may_be_unhomed(mode_kind_t kind)
{
    return table[kind].may_be_unhomed;
}

bool mode_heeds_needle(const mode_state_t *self, mode_kind_t kind, const axis_config_t *config,
                       uint32_t index, bool is_requested)
{
    const needle_heed_t needle = table[kind].needle;
    const bool is_across = config->needle_motion == (uint32_t)NEEDLE_ACROSS;
    bool must_heed = false;
    if (needle == NEEDLE_HEEDED_BY_ACROSS) {
        must_heed = is_requested && is_across;
    } else if (needle == NEEDLE_HEEDED_BY_JOGGED) {
        must_heed = self->jog.axis == index;
    } else {
        /* Nothing to heed. */
    }
    return must_heed;
}
