/* SPDX-License-Identifier: Apache-2.0 */
/* One cycle of a commanded speed, from any speed that a cycle may leave: what holds after each
 * holds always. Acceleration and speed of the axis are any that the robot compiler accepts. */
#include "prove.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"
#include "motion/ramp.h"

#define CYCLES_PER_S (1000000U / LIMIT_CYCLE_US)
#define FASTEST_Q8 ((int64_t)LIMIT_AXIS_SPEED_MOST_TICKS_PER_S * 256)

/* As velocity_mode.c makes it of the robot's table. */
static int64_t step_of_any_axis(void)
{
    uint32_t acceleration;
    assume((acceleration >= LIMIT_ACCELERATION_LEAST_TICKS_PER_S2) &&
           (acceleration <= LIMIT_ACCELERATION_MOST_TICKS_PER_S2));
    return fixed_divide_by((int64_t)acceleration * 256, CYCLES_PER_S);
}

void prove_SWR_PROFILE_270_a_speed_changes_by_the_acceleration_at_most(void)
{
    int64_t now;
    int64_t most;
    int64_t room;
    const ramp_steps_t steps = {step_of_any_axis(), step_of_any_axis()};
    assume((now >= 0) && (now <= FASTEST_Q8));
    assume((most >= 0) && (most <= FASTEST_Q8));

    const int64_t speed = ramp_next(now, most, &steps, room);

    PROVE((steps.up_q8 >= 1) && (steps.down_q8 >= 1),
          "SWR-PROFILE-270: every accepted acceleration changes the speed");
    PROVE((speed - now) <= steps.up_q8,
          "SWR-PROFILE-270: no faster than the acceleration lets it be");
    PROVE((now - speed) <= steps.down_q8,
          "SWR-PROFILE-270: no slower than the acceleration lets it be");
    PROVE((speed >= 0) && (speed <= FASTEST_Q8), "SWR-PROFILE-270: the next cycle may rely on it");
    PROVE(IMPLIES(now <= most, speed <= most), "SWR-PROFILE-270: never beyond the permitted speed");
    PROVE(IMPLIES(now > most, (speed <= most) || ((now - speed) == steps.down_q8)),
          "SWR-PROFILE-270: above the permitted speed it slows down by a full step");
    POSSIBLE((speed > now) && (speed == most), "the permitted speed is reached");
    POSSIBLE((speed < now) && (now <= most), "a ramp down before the end of the room");
}
