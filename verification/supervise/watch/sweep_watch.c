/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/watch/sweep_watch.h"

#include "supervise/watch/truth.h"

#include <math.h>

#define WORDS_PER_HZ 22009.0
#define SLOWEST_HZ 55000.0 /* The higher the frequency, the slower. */
#define FASTEST_HZ 45000.0
#define OUT_MM 0.625
#define OUT_SLACK_MM 1.0 /* Way that a broken part may hide. */
#define RUN_US 5000000U
#define RUN_SLACK_US 3000U
#define WAY_SLACK_TICKS 6.0 /* Between where it is and where it is counted. */

static uint32_t rule(sweep_rule_t which, bool is_broken)
{
    return is_broken ? ((uint32_t)1U << (uint32_t)which) : 0U;
}

static bool is_wave_astray(const card_drive_t *drive)
{
    const double hertz = (double)drive->duty / WORDS_PER_HZ;
    return (drive->mode == (uint32_t)CARD_DRIVE_HIGH_FREQUENCY) &&
           ((hertz < FASTEST_HZ) || (hertz > SLOWEST_HZ));
}

static bool are_waves_astray(const rig_t *rig)
{
    bool is_any = false;
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        const card_drive_t drive = rig_sent(rig, i).drive;
        is_any = is_any || is_wave_astray(&drive);
    }
    return is_any;
}

static bool is_out_of_place(const rig_t *rig, const double truth[ROBOT_AXIS_MAX], bool is_disturbed)
{
    const uint32_t along = rig->box.robot->needle_axis;
    const double most = OUT_MM + (is_disturbed ? OUT_SLACK_MM : 0.0);
    return (rig->outputs.snapshot.workphase != (uint32_t)WORKPHASE_MANUAL) ||
           (truth_measure(&rig->box.robot->axes[along], truth[along]) > most);
}

/* The run begins with the first drive after a pause. */
static void follow_run(sweep_watch_t *self, const rig_t *rig, bool is_driven, double at)
{
    if (is_driven) {
        self->from = (self->driven_us == 0U) ? at : self->from;
        self->driven_us += rig->inputs.elapsed_us;
        self->run_us = self->driven_us;
    } else {
        self->driven_us = 0U;
    }
}

static bool is_untrue(const sweep_watch_t *self, double reported, double at, bool is_disturbed)
{
    const bool is_cut = fabs((double)self->run_us - RUN_US) > RUN_SLACK_US;
    return is_cut || (!is_disturbed && (fabs(reported - fabs(at - self->from)) > WAY_SLACK_TICKS));
}

static uint32_t judge_reported(sweep_watch_t *self, const event_t *event, double at,
                               bool is_disturbed)
{
    const bool is_upwards = event->id == (uint32_t)EVENT_SWEEP_UPWARDS;
    if (!is_upwards && (event->id != (uint32_t)EVENT_SWEEP_DOWNWARDS)) {
        return 0U;
    }
    self->upwards += is_upwards ? 1U : 0U;
    self->downwards += is_upwards ? 0U : 1U;
    return rule(SWEEP_RUN, is_untrue(self, (double)event->value, at, is_disturbed));
}

static bool is_done_early(const sweep_watch_t *self, const rig_t *rig)
{
    bool is_early = false;
    for (uint32_t i = 0U; i < rig->outputs.answer_count; i++) {
        const answer_t *const answer = &rig->outputs.answers[i];
        is_early =
            is_early ||
            ((answer->kind == (uint32_t)ANSWER_DONE) &&
             (answer->command == (uint32_t)COMMAND_SWEEP) &&
             (!self->is_over || (self->downwards == 0U) || (self->upwards != self->downwards)));
    }
    return is_early;
}

static uint32_t judge_events(sweep_watch_t *self, const rig_t *rig, double at, bool is_disturbed)
{
    uint32_t broken = 0U;
    for (uint32_t i = 0U; i < rig->outputs.event_count; i++) {
        const event_t *const event = &rig->outputs.events[i];
        if (event->id == (uint32_t)EVENT_SWEEP_BEGUN) {
            *self = (sweep_watch_t){0};
        }
        self->is_over = self->is_over || (event->id == (uint32_t)EVENT_SWEEP_ENDED);
        broken |= judge_reported(self, event, at, is_disturbed);
    }
    return broken | rule(SWEEP_END, is_done_early(self, rig));
}

uint32_t sweep_watch_look(sweep_watch_t *self, const order_watch_t *order, const rig_t *rig,
                          const double truth[ROBOT_AXIS_MAX], bool is_disturbed)
{
    uint32_t broken = rule(SWEEP_WAVES, are_waves_astray(rig));
    if ((order->kind == (uint32_t)COMMAND_SWEEP) &&
        (order->swept_axis < rig->box.robot->axis_count)) {
        const uint32_t axis = order->swept_axis;
        const bool is_driven = rig_sent(rig, axis).drive.mode != (uint32_t)CARD_DRIVE_OFF;
        broken |= judge_events(self, rig, truth[axis], is_disturbed);
        broken |= rule(SWEEP_PLACE, is_driven && is_out_of_place(rig, truth, is_disturbed));
        follow_run(self, rig, is_driven, truth[axis]);
    }
    return broken;
}
