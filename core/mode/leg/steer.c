/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/leg/steer.h"

#include "base/fixed.h"
#include "motion/curv.h"
#include "motion/ramp.h"
#include "robot/joints.h"
#include "safety/steering_guard.h"

#define TURN_BAM INT64_C(4294967296)
#define COUNT_Q16 65536
/* Beyond the way of a ramp: so many counts stay free at each end. */
#define MARGIN_TICKS 16

uint32_t steer_needle_percent(const mode_frame_t *frame)
{
    const uint32_t cap = frame->speed_cap_percent[frame->robot->needle_axis];
    const uint32_t most = frame->robot->steering.needle_percent;
    return (uint32_t)fixed_within((int64_t)most, 1, (int64_t)cap);
}

void steer_stop(steer_t *self)
{
    self->heading = 0;
    self->rest = 0;
}

static int32_t ticks_of(const axis_config_t *config, int64_t bam)
{
    return fixed_saturate(fixed_divide_signed(bam * COUNT_Q16, config->unit_per_tick_q16));
}

/* In it the set-point comes to rest from its highest speed. */
static int64_t run_out_ticks(const axis_config_t *config)
{
    const int64_t speed = (int64_t)config->speed_ticks_per_s;
    return fixed_divide_signed(speed * speed, 2 * (int64_t)config->acceleration_ticks_per_s2) +
           MARGIN_TICKS;
}

/* Whole turns about the direction, of which the one in the middle is the nearest to the axis that
 * has room for all: one, or as many as the range of the axis holds. */
static void begin(steer_t *self, const axis_config_t *config, const steering_t *steering,
                  int32_t from_ticks)
{
    const int64_t turn = (int64_t)ticks_of(config, TURN_BAM);
    const int64_t low = (int64_t)config->minimum_ticks + run_out_ticks(config);
    const int64_t high = (int64_t)config->maximum_ticks - run_out_ticks(config);
    const int64_t first = (int64_t)ticks_of(config, (int64_t)steering->direction_bam);
    const int64_t near =
        fixed_within((int64_t)from_ticks, low + (turn / 2), high - (turn / 2)) - first;
    int64_t middle = first + (turn * fixed_divide_rounded(near, turn));
    middle += ((middle - (turn / 2)) < low) ? turn : 0;
    middle -= ((middle + (turn / 2)) > high) ? turn : 0;
    int64_t down = middle - (turn / 2);
    int64_t up = middle + (turn / 2);
    if (steering->method == (uint32_t)STEERING_UNIDIRECTIONAL) {
        down -= turn * fixed_divide_signed(fixed_larger(down - low, 0), turn);
        up += turn * fixed_divide_signed(fixed_larger(high - up, 0), turn);
    }
    self->low_ticks = fixed_saturate(down);
    self->high_ticks = fixed_saturate(up);
    self->run_out_ticks = fixed_saturate(run_out_ticks(config));
    self->rest = 0;
    self->heading = 1;
    if (from_ticks >= self->high_ticks) {
        self->heading = -1;
    }
}

/* Speed of the set-point in this cycle; its place does not pass the end that it goes to. */
static int64_t next_q8(const steer_t *self, const steering_t *steering, const mode_frame_t *frame,
                       uint32_t index)
{
    const axis_config_t *const config = &frame->robot->axes[index];
    const axis_t *const axis = &frame->axes[index];
    const int64_t step_q8 =
        fixed_divide_by((int64_t)config->acceleration_ticks_per_s2 * 256, RAMP_CYCLES_PER_S);
    const ramp_steps_t steps = {.up_q8 = step_q8, .down_q8 = step_q8};
    const int64_t place = (int64_t)axis->sealed.setpoint_ticks;
    const int64_t way = (self->heading > 0) ? ((int64_t)self->high_ticks - place)
                                            : (place - (int64_t)self->low_ticks);
    const int64_t law_q8 = curv_speed_q8(config, steering, axis->sealed.setpoint_ticks);
    return ramp_next(fixed_magnitude((int64_t)axis->sealed.setpoint_speed_ticks_per_s_q8),
                     fixed_divide_by(law_q8 * (int64_t)frame->speed_cap_percent[index], 100U),
                     &steps, (way + (int64_t)self->run_out_ticks) * RAMP_TICK);
}

bool steer_step(steer_t *self, const steering_t *steering, const mode_frame_t *frame,
                mode_result_t *result)
{
    const uint32_t index = frame->robot->steering.axis % ROBOT_AXIS_MAX; /* Of a damaged table. */
    axis_t *const axis = &frame->axes[index];
    if (self->heading == 0) {
        (void)axis_rest(axis, frame->elapsed_us);
        begin(self, &frame->robot->axes[index], steering, axis->sealed.encoder.position_ticks);
    }
    const int64_t speed_q8 = (int64_t)self->heading * next_q8(self, steering, frame, index);
    const int32_t place = ramp_place(axis->sealed.setpoint_ticks, speed_q8, &self->rest);
    result->requests[index] =
        axis_follow(axis, &frame->robot->axes[index], place, (int32_t)speed_q8, frame->elapsed_us);
    if (speed_q8 == 0) {
        self->heading = -self->heading;
    }
    return (place >= self->low_ticks) && (place <= self->high_ticks) &&
           steering_guard_follows(steering, frame->robot, frame->axes);
}
